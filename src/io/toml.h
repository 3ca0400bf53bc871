#pragma once
// The only header that includes toml++: reading a TOML document key by key, with every error
// located and every unknown key refused.

#include <toml++/toml.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "raytracing/io/errors.h"
#include "raytracing/math/vec.h"

namespace raytracing {

/// A parsed document together with its text, which locations need: toml++ counts columns in
/// characters, messages in bytes. The text must outlive it.
class TomlDocument {
 public:
  /// Throws InputError (file:line:column) for a syntax error.
  TomlDocument(std::string_view text, std::string file);

  const toml::table& root() const { return root_; }
  const std::string& file() const { return file_; }
  TextLocation location(const toml::source_position& position) const;

 private:
  std::string_view text_;
  std::string file_;
  std::vector<std::size_t> line_starts_;
  toml::table root_;
};

/// The keys that a table must have and those that it may have.
struct TomlKeys {
  std::vector<std::string> required;
  std::vector<std::string> optional;
};

/// A table of a document. Its readers return nothing for an absent key and throw InputError for an
/// invalid value. The document must outlive it.
class TomlTable {
 public:
  /// `name` is the table's dotted name, "" for the root. Throws for unknown and missing keys.
  TomlTable(const TomlDocument& document, const toml::table& table, std::string name,
            const TomlKeys& keys);

  bool has(std::string_view key) const { return table_->contains(key); }
  /// Returns the location of the key's value.
  TextLocation where(std::string_view key) const;
  /// Returns an error located at the key's value: "camera.fov: message".
  InputError error(std::string_view key, const std::string& message) const;

  std::optional<std::string> string(std::string_view key) const;
  /// A string that must be one of `names`; the error lists them and names the nearest.
  std::optional<std::string> one_of(std::string_view key,
                                    const std::vector<std::string>& names) const;
  std::optional<std::int64_t> integer(std::string_view key, std::int64_t lowest,
                                      std::int64_t highest) const;
  /// A number, which may be written as an integer; it is within the range of a float.
  std::optional<double> number(std::string_view key) const;
  std::optional<DVec3> vec3(std::string_view key) const;
  /// Three numbers, or one for three equal ones.
  std::optional<DVec3> number_or_vec3(std::string_view key) const;

  std::optional<TomlTable> table(std::string_view key, const TomlKeys& keys) const;
  /// The tables [[key]], in order; none if absent.
  std::vector<TomlTable> tables(std::string_view key, const TomlKeys& keys) const;
  /// The tables [key.a], [key.b] and so on, with any names, sorted by name; none if absent.
  std::vector<std::pair<std::string, TomlTable>> named_tables(std::string_view key,
                                                              const TomlKeys& keys) const;

 private:
  std::string full_name(std::string_view key) const;
  // These two take the full name of the key.
  InputError type_error(const std::string& name, const toml::node& node,
                        const std::string& expected) const;
  double checked_number(const std::string& name, const toml::node& node,
                        const std::string& expected) const;
  void refuse_unknown(const TomlKeys& keys) const;

  const TomlDocument* document_;
  const toml::table* table_;
  std::string name_;
};

}  // namespace raytracing
