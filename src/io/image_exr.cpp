#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "image_encoders.h"
#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

/// Lets OpenEXR write into memory. It seeks back once, to fill in the table of line offsets.
class StringStream : public Imf::OStream {
 public:
  StringStream() : Imf::OStream("image.exr") {}

  void write(const char bytes[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    bytes_.resize(std::max(bytes_.size(), position_ + size));
    std::copy_n(bytes, size, bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
    position_ += size;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

void insert_attribute(Imf::Header& header, const char* name, const std::string& value) {
  header.insert(name, Imf::StringAttribute(value));
}

void insert_attribute(Imf::Header& header, const char* name, double value) {
  header.insert(name, Imf::DoubleAttribute(value));
}

void insert_attribute(Imf::Header& header, const char* name, bool value) {
  insert_attribute(header, name, to_text(value));  // EXR has no attribute that is true or false
}

/// EXR has no 64-bit integers: what does not fit 32 bits becomes text, so that no digit is lost.
void insert_attribute(Imf::Header& header, const char* name, std::int64_t value) {
  if (value >= std::numeric_limits<std::int32_t>::min() &&
      value <= std::numeric_limits<std::int32_t>::max()) {
    header.insert(name, Imf::IntAttribute(static_cast<std::int32_t>(value)));
  } else {
    header.insert(name, Imf::StringAttribute(std::to_string(value)));
  }
}

Imf::Header make_header(const ImageData& image) {
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const std::string& channel : image.channels) {
    header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  }
  for (const auto& [name, value] : image.metadata) {
    // A second attribute of this name, or one that EXR defines, would be replaced in silence.
    if (header.find(name) != header.end()) {
      throw OutputError("an image's attribute '" + name + "' is taken");
    }
    // Named anew: before C++20 was amended, a lambda could not capture a structured binding.
    const char* const attribute = name.c_str();
    std::visit([&](const auto& v) { insert_attribute(header, attribute, v); }, value);
  }
  return header;
}

Imf::FrameBuffer make_frame_buffer(const ImageData& image) {
  const std::size_t pixel_bytes = image.channels.size() * sizeof(float);
  const std::size_t row_bytes = pixel_bytes * static_cast<std::size_t>(image.width);
  // OpenEXR only reads through this pointer, but takes one type for reading and writing.
  char* base = reinterpret_cast<char*>(const_cast<float*>(image.values.data()));
  Imf::FrameBuffer buffer;
  for (const std::string& channel : image.channels) {
    buffer.insert(channel, Imf::Slice(Imf::FLOAT, base, pixel_bytes, row_bytes));
    base += sizeof(float);
  }
  return buffer;
}

}  // namespace

std::string encode_exr(const ImageData& image) {
  try {
    StringStream stream;
    {
      Imf::OutputFile file(stream, make_header(image));
      file.setFrameBuffer(make_frame_buffer(image));
      file.writePixels(image.height);
    }  // the table of line offsets is written when `file` goes
    return stream.take();
  } catch (const OutputError&) {
    throw;
  } catch (const std::exception& error) {
    throw OutputError(std::string("EXR: ") + error.what());
  }
}

}  // namespace raytracing
