#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace raytracing {

/// A position in a text: line and byte column, both from 1; 0 = not known.
struct TextPlace {
  long line = 0;
  long column = 0;
};

/// A position in a text file.
struct TextLocation {
  std::string file;
  long line = 0;
  long column = 0;
};

/// "file:line:column", without the parts that are not known.
std::string to_string(const TextLocation& where);

/// The text with a space in place of each line break and other control character: a message stays
/// on one line whatever the file names and quoted text in it contain.
std::string one_line(std::string text);

/// The bytes in quotes for a message: printable ASCII as it is, the rest as \xNN, cut off after 40.
std::string quoted(std::string_view bytes);

/// The candidate with the smallest edit distance (insert, erase, replace one byte) to `name`; the
/// first of equals. `candidates` must not be empty.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// Bad input (exit code 3). what() is one line, headed by the location if there is one.
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

/// An invalid command line (exit code 2).
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace raytracing
