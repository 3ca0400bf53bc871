#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "fences.h"
#include "raytracing/io/errors.h"

namespace raytracing::openimageio {
namespace {

constexpr std::size_t kMagicAndVersion = 8;
constexpr std::uint32_t kMultiPartFlag = 0x1000;

struct FixedSize {
  std::string_view type;
  std::size_t size;
};
constexpr FixedSize kFixedSizes[] = {{"box2i", 16},      {"box2f", 16},    {"chromaticities", 32},
                                     {"compression", 1}, {"double", 8},    {"envmap", 1},
                                     {"float", 4},       {"int", 4},       {"keycode", 28},
                                     {"m33f", 36},       {"m33d", 72},     {"m44f", 64},
                                     {"m44d", 128},      {"v2i", 8},       {"v2f", 8},
                                     {"v2d", 16},        {"v3i", 12},      {"v3f", 12},
                                     {"v3d", 24},        {"lineOrder", 1}, {"rational", 8},
                                     {"tiledesc", 9},    {"timecode", 8},  {"deepImageState", 1}};

[[noreturn]] void fail() { throw InputError("its header is cut off or contradicts itself"); }

// Takes one item after the other from the front of the bytes.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  bool empty() const { return rest_.empty(); }
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) fail();
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  std::string_view name() {
    const std::size_t end = rest_.find('\0');
    if (end == std::string_view::npos) fail();
    const std::string_view taken = take(end);
    take(1);
    return taken;
  }
  std::uint32_t word() {
    static_assert(std::endian::native == std::endian::little);
    std::uint32_t value = 0;
    std::memcpy(&value, take(sizeof(value)).data(), sizeof(value));
    return value;
  }

 private:
  std::string_view rest_;
};

// The library ends the program when it meets a type of values that it does not know.
void check_channel(Reader& reader) {
  constexpr std::uint32_t kTypes = 3;         // uint, half and float
  constexpr std::size_t kBehindTheType = 12;  // bytes: linearity and sampling
  if (reader.word() >= kTypes) fail();
  reader.take(kBehindTheType);
}

void check_value(std::string_view type, std::string_view value) {
  Reader reader(value);
  if (type == "chlist") {
    while (!reader.name().empty()) check_channel(reader);
    if (!reader.empty()) fail();
  } else if (type == "stringvector") {
    while (!reader.empty()) reader.take(reader.word());
  } else if (type == "preview") {
    const std::uint64_t width = reader.word(), height = reader.word();
    if (width > value.size() || height > value.size() || 4 * width * height != value.size() - 8)
      fail();
  } else {
    for (const FixedSize& known : kFixedSizes)
      if (type == known.type && value.size() != known.size) fail();
  }
}

// The sizes that a header promises: OpenEXR takes memory for its tiles, for some rows at once and
// for the table of its chunks of pixels before it reads them.
class PromisedSizes {
 public:
  void read(std::string_view name, std::string_view type, std::string_view value) {
    Reader reader(value);
    if (name == "dataWindow" && type == "box2i") {
      const std::int64_t left = signed_word(reader), top = signed_word(reader);
      width_ = signed_word(reader) - left + 1;
      height_ = signed_word(reader) - top + 1;
      constexpr std::int64_t kMaxSide = 65536;
      if (width_ > kMaxSide || height_ > kMaxSide)
        throw InputError(fmt::format("{}x{} pixels are more than can be read", width_, height_));
    } else if (name == "channels" && type == "chlist") {
      channels_ = 0;
      for (; !reader.name().empty(); ++channels_) check_channel(reader);
    } else if (name == "tiles" && type == "tiledesc") {
      tile_width_ = reader.word();
      tile_height_ = reader.word();
      constexpr std::int64_t kMostPixels = 1 << 24;  // for which OpenEXR takes memory at once
      if (tile_width_ > 0 && tile_height_ > kMostPixels / tile_width_)
        throw InputError("its tiles are larger than can be read");
    }
  }

  /// Throws InputError for a row of more values than can be read.
  void check_row() const {
    constexpr std::int64_t kMostValues = 1 << 22;
    if (width_ * channels_ > kMostValues)
      throw InputError(fmt::format("rows of {} pixels with {} channels are more than can be read",
                                   width_, channels_));
  }

  /// The number of chunks of the largest level, or less.
  std::int64_t least_chunks() const {
    constexpr std::int64_t kMostRows = 256;  // of any compression
    if (width_ < 1 || height_ < 1) return 0;
    if (tile_width_ < 1 || tile_height_ < 1) return (height_ - 1) / kMostRows + 1;
    return ((width_ - 1) / tile_width_ + 1) * ((height_ - 1) / tile_height_ + 1);
  }

 private:
  static std::int64_t signed_word(Reader& reader) {
    return static_cast<std::int32_t>(reader.word());
  }

  std::int64_t width_ = 0, height_ = 0, channels_ = 0, tile_width_ = 0, tile_height_ = 0;
};

// Reads the attributes of one part; false when there are none.
bool check_part(Reader& reader, std::size_t file_bytes) {
  PromisedSizes sizes;
  bool any = false;
  for (std::string_view name = reader.name(); !name.empty(); name = reader.name()) {
    any = true;
    const std::string_view type = reader.name();
    if (type == "idmanifest") throw InputError("attributes of type idmanifest cannot be read");
    const std::string_view value = reader.take(reader.word());
    check_value(type, value);
    sizes.read(name, type, value);
  }
  sizes.check_row();
  if (static_cast<std::uint64_t>(sizes.least_chunks()) > file_bytes / sizeof(std::uint64_t))
    throw InputError("is too short for its tiles or rows");
  return any;
}

}  // namespace

void check_exr_sizes(const std::string& bytes) {
  Reader reader(bytes);
  reader.take(kMagicAndVersion - sizeof(std::uint32_t));
  const bool several = (reader.word() & kMultiPartFlag) != 0;
  while (check_part(reader, bytes.size()) && several) {  // an empty header ends several parts
  }
}

}  // namespace raytracing::openimageio
