#pragma once

#include <stdexcept>
#include <string>

namespace raytracing {

/// A place in a text file. Line and column count from 1; column counts bytes; 0 = not known.
struct TextLocation {
  std::string file;
  long line = 0;
  long column = 0;
};

/// "file:line:column", leaving out what is not known.
std::string to_string(const TextLocation& where);

/// The text with a space in place of each line break and other control character: file names and
/// quoted text may hold them, a message must not.
std::string one_line(std::string text);

/// Bad input (exit code 3). what() is one line, with the place in front where there is one.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
  InputError(const TextLocation& where, const std::string& message);
};

/// An output that could not be written (exit code 4).
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A command line that makes no sense (exit code 2).
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace raytracing
