#pragma once
// What is wrong with input and output: errors, and the report of what was read otherwise.

#include <cstdint>
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

/// Returns "file:line:column", without the parts that are not known.
std::string to_string(const TextLocation& where);

/// Returns the text with a space in place of each line break and other control character: a message
/// stays on one line whatever the file names and quoted text in it contain.
std::string one_line(std::string text);

/// Returns the bytes in quotes for a message: printable ASCII as it is, the rest as \xNN, cut off
/// after 40.
std::string quoted(std::string_view bytes);

/// Returns the candidate with the smallest edit distance (insert, erase, replace one byte) to
/// `name`; the first of equals. `candidates` must not be empty.
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

/// Counts, by kind, what loading changed or left out, so that nothing is lost silently.
class LoadReport {
 public:
  enum class Severity {
    repaired,  ///< read as something other than written; an error under --strict
    dropped,   ///< a record that could not contribute was left out; an error under --strict
    ignored,   ///< valid but without use here (lines, texture coordinates, unknown keywords)
    warning,   ///< read as written, but probably not what was meant
  };
  struct Entry {
    Severity severity;
    std::string kind;    ///< for example "face with a repeated corner"
    TextLocation first;  ///< the location of the first event
    std::uint64_t count;
    std::string name;  ///< the name of the first object concerned; "" where the kind says all
  };

  /// Counts an event of this kind; the first location and name are kept.
  void add(Severity severity, std::string_view kind, const TextLocation& where,
           const std::string& name = "");
  /// The same for files with millions of events: only the first one copies the file's name.
  void add(Severity severity, std::string_view kind, const std::string& file, TextPlace place);
  /// Counts an ignored record as "<kind> '<keyword>'". Once there are `most` keywords of this kind,
  /// further ones count together as "other <kind>", so that garbage does not fill the report.
  void add_keyword(const std::string& kind, std::string_view keyword, const std::string& file,
                   TextPlace place, int most);

  const std::vector<Entry>& entries() const { return entries_; }  ///< in order of first appearance
  std::uint64_t count(Severity severity) const;

 private:
  bool count_again(Severity severity, std::string_view kind);

  std::vector<Entry> entries_;
};

/// Returns "repaired", "dropped", "ignored" or "warning".
const char* to_string(LoadReport::Severity severity);

}  // namespace raytracing
