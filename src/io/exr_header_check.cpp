#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "image_codecs.h"
#include "raytracing/io/errors.h"

namespace raytracing {
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

void check_value(std::string_view type, std::string_view value) {
  constexpr std::size_t kChannel = 16;  // bytes behind its name
  Reader reader(value);
  if (type == "chlist") {
    while (!reader.name().empty()) reader.take(kChannel);
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

}  // namespace

void check_exr_header_sizes(const std::string& bytes) {
  Reader reader(bytes);
  reader.take(kMagicAndVersion - sizeof(std::uint32_t));
  const bool several = (reader.word() & kMultiPartFlag) != 0;
  bool any = true;
  while (any) {  // an empty header ends those of a file of several parts
    any = false;
    while (!reader.name().empty()) {
      any = several;
      const std::string_view type = reader.name();
      if (type == "idmanifest") throw InputError("attributes of type idmanifest cannot be read");
      check_value(type, reader.take(reader.word()));
    }
  }
}

}  // namespace raytracing
