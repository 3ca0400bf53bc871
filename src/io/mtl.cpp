#include "raytracing/io/mtl.h"

#include <fmt/format.h>

#include <cmath>
#include <unordered_map>

#include "text_cursor.h"

namespace raytracing {
namespace {

using Severity = LoadReport::Severity;
constexpr int kMostIgnoredKeys = 64;

class MtlParser {
 public:
  MtlParser(std::string_view text, const std::string& file, LoadReport& report)
      : cursor_(text, file), report_(report) {}

  std::vector<MtlMaterial> parse() {
    while (!cursor_.at_end()) record();
    end_material();
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

  void note(Severity severity, std::string_view kind, const TextPlace& where) {
    report_.add(severity, kind, cursor_.file(), where);
  }
  template <typename T>
  void set(std::optional<T>& field, const T& value, std::string_view key, const TextPlace& where) {
    if (field) note(Severity::warning, "key given twice: " + std::string(key), where);
    field = value;
  }

  TextCursor cursor_;
  LoadReport& report_;
  std::vector<MtlMaterial> materials_;
  std::unordered_map<std::string, std::size_t> numbers_;
  MtlMaterial* material_ = nullptr;    // the current material
  std::optional<float> transparency_;  // its Tr
  TextPlace transparency_place_;
};

void MtlParser::record() {
  cursor_.skip_blanks();
  if (cursor_.at_record_end()) return cursor_.finish_record();
  const TextPlace where = cursor_.place();
  const std::string_view key = cursor_.token();
  if (key == "newmtl")
    new_material(where);
  else if (material_)
    read_key(key, where);
  else
    cursor_.fail(where, quoted(key) + " precedes the first newmtl");
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
  report_.add_keyword("MTL key", key, cursor_.file(), where, kMostIgnoredKeys);
  cursor_.skip_record();
}

// Begins a material. A second one of the same name replaces the first.
void MtlParser::new_material(const TextPlace& where) {
  end_material();
  cursor_.skip_blanks();
  const TextPlace name_place = cursor_.place();
  const std::string name = cursor_.name();
  if (name.empty()) cursor_.fail(name_place, "truncated record: newmtl needs a name");
  cursor_.finish_record();
  const auto [found, added] = numbers_.try_emplace(name, materials_.size());
  if (added)
    materials_.emplace_back();
  else
    note(Severity::warning, "material defined twice; the last definition is used", where);
  material_ = &materials_[found->second];
  *material_ = MtlMaterial{};
  material_->name = name;
  material_->where = cursor_.location(where);
}

// Tr is the older form of d. If a material has both and they disagree, d is used, since some
// exporters write Tr 1 for an opaque material.
void MtlParser::end_material() {
  if (!transparency_) return;
  const float d = 1 - *transparency_;
  if (!material_->d)
    material_->d = d;
  else if (std::abs(*material_->d - d) > 1e-3f)
    note(Severity::warning, "Tr differs from 1 - d; d is used", transparency_place_);
  transparency_.reset();
}

// Reads r g b, or one number for a grey.
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

// Skips the option of "d -halo x", which makes the edge of an object more opaque than its middle; x
// is read as a plain d.
void MtlParser::skip_halo() {
  cursor_.skip_blanks();
  TextCursor ahead = cursor_;
  if (ahead.token() != "-halo") return;
  note(Severity::ignored, "MTL option d -halo", cursor_.place());
  cursor_ = ahead;
}

int MtlParser::illumination() {
  cursor_.skip_blanks();
  const TextPlace where = cursor_.place();
  const float number = cursor_.number("a number");
  if (number != std::floor(number) || number < 0 || number > 1000)
    cursor_.fail(where, "illum must be a whole number from 0 to 1000");
  return static_cast<int>(number);
}

constexpr float kDefaultRoughness = 0.5f;  // for materials without Pr

// True for the illumination models of mirrors and glass.
bool asks_for_ray_tracing(int illum) { return illum >= 3 && illum <= 9; }

Rgb reflectance(const MtlMaterial& mtl, LoadReport& report) {
  if (!mtl.Kd) {
    report.add(LoadReport::Severity::warning, "material without Kd, 0.5 grey is used", mtl.where);
    return Diffuse{}.reflectance;
  }
  if (max_component(*mtl.Kd) > 1) {
    throw InputError(mtl.where, fmt::format("material '{}': no component of Kd may exceed 1, "
                                            "or the surface would reflect more than it receives",
                                            mtl.name));
  }
  return *mtl.Kd;
}

GgxConductor conductor(const MtlMaterial& mtl, LoadReport& report) {
  if (!mtl.Pr) {
    report.add(LoadReport::Severity::repaired, "material with Pm but without Pr, 0.5 is used",
               mtl.where);
  }
  const float roughness = mtl.Pr.value_or(kDefaultRoughness);
  const float alpha = roughness * roughness;
  if (!(alpha > 0 && alpha <= 1)) {
    throw InputError(mtl.where, fmt::format("material '{}': Pr is {}, but a rough conductor needs "
                                            "a roughness in (0,1]",
                                            mtl.name, roughness));
  }
  return {reflectance(mtl, report), alpha, Fresnel::none};
}

void report_ignored(const MtlMaterial& mtl, LoadReport& report) {
  const auto ignore = [&](bool present, const char* kind) {
    if (present) report.add(LoadReport::Severity::ignored, kind, mtl.where);
  };
  const bool metal = mtl.Pm.value_or(0) == 1;
  ignore(!metal && mtl.Ks && !is_black(*mtl.Ks), "Ks (specular reflectance without Pm)");
  ignore(!metal && mtl.Pr, "Pr (roughness without Pm)");
  ignore(mtl.d.value_or(1) < 1, "d or Tr (transparency)");
  ignore(!metal && mtl.illum && asks_for_ray_tracing(*mtl.illum), "illum (mirrors and glass)");
}

}  // namespace

std::vector<MtlMaterial> parse_mtl(std::string_view text, const std::string& file,
                                   LoadReport& report) {
  return MtlParser(text, file, report).parse();
}

Surface surface_from_mtl(const MtlMaterial& mtl, LoadReport& report) {
  const float metallic = mtl.Pm.value_or(0);
  if (metallic != 0 && metallic != 1) {
    throw InputError(mtl.where, fmt::format("material '{}': Pm is {}, but must be 0 or 1: blends "
                                            "of metal and non-metal are not supported",
                                            mtl.name, metallic));
  }
  report_ignored(mtl, report);
  Surface surface{mtl.name, Material{}, mtl.Ke.value_or(Rgb(0.0f))};
  if (metallic == 1)
    surface.material = conductor(mtl, report);
  else
    surface.material = Diffuse{reflectance(mtl, report)};
  return surface;
}

}  // namespace raytracing
