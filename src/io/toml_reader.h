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

/// A parsed document, kept together with its text to turn toml++'s columns into bytes. The text
/// must live longer.
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

/// The keys that a table must and may have.
struct TomlKeys {
  std::vector<std::string> required;
  std::vector<std::string> optional;
};

/// One table. Readers give no value for an absent key and throw InputError for a wrong one. The
/// document must live longer.
class TomlTable {
 public:
  /// `name` is the table's dotted name, "" for the root. Throws for unknown and missing keys.
  TomlTable(const TomlDocument& document, const toml::table& table, std::string name,
            const TomlKeys& keys);

  bool has(std::string_view key) const { return table_->contains(key); }
  /// Of the key's value.
  TextLocation where(std::string_view key) const;
  /// An error located at the key's value: "camera.fov: message".
  InputError error(std::string_view key, const std::string& message) const;

  std::optional<std::string> string(std::string_view key) const;
  /// A string that must be one of `names`; the error lists them and tells the nearest.
  std::optional<std::string> one_of(std::string_view key,
                                    const std::vector<std::string>& names) const;
  std::optional<std::int64_t> integer(std::string_view key, std::int64_t lowest,
                                      std::int64_t highest) const;
  /// Numbers may be written as integers and are within the range of a float.
  std::optional<double> number(std::string_view key) const;
  std::optional<DVec3> vec3(std::string_view key) const;
  /// A single number stands for three equal ones.
  std::optional<DVec3> number_or_vec3(std::string_view key) const;

  std::optional<TomlTable> table(std::string_view key, const TomlKeys& keys) const;
  /// The tables of [[key]], in order; none if absent.
  std::vector<TomlTable> tables(std::string_view key, const TomlKeys& keys) const;
  /// [key.a], [key.b] and so on, with any names, sorted by name; none if absent.
  std::vector<std::pair<std::string, TomlTable>> named_tables(std::string_view key,
                                                              const TomlKeys& keys) const;

 private:
  std::string full_name(std::string_view key) const;
  /// These two take the key's full name.
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
