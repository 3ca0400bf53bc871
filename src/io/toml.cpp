#include "toml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace raytracing {
namespace {

// Describes the value of a node in words.
std::string describe(const toml::node& node) {
  if (const auto* text = node.as_string()) return fmt::format("the string \"{}\"", text->get());
  if (const auto* integer = node.as_integer()) return fmt::format("the integer {}", integer->get());
  if (const auto* number = node.as_floating_point())
    return fmt::format("the number {}", number->get());
  if (const auto* boolean = node.as_boolean()) return boolean->get() ? "true" : "false";
  if (const auto* array = node.as_array())
    return fmt::format("an array of {} value{}", array->size(), array->size() == 1 ? "" : "s");
  return node.is_table() ? "a table" : "a date or time";
}

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

}  // namespace

TomlDocument::TomlDocument(std::string_view text, std::string file)
    : text_(text), file_(std::move(file)), line_starts_{0} {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') line_starts_.push_back(i + 1);
  try {
    root_ = toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw InputError(location(error.source().begin), std::string(error.description()));
  }
}

TextLocation TomlDocument::location(const toml::source_position& position) const {
  TextLocation where{file_, static_cast<long>(position.line), static_cast<long>(position.column)};
  if (position.line < 1 || position.line > line_starts_.size()) return where;
  // toml++ counts characters: add the further bytes of those before the column.
  std::size_t i = line_starts_[position.line - 1];
  for (toml::source_index characters = 1; characters < position.column; ++characters)
    for (++i; i < text_.size() && is_continuation_byte(text_[i]); ++i) ++where.column;
  return where;
}

TomlTable::TomlTable(const TomlDocument& document, const toml::table& table, std::string name,
                     const TomlKeys& keys)
    : document_(&document), table_(&table), name_(std::move(name)) {
  refuse_unknown(keys);
  for (const std::string& key : keys.required) {
    if (has(key)) continue;
    const TextLocation where =
        name_.empty() ? TextLocation{document.file()} : document.location(table.source().begin);
    throw InputError(where, fmt::format("'{}' is missing", full_name(key)));
  }
}

void TomlTable::refuse_unknown(const TomlKeys& keys) const {
  std::vector<std::string> known = keys.required;
  known.insert(known.end(), keys.optional.begin(), keys.optional.end());
  // toml++ sorts keys by name; the error names the first in the file.
  const toml::key* first = nullptr;
  for (const auto& [key, node] : *table_) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    const auto place = [](const toml::key& k) {
      return std::pair(k.source().begin.line, k.source().begin.column);
    };
    if (!first || place(key) < place(*first)) first = &key;
  }
  if (!first) return;
  throw InputError(
      document_->location(first->source().begin),
      fmt::format("unknown key '{}'; the nearest known key is '{}'", full_name(first->str()),
                  full_name(nearest_name(first->str(), known))));
}

std::string TomlTable::full_name(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

TextLocation TomlTable::where(std::string_view key) const {
  return document_->location(table_->get(key)->source().begin);
}

InputError TomlTable::error(std::string_view key, const std::string& message) const {
  return {where(key), fmt::format("{}: {}", full_name(key), message)};
}

InputError TomlTable::type_error(const std::string& name, const toml::node& node,
                                 const std::string& expected) const {
  return {document_->location(node.source().begin),
          fmt::format("{}: expected {}, found {}", name, expected, describe(node))};
}

std::optional<std::string> TomlTable::string(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (!node) return {};
  const auto* value = node->as_string();
  if (!value) throw type_error(full_name(key), *node, "a string");
  return value->get();
}

std::optional<std::string> TomlTable::one_of(std::string_view key,
                                             const std::vector<std::string>& names) const {
  std::optional<std::string> value = string(key);
  if (!value || std::find(names.begin(), names.end(), *value) != names.end()) return value;
  if (names.empty()) throw error(key, fmt::format("unknown name '{}'", *value));
  throw error(key, fmt::format("'{}' is not one of: {}; the nearest is '{}'", *value,
                               fmt::join(names, ", "), nearest_name(*value, names)));
}

std::optional<std::int64_t> TomlTable::integer(std::string_view key, std::int64_t lowest,
                                               std::int64_t highest) const {
  const toml::node* node = table_->get(key);
  if (!node) return {};
  const auto* value = node->as_integer();
  if (!value || value->get() < lowest || value->get() > highest) {
    const bool bounded = highest < std::numeric_limits<std::int64_t>::max();
    throw type_error(full_name(key), *node,
                     bounded ? fmt::format("an integer from {} to {}", lowest, highest)
                             : fmt::format("an integer of at least {}", lowest));
  }
  return value->get();
}

double TomlTable::checked_number(const std::string& name, const toml::node& node,
                                 const std::string& expected) const {
  const auto* number = node.as_floating_point();
  const auto* integer = node.as_integer();
  if (!number && !integer) throw type_error(name, node, expected);
  const double value = number ? number->get() : static_cast<double>(integer->get());
  // Fails for NaN, too.
  if (!(std::abs(value) <= std::numeric_limits<float>::max()))
    throw type_error(name, node, "a finite number within the range of a 32-bit float");
  return value;
}

std::optional<double> TomlTable::number(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (!node) return {};
  return checked_number(full_name(key), *node, "a number");
}

std::optional<DVec3> TomlTable::vec3(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (!node) return {};
  const toml::array* array = node->as_array();
  if (!array || array->size() != 3)
    throw type_error(full_name(key), *node, "an array of 3 numbers");
  DVec3 value;
  for (int i = 0; i < 3; ++i)
    value[i] = checked_number(full_name(key), (*array)[static_cast<std::size_t>(i)], "a number");
  return value;
}

std::optional<DVec3> TomlTable::number_or_vec3(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (!node) return {};
  if (node->is_array()) return vec3(key);
  return DVec3(checked_number(full_name(key), *node, "a number or an array of 3 numbers"));
}

std::optional<TomlTable> TomlTable::table(std::string_view key, const TomlKeys& keys) const {
  const toml::node* node = table_->get(key);
  if (!node) return {};
  if (!node->is_table()) throw type_error(full_name(key), *node, fmt::format("a table, [{}]", key));
  return TomlTable(*document_, *node->as_table(), full_name(key), keys);
}

std::vector<TomlTable> TomlTable::tables(std::string_view key, const TomlKeys& keys) const {
  std::vector<TomlTable> result;
  const toml::node* node = table_->get(key);
  if (!node) return result;
  const std::string expected = fmt::format("an array of tables, [[{}]]", key);
  if (!node->is_array()) throw type_error(full_name(key), *node, expected);
  for (const toml::node& element : *node->as_array()) {
    if (!element.is_table()) throw type_error(full_name(key), element, expected);
    result.emplace_back(*document_, *element.as_table(), full_name(key), keys);
  }
  return result;
}

std::vector<std::pair<std::string, TomlTable>> TomlTable::named_tables(std::string_view key,
                                                                       const TomlKeys& keys) const {
  std::vector<std::pair<std::string, TomlTable>> result;
  const toml::node* node = table_->get(key);
  if (!node) return result;
  if (!node->is_table())
    throw type_error(full_name(key), *node, fmt::format("tables, [{}.name]", key));
  for (const auto& [name, element] : *node->as_table()) {
    const std::string full = fmt::format("{}.{}", full_name(key), name.str());
    if (!element.is_table()) throw type_error(full, element, "a table");
    result.emplace_back(name.str(), TomlTable(*document_, *element.as_table(), full, keys));
  }
  return result;
}

}  // namespace raytracing
