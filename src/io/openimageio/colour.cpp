#include "colour.h"

#include <fmt/format.h>
#include <lcms2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string_view>

#include "raytracing/io/errors.h"
#include "raytracing/io/srgb.h"

namespace raytracing::openimageio {
namespace {

constexpr cmsCIExyY kD65{0.3127, 0.3290, 1};
constexpr cmsCIExyYTRIPLE kRec709{{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};

struct Chromaticities {
  std::array<glm::dvec2, 3> primaries;
  glm::dvec2 white;
};

Chromaticities rec709() {
  const auto xy = [](const cmsCIExyY& c) { return glm::dvec2(c.x, c.y); };
  return {{xy(kRec709.Red), xy(kRec709.Green), xy(kRec709.Blue)}, xy(kD65)};
}

// The matrix from RGB to CIE XYZ with Y = 1 for white (SMPTE RP 177-1993, section 3.3). Not finite
// for primaries on a line or a white point without luminance.
glm::dmat3 rgb_to_xyz(const Chromaticities& c) {
  const auto xyz = [](const glm::dvec2& xy) { return glm::dvec3(xy, 1 - xy.x - xy.y); };
  const glm::dmat3 primaries(xyz(c.primaries[0]), xyz(c.primaries[1]), xyz(c.primaries[2]));
  const glm::dvec3 scale = glm::inverse(primaries) * (xyz(c.white) / c.white.y);
  return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

bool is_finite(const glm::dmat3& m) {
  for (int i = 0; i < 9; ++i)
    if (!std::isfinite(m[i / 3][i % 3])) return false;
  return true;
}

// The chromaticities of an EXR file; empty without them.
std::optional<std::array<float, 8>> chromaticities_of(const OIIO::ImageSpec& spec) {
  const OIIO::ParamValue* found =
      spec.find_attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8));
  if (found == nullptr) return {};
  std::array<float, 8> numbers{};
  for (int i = 0; i < 8; ++i) numbers[static_cast<std::size_t>(i)] = found->get_float_indexed(i);
  return numbers;
}

// The conversion from these chromaticities; empty where they are those of Rec. 709.
std::optional<glm::dmat3> conversion(const std::array<float, 8>& numbers) {
  std::array<glm::dvec2, 4> xy{};
  for (std::size_t i = 0; i < 4; ++i) xy[i] = {double{numbers[2 * i]}, double{numbers[2 * i + 1]}};
  const Chromaticities here = rec709();
  const Chromaticities there{{xy[0], xy[1], xy[2]}, xy[3]};
  constexpr double kRounding = 1e-3;  // headers state three or four digits
  double farthest = glm::length(there.white - here.white);
  for (int i = 0; i < 3; ++i)
    farthest = std::max(farthest, glm::length(there.primaries[i] - here.primaries[i]));
  if (farthest < kRounding) return {};
  const glm::dmat3 matrix = glm::inverse(rgb_to_xyz(here)) * rgb_to_xyz(there);
  if (!is_finite(matrix)) throw InputError("its chromaticities are not those of three primaries");
  return matrix;
}

double decoded(double code, double gamma) {
  return gamma > 0 ? std::pow(code, gamma) : srgb_to_linear(code);
}

}  // namespace

/// A transform of the library Little CMS from an ICC profile to linear Rec. 709.
class ColourDecoder::Profile {
 public:
  /// Throws InputError for a profile that is damaged or not one of RGB.
  Profile(const void* bytes, std::size_t size) {
    cmsHPROFILE file = cmsOpenProfileFromMem(bytes, static_cast<cmsUInt32Number>(size));
    if (file == nullptr) throw InputError("its ICC profile is damaged");
    const bool is_rgb = cmsGetColorSpace(file) == cmsSigRgbData;
    std::array<char, 80> text{};
    cmsGetProfileInfoASCII(file, cmsInfoDescription, "en", "US", text.data(), text.size());
    name_ = quoted(text.data());
    cmsToneCurve* line = cmsBuildGamma(nullptr, 1);
    const std::array<cmsToneCurve*, 3> lines{line, line, line};
    cmsHPROFILE linear = cmsCreateRGBProfile(&kD65, &kRec709, lines.data());
    if (is_rgb)
      transform_ = cmsCreateTransform(file, TYPE_RGB_FLT, linear, TYPE_RGB_FLT,
                                      INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOCACHE);
    cmsFreeToneCurve(line);
    cmsCloseProfile(linear);
    cmsCloseProfile(file);
    if (transform_ == nullptr) throw InputError("its ICC profile " + name_ + " is not one of RGB");
  }
  ~Profile() { cmsDeleteTransform(transform_); }
  Profile(const Profile&) = delete;
  Profile& operator=(const Profile&) = delete;

  const std::string& name() const { return name_; }

  std::array<float, 3> decode(const float* rgb) const {
    std::array<float, 3> linear{};
    cmsDoTransform(transform_, rgb, linear.data(), 1);
    return linear;
  }

  /// Whether it is that of sRGB but for rounding, as most profiles in files are.
  bool is_srgb() const {
    constexpr float kTolerance = 2e-3f;
    constexpr int kSteps = 8;
    for (int i = 0; i < (kSteps + 1) * (kSteps + 1) * (kSteps + 1); ++i) {
      const std::array<int, 3> code{i % (kSteps + 1), i / (kSteps + 1) % (kSteps + 1),
                                    i / (kSteps + 1) / (kSteps + 1)};
      std::array<float, 3> encoded{};
      for (std::size_t c = 0; c < 3; ++c) encoded[c] = static_cast<float>(code[c]) / kSteps;
      const std::array<float, 3> linear = decode(encoded.data());
      for (std::size_t c = 0; c < 3; ++c)
        if (!(std::abs(linear[c] - static_cast<float>(srgb_to_linear(double{encoded[c]}))) <
              kTolerance))
          return false;
    }
    return true;
  }

 private:
  std::string name_;
  cmsHTRANSFORM transform_ = nullptr;
};

ColourDecoder::ColourDecoder(const OIIO::ImageSpec& spec, double largest_code,
                             const StatedColours& stated)
    : largest_code_(largest_code), gamma_(stated.gamma) {
  const auto chromaticities =
      stated.chromaticities ? stated.chromaticities : chromaticities_of(spec);
  if (chromaticities) to_rec709_ = conversion(*chromaticities);
  const OIIO::ParamValue* icc = spec.find_attribute("ICCProfile");
  if (icc != nullptr) {
    auto profile =
        std::make_unique<const Profile>(icc->data(), static_cast<std::size_t>(icc->datasize()));
    if (largest_code > 0 && profile->is_srgb()) {
      gamma_ = 0;
    } else {
      notes_.push_back("its colours were converted from the ICC profile " + profile->name());
      profile_ = std::move(profile);
    }
    to_rec709_.reset();  // a profile overrides gamma and chromaticities (PNG 3rd edition, 4.3)
  } else if (largest_code > 0 && gamma_ > 0) {
    notes_.push_back(fmt::format("its colours were decoded by the gamma {:.5g}", gamma_));
  }
  if (to_rec709_)
    notes_.emplace_back("its colours were converted from its own chromaticities to Rec. 709");
}

ColourDecoder::~ColourDecoder() = default;

void ColourDecoder::decode(float* values, std::size_t pixels, std::size_t stride) const {
  if (largest_code_ == 0 && !profile_ && !to_rec709_) return;
  for (std::size_t i = 0; i < pixels; ++i) {
    float* rgb = values + i * stride;
    if (profile_) {
      const std::array<float, 3> linear = profile_->decode(rgb);
      std::copy(linear.begin(), linear.end(), rgb);
    } else if (largest_code_ > 0) {
      for (int c = 0; c < 3; ++c) {
        const double code = std::round(double{rgb[c]} * largest_code_);
        rgb[c] = static_cast<float>(decoded(code / largest_code_, gamma_));
      }
    }
    if (to_rec709_) {
      const glm::dvec3 linear = *to_rec709_ * glm::dvec3(rgb[0], rgb[1], rgb[2]);
      for (int c = 0; c < 3; ++c) rgb[c] = static_cast<float>(linear[c]);
    }
  }
}

}  // namespace raytracing::openimageio
