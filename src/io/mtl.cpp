#include "raytracing/io/mtl.h"

#include <cmath>
#include <unordered_map>

#include "raytracing/io/file.h"
#include "tally.h"
#include "text_cursor.h"

namespace raytracing {
namespace {

using Severity = LoadReport::Severity;
constexpr int kMostIgnoredKeys = 64;

class MtlParser {
 public:
  MtlParser(std::string_view text, const std::string& file) : cursor_(text, file) {}

  void run() {
    while (!cursor_.at_end()) record();
    end_material();
  }

  std::vector<MtlMaterial> take(LoadReport& report) {
    tally_.flush(cursor_.file(), report);
    return std::move(materials_);
  }

 private:
  struct ColourKey {
    std::string_view key;
    std::optional<Rgb> MtlMaterial::*field;
  };
  struct NumberKey {
    std::string_view key;
    std::optional<float> MtlMaterial::*field;
  };
  static constexpr ColourKey kColourKeys[] = {
      {"Kd", &MtlMaterial::Kd}, {"Ks", &MtlMaterial::Ks}, {"Ke", &MtlMaterial::Ke}};
  static constexpr NumberKey kNumberKeys[] = {{"Ns", &MtlMaterial::Ns},
                                              {"Ni", &MtlMaterial::Ni},
                                              {"d", &MtlMaterial::d},
                                              {"Pr", &MtlMaterial::Pr},
                                              {"Pm", &MtlMaterial::Pm}};

  void record();
  void read_key(std::string_view key, const TextPlace& where);
  void new_material(const TextPlace& where);
  void end_material();
  Rgb colour(std::string_view key);
  int illumination();
  void skip_halo();

  template <typename T>
  void set(std::optional<T>& field, const T& value, std::string_view key, const TextPlace& where) {
    if (field) tally_.note(Severity::warning, "key given twice: " + std::string(key), where);
    field = value;
  }

  TextCursor cursor_;
  Tally tally_;
  std::vector<MtlMaterial> materials_;
  std::unordered_map<std::string, std::size_t> numbers_;
  MtlMaterial* material_ = nullptr;    // the one that is being read
  std::optional<float> transparency_;  // its Tr
  TextPlace transparency_place_;
};

void MtlParser::record() {
  cursor_.skip_blanks();
  if (cursor_.at_record_end()) return cursor_.finish_record();
  const TextPlace where = cursor_.place();
  const std::string_view key = cursor_.token();
  if (key == "newmtl") {
    new_material(where);
  } else if (material_) {
    read_key(key, where);
  } else {
    cursor_.fail(where, quoted(key) + " stands before the first newmtl");
  }
}

void MtlParser::read_key(std::string_view key, const TextPlace& where) {
  for (const ColourKey& known : kColourKeys) {
    if (key != known.key) continue;
    set(material_->*known.field, colour(key), key, where);
    return cursor_.finish_record();
  }
  for (const NumberKey& known : kNumberKeys) {
    if (key != known.key) continue;
    if (key == "d") skip_halo();
    set(material_->*known.field, cursor_.number("a number"), key, where);
    return cursor_.finish_record();
  }
  if (key == "Tr") {
    set(transparency_, cursor_.number("a number"), key, where);
    transparency_place_ = where;
    return cursor_.finish_record();
  }
  if (key == "illum") {
    set(material_->illum, illumination(), key, where);
    return cursor_.finish_record();
  }
  tally_.note_keyword("MTL key", key, where, kMostIgnoredKeys);
  cursor_.skip_record();
}

// A second material of the same name takes the place of the first.
void MtlParser::new_material(const TextPlace& where) {
  end_material();
  cursor_.skip_blanks();
  const TextPlace name_place = cursor_.place();
  const std::string name = cursor_.name();
  if (name.empty()) cursor_.fail(name_place, "truncated record: newmtl needs a name");
  cursor_.finish_record();
  const auto [found, added] = numbers_.try_emplace(name, materials_.size());
  if (added) {
    materials_.emplace_back();
  } else {
    tally_.note(Severity::warning, "material defined twice; the last one counts", where);
  }
  material_ = &materials_[found->second];
  *material_ = MtlMaterial{};
  material_->name = name;
  material_->where = cursor_.location(where);
}

// Tr is the older spelling of d. Where both stand and differ, Tr is the one that exporters get
// wrong: some write Tr 1 for an opaque material.
void MtlParser::end_material() {
  if (!transparency_) return;
  const float d = 1 - *transparency_;
  if (!material_->d) {
    material_->d = d;
  } else if (std::abs(*material_->d - d) > 1e-3f) {
    tally_.note(Severity::warning, "Tr differs from 1 - d; d counts", transparency_place_);
  }
  transparency_.reset();
}

// r g b, or one number for a grey.
Rgb MtlParser::colour(std::string_view key) {
  cursor_.skip_blanks();
  TextCursor ahead = cursor_;
  const std::string_view first = ahead.token();
  if (first == "spectral" || first == "xyz") {
    cursor_.fail(cursor_.place(),
                 std::string(key) + ' ' + std::string(first) + " is not supported; give r g b");
  }
  Rgb value(0.0f);
  for (int i = 0; i < 3; ++i) {
    cursor_.skip_blanks();
    if (i == 1 && cursor_.at_record_end()) return Rgb(value.x);
    const TextPlace where = cursor_.place();
    value[i] = cursor_.number("a number");
    if (value[i] < 0) cursor_.fail(where, std::string(key) + " must not be negative");
  }
  return value;
}

// "d -halo x" makes the edge of an object more opaque than its middle; x is read as a plain d.
void MtlParser::skip_halo() {
  cursor_.skip_blanks();
  TextCursor ahead = cursor_;
  if (ahead.token() != "-halo") return;
  tally_.note(Severity::ignored, "MTL option d -halo", cursor_.place());
  cursor_ = ahead;
}

int MtlParser::illumination() {
  cursor_.skip_blanks();
  const TextPlace where = cursor_.place();
  const float number = cursor_.number("a number");
  if (number != std::floor(number) || number < 0 || number > 1000) {
    cursor_.fail(where, "illum must be a small whole number");
  }
  return static_cast<int>(number);
}

}  // namespace

std::vector<MtlMaterial> parse_mtl(std::string_view text, const std::string& file,
                                   LoadReport& report) {
  MtlParser parser(text, file);
  parser.run();
  return parser.take(report);
}

std::vector<MtlMaterial> load_mtl(const std::string& path, LoadReport& report) {
  return parse_mtl(read_file(path), path, report);
}

}  // namespace raytracing
