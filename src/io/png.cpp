#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <utility>
#include <vector>

#include "image_codecs.h"
#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

// libpng is C: its errors leave by longjmp, and no exception may pass through it. Nothing is
// allocated on the way, so the message has a fixed size.
struct PngError {
  std::array<char, 200> text{};

  std::string message() const { return text[0] != '\0' ? text.data() : "out of memory"; }
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  auto* error = static_cast<PngError*>(png_get_error_ptr(png));
  std::strncpy(error->text.data(), message, error->text.size() - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}  // about chunks that do not change the pixels

void on_write(png_structp png, png_bytep bytes, std::size_t count) {
  bool done = false;
  try {
    auto* output = static_cast<std::string*>(png_get_io_ptr(png));
    output->append(reinterpret_cast<const char*>(bytes), count);
    done = true;
  } catch (const std::exception&) {
  }
  if (!done) png_error(png, "out of memory");
}

void on_read(png_structp png, png_bytep bytes, std::size_t count) {
  auto* rest = static_cast<std::string_view*>(png_get_io_ptr(png));
  if (count > rest->size()) png_error(png, "the file is cut off");
  std::memcpy(bytes, rest->data(), count);
  rest->remove_prefix(count);
}

/// Owns libpng's two structures for writing.
class PngWriter {
 public:
  PngWriter(std::string& output, PngError& error)
      // A warning means that something was left out, which is an error here.
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, on_error, on_error)),
        info_(png_ ? png_create_info_struct(png_) : nullptr) {
    if (png_) png_set_write_fn(png_, &output, on_write, nullptr);
  }
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  /// False after an error. Holds nothing that a longjmp would have to destroy.
  bool write(int width, int height, const std::vector<png_text>& texts, const std::uint8_t* rgb) {
    if (!png_ || !info_) return false;
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
    png_write_info(png_, info_);
    const std::size_t row_bytes = 3 * static_cast<std::size_t>(width);
    for (int y = 0; y < height; ++y)
      png_write_row(png_, rgb + static_cast<std::size_t>(y) * row_bytes);
    png_write_end(png_, nullptr);
    return true;
  }

 private:
  png_structp png_;
  png_infop info_;
};

struct PngHeader {
  png_uint_32 width = 0, height = 0;
  std::size_t row_bytes = 0;  ///< of four samples a pixel, 8 or 16 bit
  bool wide = false;          ///< 16 bit
  png_fixed_point gamma = 0;  ///< times 100000; 0 = not given
};

/// Owns libpng's two structures for reading. Its members return false after an error, and hold
/// nothing that a longjmp would have to destroy.
class PngReader {
 public:
  PngReader(std::string_view& rest, PngError& error)
      : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &error, on_error, on_warning)),
        info_(png_ ? png_create_info_struct(png_) : nullptr) {
    if (png_) png_set_read_fn(png_, &rest, on_read);
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

std::vector<std::uint8_t> srgb_pixels(const ImageData& image) {
  std::vector<std::size_t> offsets;
  for (const char* name : {"R", "G", "B"}) {
    const auto found = std::find(image.channels.begin(), image.channels.end(), name);
    if (found == image.channels.end()) throw OutputError("PNG needs the channels R, G and B");
    offsets.push_back(static_cast<std::size_t>(found - image.channels.begin()));
  }
  const std::size_t stride = image.channels.size();
  std::vector<std::uint8_t> codes;
  codes.reserve(image.values.size() / stride * 3);
  for (std::size_t pixel = 0; pixel < image.values.size(); pixel += stride)
    for (const std::size_t offset : offsets) codes.push_back(srgb8(image.values[pixel + offset]));
  return codes;
}

// A tEXt chunk for ASCII, an iTXt chunk (UTF-8) for other text. Keeps pointers into its arguments.
png_text make_text(const std::string& name, std::string& value) {
  const bool ascii = std::all_of(value.begin(), value.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  png_text text{};
  text.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
  text.key = const_cast<char*>(name.c_str());  // libpng copies it
  text.text = value.data();
  (ascii ? text.text_length : text.itxt_length) = value.size();
  return text;
}

// Must pass before a row is decoded: DEFLATE never yields more than 1032 bytes for one, so a short
// file cannot hold what its header claims.
void check_header(const PngHeader& header, std::size_t file_bytes) {
  constexpr std::size_t kMostBytesForOne = 1032, kMostSamplesForByte = 32;  // 1 bit grey to RGBA
  check_image_size(header.width, header.height, 3);
  if (header.row_bytes * header.height / kMostSamplesForByte / kMostBytesForOne > file_bytes)
    throw InputError("damaged PNG image: too short for its size");
  constexpr png_fixed_point kSrgbGamma = 45455, kTolerance = 500;
  if (header.gamma != 0 && std::abs(header.gamma - kSrgbGamma) > kTolerance)
    throw InputError(fmt::format("its gamma is {:.5f}, not that of sRGB", 1e-5 * header.gamma));
}

// libpng allocates and clears the memory for a chunk before it finds out that the file is shorter.
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
  throw InputError("damaged PNG image: cut off within a chunk");
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

}  // namespace

std::string encode_png(const ImageData& image) {
  const std::vector<std::uint8_t> pixels = srgb_pixels(image);
  std::vector<std::string> values;
  for (const auto& entry : image.metadata) values.push_back(to_text(entry.second));
  std::vector<png_text> texts;
  for (std::size_t i = 0; i < values.size(); ++i)
    texts.push_back(make_text(image.metadata[i].first, values[i]));
  std::string bytes;
  PngError error;
  if (!PngWriter(bytes, error).write(image.width, image.height, texts, pixels.data()))
    throw OutputError("PNG: " + error.message());
  return bytes;
}

ImageData decode_png(const std::string& bytes) {
  check_chunk_sizes(bytes);
  std::string_view rest = bytes;
  PngError error;
  PngReader reader(rest, error);
  const auto expect = [&error](bool good) {
    if (!good) throw InputError("damaged PNG image: " + error.message());
  };
  PngHeader header;
  expect(reader.read_header(header));
  check_header(header, bytes.size());
  std::vector<png_byte> pixels(header.row_bytes * header.height);
  std::vector<png_bytep> rows(header.height);
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = pixels.data() + y * header.row_bytes;
  expect(reader.read_rows(rows.data()));
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
