#include "description.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <sstream>
#include <string_view>

#include "fences.h"
#include "raytracing/io/errors.h"

namespace raytracing::openimageio {
namespace {

// The library gives some attributes of EXR names of its own.
constexpr std::pair<std::string_view, std::string_view> kRenamed[] = {
    {"Software", "software"}, {"ImageDescription", "comments"}, {"Copyright", "owner"}};

// Attributes that describe the file, not the picture; those of EXR are set again when it is
// written.
bool is_of_file(std::string_view name) {
  constexpr std::string_view kNames[] = {
      "compression",        "PixelAspectRatio", "screenWindowWidth", "screenWindowCenter",
      "DateTime",           "Orientation",      "ResolutionUnit",    "XResolution",
      "YResolution",        "planarconfig",     "textureformat",     "chromaticities",
      "CompressionQuality", "BitsPerSample"};
  constexpr std::string_view kPrefixes[] = {"oiio:", "openexr:", "tiff:", "Exif:", "ICCProfile"};
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames) ||
         std::any_of(std::begin(kPrefixes), std::end(kPrefixes),
                     [&](std::string_view prefix) { return name.starts_with(prefix); });
}

// EXR knows neither 64-bit integers nor truth values: what does not fit a type of EXR becomes text,
// so that no digit is lost.
void set_exr_attribute(const std::string& name, const FactValue& value, OIIO::ImageSpec& spec) {
  const auto* whole = std::get_if<std::int64_t>(&value);
  if (whole && *whole >= INT32_MIN && *whole <= INT32_MAX)
    spec.attribute(name, static_cast<int>(*whole));
  else if (const auto* real = std::get_if<double>(&value))
    spec.attribute(name, OIIO::TypeDesc::DOUBLE, real);
  else
    spec.attribute(name, to_text(value));
}

// A second attribute of this name, or one that EXR defines, would be replaced silently.
void check_names(const ImageMetadata& metadata) {
  std::set<std::string> taken{"",           "channels",          "compression",
                              "dataWindow", "displayWindow",     "lineOrder",
                              "name",       "pixelAspectRatio",  "screenWindowCenter",
                              "tiles",      "screenWindowWidth", "type",
                              "version",    "chunkCount"};
  for (const auto& entry : metadata)
    if (!taken.insert(entry.first).second)
      throw OutputError("an image's attribute '" + entry.first + "' is taken");
}

void check_png_key(const std::string& key) {
  constexpr std::size_t kLongest = 79;
  if (key.size() > kLongest)
    throw OutputError("PNG: the name '" + key + "' is longer than a keyword may be");
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

// One line for each entry, for formats that have a single text.
std::string description(const ImageMetadata& metadata) {
  std::string text;
  for (const auto& [name, value] : metadata) text += name + ": " + one_line(to_text(value)) + "\n";
  return text;
}

ImageMetadata entries_of(const std::string& description) {
  ImageMetadata result;
  std::istringstream lines(description);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos)
      result.emplace_back(line.substr(0, colon), line.substr(colon + 2));
  }
  return result;
}

}  // namespace

void set_metadata(const ImageMetadata& metadata, const std::string& format, OIIO::ImageSpec& spec) {
  check_names(metadata);
  if (format == "openexr") {
    for (const auto& [name, value] : metadata) set_exr_attribute(name, value, spec);
  } else if (format == "png") {
    for (const auto& [name, value] : metadata) {
      check_png_key(name);
      const std::string text = to_text(value);
      if (is_ascii(text)) spec.attribute(name, text);
    }
  } else if ((format == "tiff" || format == "jpeg") && !metadata.empty()) {
    spec.attribute("ImageDescription", description(metadata));
  }
}

std::string with_other_texts(const ImageMetadata& metadata, std::string png) {
  for (const auto& [name, value] : metadata)
    if (const std::string text = to_text(value); !is_ascii(text))
      png = with_international_text(std::move(png), name, text);
  return png;
}

ImageMetadata metadata_of(const OIIO::ImageSpec& spec) {
  ImageMetadata result;
  for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
    std::string name = attribute.name().string();
    if (is_of_file(name)) continue;
    for (const auto& [theirs, ours] : kRenamed)
      if (name == theirs) name = ours;
    if (attribute.type() == OIIO::TypeString) {
      const std::string text = attribute.get_string();
      const ImageMetadata entries = name == "comments" ? entries_of(text) : ImageMetadata();
      result.insert(result.end(), entries.begin(), entries.end());
      if (entries.empty()) result.emplace_back(name, text);
    } else if (attribute.type() == OIIO::TypeInt) {
      result.emplace_back(name, std::int64_t{attribute.get_int()});
    } else if (attribute.type() == OIIO::TypeDesc::DOUBLE) {
      result.emplace_back(name, attribute.get<double>());
    } else if (attribute.type() == OIIO::TypeFloat) {
      result.emplace_back(name, double{attribute.get_float()});
    }
  }
  return result;
}

}  // namespace raytracing::openimageio
