#include "encode.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "description.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/srgb.h"

namespace raytracing::openimageio {
namespace {

// Not all that the library may write: its other formats are palettes, icons, textures or terminals,
// or do not write three channels of 8 bits to a file in memory.
constexpr const char* kEndings[] = {"exr",  "hdr", "tif", "tiff", "png", "jpg",
                                    "jpeg", "bmp", "dpx", "ppm",  "sgi", "tga"};

/// A file in memory, for formats that do not write through the library's own interface for that.
/// TIFF claims to, but OpenImageIO 2.4 then leaves out a part of its directory.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("image", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw OutputError("an image needs a file in memory, which is refused");
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

  std::string bytes() const {
    const off_t size = ::lseek(descriptor_, 0, SEEK_END);
    std::string bytes(static_cast<std::size_t>(std::max<off_t>(size, 0)), '\0');
    std::size_t used = 0;
    while (used < bytes.size()) {
      const ssize_t got =
          ::pread(descriptor_, bytes.data() + used, bytes.size() - used, static_cast<off_t>(used));
      if (got <= 0) throw OutputError("an image in memory cannot be read back");
      used += static_cast<std::size_t>(got);
    }
    return bytes;
  }

 private:
  int descriptor_;
};

// libjpeg would end the program.
void check_jpeg(const ImageData& image, const OIIO::ImageSpec& spec) {
  constexpr int kMostPixels = 65500;
  constexpr std::size_t kLongestText = 65000;  // of a segment of 2^16 bytes
  if (image.width > kMostPixels || image.height > kMostPixels)
    throw OutputError(fmt::format("JPEG images have at most {} pixels a side", kMostPixels));
  if (spec.get_string_attribute("ImageDescription").size() > kLongestText)
    throw OutputError("the facts of the run, with its command line, are too long for JPEG");
}

bool is_exr(const std::string& format) { return format == "openexr"; }

std::array<std::size_t, 3> rgb_offsets(const ImageData& image, const std::string& ending) {
  std::array<std::size_t, 3> offsets{};
  constexpr std::array names{"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto found = std::find(image.channels.begin(), image.channels.end(), names[c]);
    if (found == image.channels.end())
      throw OutputError("a picture in a ." + ending + " file needs the channels R, G and B");
    offsets[c] = static_cast<std::size_t>(found - image.channels.begin());
  }
  return offsets;
}

template <class Value, class Convert>
std::vector<Value> rgb_values(const ImageData& image, const std::string& ending, Convert convert) {
  const std::array<std::size_t, 3> offsets = rgb_offsets(image, ending);
  const std::size_t stride = image.channels.size();
  std::vector<Value> values;
  values.reserve(image.values.size() / stride * 3);
  for (std::size_t pixel = 0; pixel < image.values.size(); pixel += stride)
    for (const std::size_t offset : offsets)
      values.push_back(convert(image.values[pixel + offset]));
  return values;
}

OIIO::ImageSpec make_spec(const ImageData& image, const std::string& format, bool floats) {
  const int channels = is_exr(format) ? static_cast<int>(image.channels.size()) : 3;
  OIIO::ImageSpec spec(image.width, image.height, channels,
                       floats ? OIIO::TypeFloat : OIIO::TypeUInt8);
  if (is_exr(format)) spec.channelnames = image.channels;
  if (image.whole) {
    spec.x = -image.whole->x;
    spec.y = -image.whole->y;
    spec.full_width = image.whole->width;
    spec.full_height = image.whole->height;
  }
  spec.attribute("oiio:ColorSpace", floats ? "Linear" : "sRGB");
  if (is_exr(format) || format == "tiff") spec.attribute("compression", "zip");
  if (format == "png") spec.attribute("png:compressionLevel", 3);  // noise shrinks no further
  if (format == "jpeg") spec.attribute("Compression", "jpeg:95");
  set_metadata(image.metadata, format, spec);
  return spec;
}

}  // namespace

std::vector<std::string> endings() {
  std::vector<std::string> result;
  for (const char* ending : kEndings)
    if (OIIO::ImageOutput::create(std::string("image.") + ending)) result.emplace_back(ending);
  OIIO::geterror();  // those of formats that this library was built without
  return result;
}

std::string encode(const ImageData& image, const std::string& ending, bool floats) {
  const auto output = OIIO::ImageOutput::create("image." + ending);
  const auto check = [&](bool good) {
    if (good) return;
    const std::string why = output ? output->geterror() : OIIO::geterror();
    throw OutputError(fmt::format("a .{} image cannot be made: {}", ending,
                                  one_line(why.empty() ? "no reason is given" : why)));
  };
  check(output != nullptr);
  const std::string format = output->format_name();
  const OIIO::ImageSpec spec = make_spec(image, format, floats);
  if (format == "jpeg") check_jpeg(image, spec);
  std::vector<float> values;
  std::vector<std::uint8_t> codes;
  if (floats && !is_exr(format))
    values = rgb_values<float>(image, ending, [](float value) { return value; });
  if (!floats) codes = rgb_values<std::uint8_t>(image, ending, srgb8);
  OIIO::Filesystem::IOVecOutput memory;
  std::optional<MemoryFile> file;
  if (format == "tiff" || !output->supports("ioproxy") || !output->set_ioproxy(&memory))
    file.emplace();
  check(output->open(file ? file->path() : "image." + ending, spec));
  if (floats)
    check(
        output->write_image(OIIO::TypeFloat, is_exr(format) ? image.values.data() : values.data()));
  else
    check(output->write_image(OIIO::TypeUInt8, codes.data()));
  check(output->close());
  std::string bytes =
      file ? file->bytes() : std::string(memory.buffer().begin(), memory.buffer().end());
  check(!bytes.empty());
  return format == "png" ? with_other_texts(image.metadata, std::move(bytes)) : bytes;
}

}  // namespace raytracing::openimageio
