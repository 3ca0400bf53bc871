#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "image_decoders.h"
#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

/// What libpng's callbacks share with decode_png.
struct PngInput {
  const std::string& bytes;
  std::size_t position = 0;
  std::array<char, 200> error{};  // of fixed size: nothing may be allocated between C frames
};

// libpng is C: its errors leave by longjmp, and no exception may pass through it.

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  auto* input = static_cast<PngInput*>(png_get_error_ptr(png));
  std::strncpy(input->error.data(), message, input->error.size() - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}  // about chunks that do not change the pixels

void on_read(png_structp png, png_bytep bytes, std::size_t count) {
  auto* input = static_cast<PngInput*>(png_get_io_ptr(png));
  if (count > input->bytes.size() - input->position) png_error(png, "the file is cut off");
  std::memcpy(bytes, input->bytes.data() + input->position, count);
  input->position += count;
}

struct PngHeader {
  png_uint_32 width = 0, height = 0;
  std::size_t row_bytes = 0;  ///< of four samples a pixel, 8 or 16 bit
  bool wide = false;          ///< 16 bit
  png_fixed_point gamma = 0;  ///< times 100000; 0 = not given
};

/// Owns libpng's two structures. Its members return false after an error, and hold nothing that a
/// longjmp would have to destroy.
class PngReader {
 public:
  explicit PngReader(PngInput& input)
      : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &input, on_error, on_warning)),
        info_(png_ ? png_create_info_struct(png_) : nullptr) {
    if (png_) png_set_read_fn(png_, &input, on_read);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  bool read_header(PngHeader& header) {
    if (!png_ || !info_) return false;
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_user_limits(png_, 65536, 65536);
    png_set_chunk_malloc_max(png_, png_alloc_size_t{1} << 24);
    png_read_info(png_, info_);
    header.width = png_get_image_width(png_, info_);
    header.height = png_get_image_height(png_, info_);
    header.wide = png_get_bit_depth(png_, info_) == 16;
    if (!png_get_valid(png_, info_, PNG_INFO_sRGB)) png_get_gAMA_fixed(png_, info_, &header.gamma);
    png_set_expand(png_);  // palettes, 1 to 4 bits, and transparent colours as alpha
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, 0xffff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    header.row_bytes = png_get_rowbytes(png_, info_);
    return true;
  }

  bool read_rows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_image(png_, rows);
    png_read_end(png_, info_);
    return true;
  }

  ImageMetadata texts() const {
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(png_, info_, &texts, &count);
    ImageMetadata result;
    for (int i = 0; i < count; ++i)
      result.emplace_back(texts[i].key, std::string(texts[i].text ? texts[i].text : ""));
    return result;
  }

 private:
  png_structp png_;
  png_infop info_;
};

// Before a row is decoded: DEFLATE never yields more than 1032 bytes for one, so that a short file
// cannot hold what its header claims.
void check_header(const PngHeader& header, std::size_t file_bytes) {
  constexpr std::size_t kMostBytesForOne = 1032, kMostSamplesForByte = 32;  // 1 bit grey to RGBA
  check_image_size(header.width, header.height, 3);
  if (header.row_bytes * header.height / kMostSamplesForByte / kMostBytesForOne > file_bytes)
    throw InputError("damaged PNG picture: too short for its size");
  constexpr png_fixed_point kSrgbGamma = 45455, kTolerance = 500;
  if (header.gamma != 0 && std::abs(header.gamma - kSrgbGamma) > kTolerance)
    throw InputError(fmt::format("its gamma is {:.5f}, not that of sRGB", 1e-5 * header.gamma));
}

// libpng makes room for a chunk, and clears it, before it finds out that the file is shorter.
void check_chunk_sizes(const std::string& bytes) {
  constexpr std::size_t kSignature = 8, kLengthAndName = 8, kChecksum = 4;
  std::size_t at = kSignature;
  while (bytes.size() - at >= kLengthAndName) {
    const auto* p = reinterpret_cast<const png_byte*>(bytes.data() + at);
    const std::size_t length = png_get_uint_32(p);
    if (bytes.compare(at + 4, 4, "IEND") == 0) return;
    at += kLengthAndName;
    if (length + kChecksum > bytes.size() - at) break;
    at += length + kChecksum;
  }
  throw InputError("damaged PNG picture: cut off within a chunk");
}

std::vector<float> linear_values(const PngHeader& header, const std::vector<png_byte>& bytes) {
  const std::size_t most = header.wide ? 65535 : 255;
  std::vector<float> linear(most + 1);
  for (std::size_t code = 0; code <= most; ++code)
    linear[code] =
        static_cast<float>(srgb_to_linear(static_cast<double>(code) / static_cast<double>(most)));
  const std::size_t sample_bytes = header.wide ? 2 : 1;
  std::vector<float> values;
  values.reserve(bytes.size() / sample_bytes / 4 * 3);
  for (std::size_t sample = 0; sample < bytes.size() / sample_bytes; ++sample) {
    const png_byte* at = bytes.data() + sample * sample_bytes;
    const std::size_t code = header.wide ? std::size_t{at[0]} << 8 | at[1] : std::size_t{at[0]};
    if (sample % 4 != 3)
      values.push_back(linear[code]);
    else if (code != most)
      throw InputError("has transparent pixels");
  }
  return values;
}

[[noreturn]] void fail(const PngInput& input) {
  throw InputError("damaged PNG picture: " +
                   std::string(input.error[0] != '\0' ? input.error.data() : "out of memory"));
}

}  // namespace

ImageData decode_png(const std::string& bytes) {
  check_chunk_sizes(bytes);
  PngInput input{bytes};
  PngReader reader(input);
  PngHeader header;
  if (!reader.read_header(header)) fail(input);
  check_header(header, bytes.size());
  std::vector<png_byte> pixels(header.row_bytes * header.height);
  std::vector<png_bytep> rows(header.height);
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = pixels.data() + y * header.row_bytes;
  if (!reader.read_rows(rows.data())) fail(input);
  ImageData image;
  image.width = static_cast<int>(header.width);
  image.height = static_cast<int>(header.height);
  image.channels = {"R", "G", "B"};
  image.values = linear_values(header, pixels);
  image.integer_bits = header.wide ? 16 : 8;
  image.metadata = reader.texts();
  return image;
}

}  // namespace raytracing
