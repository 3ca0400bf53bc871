#include "decode.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "colour.h"
#include "description.h"
#include "fences.h"
#include "layers.h"
#include "open_file.h"
#include "raytracing/io/errors.h"

namespace raytracing::openimageio {
namespace {

std::vector<Part> parts_of(const OpenFile& file) {
  constexpr std::size_t kMostParts = 1000;
  std::vector<Part> parts;
  do {
    const OIIO::ImageSpec& spec = file.input->spec();
    parts.push_back({std::string(spec.get_string_attribute("oiio:subimagename")), spec.channelnames,
                     spec.deep});
    if (spec.deep) continue;
    const auto count = static_cast<std::size_t>(std::max(spec.nchannels, 0));
    if (parts.back().channels.size() != count) throw InputError("its channels have no names");
    if (parts.size() > kMostParts)
      throw InputError(fmt::format("has more than {} images", kMostParts));
  } while (file.format.holds_several() &&
           file.input->seek_subimage(static_cast<int>(parts.size()), 0));
  if (file.format.holds_several()) file.input->geterror();  // that of the seek behind the last part
  return parts;
}

// Must pass before memory is taken that depends on the size that a file claims.
void check_size(const OIIO::ImageSpec& spec, bool is_exr, std::size_t channels,
                std::size_t file_bytes) {
  constexpr std::uint64_t kMaxSide = 65536, kMaxValues = std::uint64_t{1} << 28;
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1) throw InputError("has no pixels");
  const auto width = static_cast<std::uint64_t>(spec.width);
  const auto height = static_cast<std::uint64_t>(spec.height);
  const auto tile =
      static_cast<std::uint64_t>(spec.tile_width) * static_cast<std::uint64_t>(spec.tile_height);
  if (width > kMaxSide || height > kMaxSide || width * height * channels > kMaxValues)
    throw InputError(fmt::format("{}x{} pixels of {} channels are more than can be read", width,
                                 height, channels));
  // No compression of EXR yields more. DEFLATE yields 1032 bytes for one, of 8 grey pixels each.
  const std::uint64_t most_of_a_byte = is_exr ? 1 << 16 : 1032 * 8 * 3;
  if (width * height * channels > most_of_a_byte * file_bytes)
    throw InputError("is too short for its size");
  // Tiles and strips may be said to be larger than the image; the library takes memory for them.
  constexpr std::uint64_t kMostOfATile = 1 << 24;
  const std::uint64_t strip =
      static_cast<std::uint64_t>(std::max(0, spec.get_int_attribute("tiff:RowsPerStrip"))) * width;
  if (std::max(tile, strip) * channels > std::max(kMostOfATile, width * height * channels))
    throw InputError("its tiles or strips are larger than can be read");
}

bool is_integer(const OIIO::TypeDesc& type) {
  return type.basetype == OIIO::TypeDesc::UINT8 || type.basetype == OIIO::TypeDesc::UINT16;
}

void check_type(const OpenFile& file, const OIIO::ImageSpec& spec) {
  const auto type = static_cast<OIIO::TypeDesc::BASETYPE>(spec.format.basetype);
  const bool is_float = type == OIIO::TypeDesc::HALF || type == OIIO::TypeDesc::FLOAT;
  if (!is_float && !is_integer(spec.format) && file.format.name != "openexr")
    throw InputError(fmt::format("values of type {} cannot be read", spec.format.c_str()));
  // Grey, RGB, palette and YCbCr. The library reads the others as if they were sRGB, and writes
  // behind its memory when it inverts damaged files of the kind 0, whose 0 is white.
  constexpr std::array kGood{1, 2, 3, 6};
  const int kind = spec.get_int_attribute("tiff:PhotometricInterpretation", kGood.front());
  if (std::find(kGood.begin(), kGood.end(), kind) == kGood.end())
    throw InputError(
        fmt::format("TIFF images of the photometric interpretation {} cannot be read", kind));
}

/// Channels that follow each other in the file and, with the same distance, in the picture.
struct Run {
  int first, count;
  std::size_t offset;  ///< of the first one, in a pixel of the picture
};

// The one channel of grey is read once, since formats that are read in order begin anew otherwise.
std::vector<Run> runs_of(const LayerChoice& choice, int alpha) {
  std::vector<std::pair<int, std::size_t>> places;  // index and offset
  for (std::size_t c = 0; c < (choice.is_grey() ? 1 : 3); ++c)
    places.emplace_back(choice.rgb[c], c);
  for (std::size_t i = 0; i < choice.others.size(); ++i)
    places.emplace_back(choice.others[i].index, 3 + i);
  if (alpha >= 0) places.emplace_back(alpha, 3 + choice.others.size());
  std::vector<Run> runs;
  for (const auto& [index, offset] : places) {
    const bool follows = !runs.empty() && index == runs.back().first + runs.back().count &&
                         offset == runs.back().offset + static_cast<std::size_t>(runs.back().count);
    if (follows)
      ++runs.back().count;
    else
      runs.push_back({index, 1, offset});
  }
  return runs;
}

/// Reads rows of chosen channels as floats. Whole numbers of EXR keep their value; those of other
/// formats become codes in [0,1].
class RowReader {
 public:
  RowReader(const OpenFile& file, const LayerChoice& choice, int alpha)
      : file_(file),
        spec_(file.input->spec()),
        part_(static_cast<int>(choice.part)),
        is_grey_(choice.is_grey()),
        runs_(runs_of(choice, alpha)),
        stride_(3 + choice.others.size() + (alpha >= 0 ? 1 : 0)) {}

  std::size_t stride() const { return stride_; }

  /// Appends rows, all of which the picture has, to `values`.
  void append(int first, int count, std::vector<float>& values) const {
    const std::size_t row = stride_ * static_cast<std::size_t>(spec_.width);
    float* rows = values.data() + values.size();
    values.resize(values.size() + row * static_cast<std::size_t>(count));
    for (const Run& run : runs_) {
      if (spec_.channelformat(run.first).basetype == OIIO::TypeDesc::UINT32)
        read_whole_numbers(run, first, count, rows + run.offset);
      else
        file_.check(read(run, first, count, OIIO::TypeFloat, rows + run.offset, sizeof(float)));
    }
    if (is_grey_)
      for (std::size_t i = 0; i < row * static_cast<std::size_t>(count); i += stride_)
        rows[i + 1] = rows[i + 2] = rows[i];
  }

 private:
  bool read(const Run& run, int first, int count, const OIIO::TypeDesc& type, void* to,
            std::size_t bytes) const {
    const auto x = static_cast<OIIO::stride_t>(stride_ * bytes);
    const OIIO::stride_t y = x * spec_.width;
    const int top = spec_.y + first;
    if (spec_.tile_width > 0)
      return file_.input->read_tiles(part_, 0, spec_.x, spec_.x + spec_.width, top, top + count,
                                     spec_.z, spec_.z + 1, run.first, run.first + run.count, type,
                                     to, x, y);
    return file_.input->read_scanlines(part_, 0, top, top + count, spec_.z, run.first,
                                       run.first + run.count, type, to, x, y);
  }

  // The library would divide them by the largest one when it converts them to floats.
  void read_whole_numbers(const Run& run, int first, int count, float* to) const {
    std::vector<std::uint32_t> numbers(stride_ * static_cast<std::size_t>(spec_.width) *
                                       static_cast<std::size_t>(count));
    file_.check(read(run, first, count, OIIO::TypeUInt, numbers.data(), sizeof(std::uint32_t)));
    for (std::size_t i = 0; i + static_cast<std::size_t>(run.count) <= numbers.size(); i += stride_)
      for (std::size_t c = 0; c < static_cast<std::size_t>(run.count); ++c)
        to[i + c] = static_cast<float>(numbers[i + c]);
  }

  const OpenFile& file_;
  const OIIO::ImageSpec& spec_;
  int part_;
  bool is_grey_;
  std::vector<Run> runs_;
  std::size_t stride_;
};

// Takes the alpha channel, the last one, out of the picture. The colours of EXR are those over
// black; of other formats they are not defined without a background. Throws InputError there where
// a pixel is transparent.
void drop_alpha(ImageData& image, std::size_t stride, bool is_over_black) {
  std::size_t to = 0;
  bool transparent = false;
  for (std::size_t i = 0; i < image.values.size(); i += stride) {
    transparent = transparent || image.values[i + stride - 1] != 1;
    for (std::size_t c = 0; c + 1 < stride; ++c) image.values[to++] = image.values[i + c];
  }
  image.values.resize(to);
  if (!transparent) return;
  if (!is_over_black) throw InputError("has transparent pixels");
  image.notes.emplace_back("it has transparent pixels, which were read as they are over black");
}

// Reads by strips, so that a short file that claims to be large touches no more memory than it
// fills.
void read_values(const OpenFile& file, const LayerChoice& choice, ImageData& image) {
  constexpr std::size_t kStripValues = std::size_t{1} << 20;
  const OIIO::ImageSpec spec = file.input->spec();
  const bool is_exr = file.format.name == "openexr";
  const int alpha = is_exr ? choice.alpha : spec.alpha_channel;
  const RowReader reader(file, choice, alpha);
  const std::size_t row = reader.stride() * static_cast<std::size_t>(spec.width);
  const int unit = std::max(1, spec.tile_height);
  const int strip = unit * std::max(1, static_cast<int>(kStripValues / row) / unit);
  image.values.reserve(row * static_cast<std::size_t>(spec.height));
  for (int y = 0; y < spec.height; y += strip)
    reader.append(y, std::min(strip, spec.height - y), image.values);
  if (alpha >= 0) drop_alpha(image, reader.stride(), is_exr);
}

void set_window(const OIIO::ImageSpec& spec, ImageData& image) {
  constexpr std::int64_t kMost = 1 << 24;
  for (const std::int64_t number :
       {std::int64_t{spec.full_x} - spec.x, std::int64_t{spec.full_y} - spec.y,
        std::int64_t{spec.full_width}, std::int64_t{spec.full_height}})
    if (std::abs(number) > kMost) throw InputError("its display window is too large or too far");
  image.width = spec.width;
  image.height = spec.height;
  const PixelWindow whole{spec.full_x - spec.x, spec.full_y - spec.y, spec.full_width,
                          spec.full_height};
  if (whole != PixelWindow{0, 0, spec.width, spec.height}) image.whole = whole;
}

// The file's own fences and what it says of its colours that the library does not.
StatedColours check_before_opening(const std::string& bytes) {
  const std::string_view format = format_of(bytes).name;
  if (format == "openexr") check_exr_sizes(bytes);
  if (format == "pnm") check_pnm_header(bytes);
  if (format == "hdr") return check_hdr_header(bytes);
  return format == "png" ? check_png_chunks(bytes) : StatedColours();
}

// The variance of a mixture of channels depends on their covariance, which no file holds.
void leave_out_statistics(LayerChoice& choice, std::vector<std::string>& notes) {
  if (choice.others.empty()) return;
  notes.emplace_back(
      "its layers of variance and halves were left out, since its colours were converted");
  choice.others.clear();
}

// Tells what of a file is not used although it would change how the picture is shown.
void add_notes(const OpenFile& file, int part, std::vector<std::string>& notes) {
  const int orientation = file.input->spec().get_int_attribute("Orientation", 1);
  if (orientation != 1)
    notes.push_back(
        fmt::format("its pixels were not turned, although its orientation is {}", orientation));
  if (file.input->spec().get_string_attribute("jpeg:ColorSpace") == "CMYK")
    notes.emplace_back("its CMYK colours were converted without a profile");
  const float aspect = file.input->spec().get_float_attribute("PixelAspectRatio", 1);
  if (std::abs(aspect - 1) > 1e-3f)
    notes.push_back(
        fmt::format("its pixels are not square (ratio {:.4g}), which changes nothing", aspect));
  if (file.input->spec().tile_width == 0 || !file.format.holds_several()) return;
  if (file.input->seek_subimage(part, 1)) notes.emplace_back("its largest mip level was read");
  file.input->geterror();  // that of the seek behind the last level
  if (!file.input->seek_subimage(part, 0)) file.fail();
}

}  // namespace

ImageData decode(const std::string& bytes, const std::string& layer) {
  const StatedColours colours = check_before_opening(bytes);
  const OpenFile file(bytes);
  if (colours.has_profile && file.input->spec().find_attribute("ICCProfile") == nullptr)
    throw InputError("its ICC profile is damaged or not one of its kind of colours");
  LayerChoice choice = choose_layer(parts_of(file), layer);
  if (file.format.holds_several() && !file.input->seek_subimage(static_cast<int>(choice.part), 0))
    file.fail();
  const OIIO::ImageSpec& spec = file.input->spec();
  check_size(spec, file.format.name == "openexr", 3 + choice.others.size(), bytes.size());
  check_type(file, spec);
  ImageData image;
  image.notes = choice.notes;
  add_notes(file, static_cast<int>(choice.part), image.notes);
  set_window(spec, image);
  if (is_integer(spec.format)) image.integer_bits = static_cast<int>(8 * spec.format.basesize());
  const ColourDecoder decoder(spec, image.integer_bits > 0 ? std::exp2(image.integer_bits) - 1 : 0,
                              colours);
  image.notes.insert(image.notes.end(), decoder.notes().begin(), decoder.notes().end());
  if (decoder.mixes_channels()) leave_out_statistics(choice, image.notes);
  image.channels = {"R", "G", "B"};
  for (const LayerChoice::Channel& other : choice.others) image.channels.push_back(other.name);
  image.metadata = metadata_of(spec);
  read_values(file, choice, image);
  const std::size_t stride = image.channels.size();
  decoder.decode(image.values.data(), image.values.size() / stride, stride);
  return image;
}

}  // namespace raytracing::openimageio
