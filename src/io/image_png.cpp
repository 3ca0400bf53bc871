#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <vector>

#include "image_encoders.h"
#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

/// What libpng's callbacks share with encode_png.
struct PngOutput {
  std::string bytes;
  std::string error;
};

// libpng is C: its errors leave by longjmp, and no exception may pass through it.

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  static_cast<PngOutput*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}

void on_write(png_structp png, png_bytep bytes, std::size_t count) {
  bool done = false;
  try {
    auto* output = static_cast<PngOutput*>(png_get_io_ptr(png));
    output->bytes.append(reinterpret_cast<const char*>(bytes), count);
    done = true;
  } catch (const std::exception&) {
  }
  if (!done) png_error(png, "out of memory");
}

/// Owns libpng's two structures.
class PngWriter {
 public:
  explicit PngWriter(PngOutput& output)
      // A warning means that something was left out: take it for an error.
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &output, on_error, on_error)),
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
    for (int y = 0; y < height; ++y) {
      png_write_row(png_, rgb + static_cast<std::size_t>(y) * row_bytes);
    }
    png_write_end(png_, nullptr);
    return true;
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
  for (std::size_t pixel = 0; pixel < image.values.size(); pixel += stride) {
    for (const std::size_t offset : offsets) codes.push_back(srgb8(image.values[pixel + offset]));
  }
  return codes;
}

/// A tEXt chunk for ASCII, an iTXt chunk (UTF-8) for the rest. Keeps pointers into its arguments.
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

}  // namespace

std::string encode_png(const ImageData& image) {
  const std::vector<std::uint8_t> pixels = srgb_pixels(image);
  std::vector<std::string> values;
  for (const auto& entry : image.metadata) values.push_back(to_text(entry.second));
  std::vector<png_text> texts;
  for (std::size_t i = 0; i < values.size(); ++i) {
    texts.push_back(make_text(image.metadata[i].first, values[i]));
  }
  PngOutput output;
  if (!PngWriter(output).write(image.width, image.height, texts, pixels.data())) {
    throw OutputError("PNG: " + (output.error.empty() ? "out of memory" : output.error));
  }
  return std::move(output.bytes);
}

}  // namespace raytracing
