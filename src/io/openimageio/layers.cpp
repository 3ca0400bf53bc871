#include "layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "raytracing/io/errors.h"
#include "raytracing/io/image.h"

namespace raytracing::openimageio {
namespace {

constexpr int kMissing = -1;

bool is_whole(const std::array<int, 3>& indices) {
  return std::find(indices.begin(), indices.end(), kMissing) == indices.end();
}

/// Channels of one part that share what stands before the last dot of their names.
struct Layer {
  std::size_t part;
  std::string part_name, prefix;
  std::array<int, 3> rgb{kMissing, kMissing, kMissing};
  std::array<int, 3> xyz{kMissing, kMissing, kMissing};
  int alpha = kMissing;
  bool has_chroma = false;

  bool is_colour() const { return is_whole(rgb); }
  /// A channel Y alone is luminance; with X and Z it is a part of a vector.
  bool is_grey() const {
    return !is_colour() && xyz[0] == kMissing && xyz[1] != kMissing && xyz[2] == kMissing &&
           !has_chroma;
  }
  bool is_vector() const { return !is_colour() && is_whole(xyz); }
  std::string name() const {
    return part_name.empty() || prefix.empty() ? part_name + prefix : part_name + "." + prefix;
  }
};

std::string_view before_last_dot(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : name.substr(0, dot);
}

std::string_view after_last_dot(std::string_view name) { return name.substr(name.rfind('.') + 1); }

void add_channel(Layer& layer, std::string_view component, int index) {
  const auto set = [&](std::string_view letters, std::array<int, 3>& indices) {
    const std::size_t place =
        component.size() == 1 ? letters.find(component) : std::string_view::npos;
    if (place != std::string_view::npos) indices[place] = index;
  };
  set("RGB", layer.rgb);
  set("XYZ", layer.xyz);
  if (component == "A") layer.alpha = index;
  if (component == "RY" || component == "BY") layer.has_chroma = true;
}

// The layers that can be read, in the order of the file.
std::vector<Layer> readable_layers(const std::vector<Part>& parts) {
  std::vector<Layer> layers;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (parts[p].deep) continue;
    const std::size_t first = layers.size();
    for (std::size_t c = 0; c < parts[p].channels.size(); ++c) {
      const std::string& channel = parts[p].channels[c];
      const std::string prefix(before_last_dot(channel));
      auto layer = std::find_if(layers.begin() + static_cast<std::ptrdiff_t>(first), layers.end(),
                                [&](const Layer& l) { return l.prefix == prefix; });
      if (layer == layers.end()) {
        layers.push_back({p, parts.size() > 1 ? parts[p].name : "", prefix});
        layer = layers.end() - 1;
      }
      add_channel(*layer, after_last_dot(channel), static_cast<int>(c));
    }
  }
  std::erase_if(layers,
                [](const Layer& l) { return !l.is_colour() && !l.is_grey() && !l.is_vector(); });
  return layers;
}

std::string joined(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 40;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
    text += (i == 0 ? "" : ", ") + quoted(names[i]);
  return names.size() > kMost ? fmt::format("{} and {} more", text, names.size() - kMost) : text;
}

std::string names_of(const std::vector<Layer>& layers) {
  std::vector<std::string> names;
  for (const Layer& layer : layers) names.push_back(layer.name());
  return joined(names);
}

// Renderers call the picture itself by these names: Blender, Arnold, V-Ray and Nuke.
bool is_beauty(std::string_view name) {
  std::string last(after_last_dot(name));
  for (char& c : last)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return last == "combined" || last == "beauty" || last == "rgba" || last == "rgb_color";
}

[[noreturn]] void fail_without_picture(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  bool deep = false;
  for (const Part& part : parts) {
    deep = deep || part.deep;
    names.insert(names.end(), part.channels.begin(), part.channels.end());
  }
  throw InputError(deep ? "deep images cannot be read"
                        : "has no channels R, G and B; its channels are " + joined(names));
}

const Layer& named_layer(const std::vector<Layer>& layers, const std::string& wanted) {
  std::vector<const Layer*> found;
  for (const Layer& l : layers)
    if (l.name() == wanted || l.prefix == wanted || l.part_name == wanted) found.push_back(&l);
  if (found.empty())
    for (const Layer& l : layers)
      if (after_last_dot(l.name()) == wanted) found.push_back(&l);
  if (found.size() == 1) return *found.front();
  throw InputError(fmt::format("{} layer {}; its layers are {}",
                               found.empty() ? "has no" : "has more than one", quoted(wanted),
                               names_of(layers)));
}

// A vector is read only where it is named.
Layer beauty_layer(const std::vector<Part>& parts, std::vector<Layer> layers) {
  std::erase_if(layers, [](const Layer& l) { return l.is_vector(); });
  if (layers.empty()) fail_without_picture(parts);
  const auto first = [&](auto&& fits) -> const Layer* {
    const auto found = std::find_if(layers.begin(), layers.end(), fits);
    return found == layers.end() ? nullptr : &*found;
  };
  const Layer* layer = first([](const Layer& l) { return l.name().empty() && l.is_colour(); });
  if (!layer) layer = first([](const Layer& l) { return is_beauty(l.name()) && l.is_colour(); });
  if (!layer) layer = first([](const Layer& l) { return l.prefix.empty() && l.is_colour(); });
  if (!layer) layer = first([](const Layer& l) { return l.prefix.empty(); });
  if (!layer && layers.size() == 1) layer = &layers.front();
  if (!layer)
    throw InputError(
        "has several layers, none of which is called beauty or Combined; its layers "
        "are " +
        names_of(layers));
  return *layer;
}

}  // namespace

LayerChoice choose_layer(const std::vector<Part>& parts, const std::string& wanted) {
  const std::vector<Layer> layers = readable_layers(parts);
  if (layers.empty()) fail_without_picture(parts);
  const Layer layer = wanted.empty() ? beauty_layer(parts, layers) : named_layer(layers, wanted);
  LayerChoice choice{layer.part, layer.is_vector() ? layer.xyz : layer.rgb, layer.alpha, {}, {}};
  if (!layer.name().empty())
    choice.notes.push_back("its layer " + quoted(layer.name()) + " was read");
  else if (parts.size() > 1)
    choice.notes.push_back(
        fmt::format("image {} of {} in the file was read", layer.part + 1, parts.size()));
  if (layer.is_grey()) {
    choice.rgb.fill(layer.xyz[1]);
    choice.notes.emplace_back("it has one channel, which was read as red, green and blue");
  }
  if (!layer.name().empty()) return choice;
  const std::vector<std::string>& channels = parts[layer.part].channels;
  for (const std::string_view statistics : kStatisticsLayers)
    for (std::size_t c = 0; c < channels.size(); ++c)
      if (before_last_dot(channels[c]) == statistics)
        choice.others.push_back({static_cast<int>(c), channels[c]});
  return choice;
}

}  // namespace raytracing::openimageio
