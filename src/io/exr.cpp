#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfTileDescription.h>
#include <ImfVersion.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <string_view>

#include "image_codecs.h"
#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

/// Lets OpenEXR write to memory. It seeks back once, to fill in the table of line offsets.
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

// EXR knows neither 64-bit integers nor truth values: what does not fit a type of EXR becomes text,
// so that no digit is lost.
void insert_attribute(Imf::Header& header, const char* name, const FactValue& value) {
  const auto* whole = std::get_if<std::int64_t>(&value);
  if (whole && *whole >= INT32_MIN && *whole <= INT32_MAX)
    header.insert(name, Imf::IntAttribute(static_cast<std::int32_t>(*whole)));
  else if (const auto* real = std::get_if<double>(&value))
    header.insert(name, Imf::DoubleAttribute(*real));
  else
    header.insert(name, Imf::StringAttribute(to_text(value)));
}

Imf::Header make_header(const ImageData& image) {
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const std::string& channel : image.channels)
    header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  for (const auto& [name, value] : image.metadata) {
    // A second attribute of this name, or one that EXR defines, would be replaced silently.
    if (header.find(name) != header.end())
      throw OutputError("an image's attribute '" + name + "' is taken");
    insert_attribute(header, name.c_str(), value);
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

constexpr std::size_t kMagicAndVersion = 8;

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  static_assert(std::endian::native == std::endian::little);
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof(word));
  return word;
}

Imf::Header read_header(const std::string& bytes, Imf::IStream& stream) {
  if (bytes.size() <= kMagicAndVersion) throw InputError("its header is cut off");
  auto version = static_cast<int>(word_at(bytes, 4));
  if (version & Imf::NON_IMAGE_FLAG) throw InputError("deep images cannot be read");
  check_exr_header_sizes(bytes);
  stream.seekg(kMagicAndVersion);
  Imf::Header header;
  header.readFrom(stream, version);
  stream.seekg(0);
  return header;
}

// The channels R, G, B and then the others, in the order of the file.
std::vector<std::string> channel_names(const Imf::Header& header) {
  std::vector<std::string> names = {"R", "G", "B"};
  std::size_t found = 0;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
    const std::string_view name = c.name();
    if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
      throw InputError("its channel " + std::string(name) + " is subsampled");
    const bool colour = name == "R" || name == "G" || name == "B";
    found += colour;
    if (!colour) names.emplace_back(name);
  }
  if (found != 3) throw InputError("has no channels R, G and B");
  return names;
}

void check_sizes(const Imf::Header& header, std::size_t channels, std::size_t file_bytes) {
  const auto& window = header.dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
  const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
  check_image_size(width, height, channels);
  if (!header.hasTileDescription()) return;
  const auto& tile = header.tileDescription();
  check_image_size(width, tile.ySize, channels);  // OpenEXR keeps one row of tiles
  check_image_size(tile.xSize, tile.ySize, channels);
  // OpenEXR allocates the table of tile offsets before it reads it.
  const std::int64_t across = (width - 1) / tile.xSize + 1, down = (height - 1) / tile.ySize + 1;
  if (static_cast<std::uint64_t>(across * down) > file_bytes / sizeof(std::uint64_t))
    throw InputError("is too short for its tiles");
}

ImageMetadata metadata(const Imf::Header& header) {
  ImageMetadata result;
  for (auto a = header.begin(); a != header.end(); ++a) {
    const Imf::Attribute& value = a.attribute();
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&value))
      result.emplace_back(a.name(), text->value());
    else if (const auto* whole = dynamic_cast<const Imf::IntAttribute*>(&value))
      result.emplace_back(a.name(), std::int64_t{whole->value()});
    else if (const auto* real = dynamic_cast<const Imf::DoubleAttribute*>(&value))
      result.emplace_back(a.name(), real->value());
    else if (const auto* single = dynamic_cast<const Imf::FloatAttribute*>(&value))
      result.emplace_back(a.name(), double{single->value()});
  }
  return result;
}

// Reads by strips, so that a short file that claims to be large touches no more memory than it
// fills.
void read_values(Imf::InputFile& file, ImageData& image) {
  constexpr std::size_t kStripValues = std::size_t{1} << 18;
  const auto& window = file.header().dataWindow();
  const std::size_t pixel_values = image.channels.size();
  const std::size_t row_values = pixel_values * static_cast<std::size_t>(image.width);
  const int strip = std::max(1, static_cast<int>(kStripValues / row_values));
  image.values.reserve(row_values * static_cast<std::size_t>(image.height));  // not moved later
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < pixel_values; ++c)
    buffer.insert(image.channels[c],
                  Imf::Slice::Make(Imf::FLOAT, image.values.data() + c, window,
                                   pixel_values * sizeof(float), row_values * sizeof(float)));
  file.setFrameBuffer(buffer);
  for (int y = 0; y < image.height; y += strip) {
    const int end = std::min(y + strip, image.height);
    image.values.resize(row_values * static_cast<std::size_t>(end));
    file.readPixels(window.min.y + y, window.min.y + end - 1);
  }
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

ImageData decode_exr(const std::string& bytes) {
  try {
    Imf::StdISStream stream;
    stream.str(bytes);
    const Imf::Header header = read_header(bytes, stream);
    ImageData image;
    image.channels = channel_names(header);
    check_sizes(header, image.channels.size(), bytes.size());
    Imf::InputFile file(stream);
    // The parts of a file may contradict each other: the size that was checked must be the one
    // read.
    if (file.header().dataWindow() != header.dataWindow())
      throw InputError("contradicts itself about its size");
    const auto& window = header.dataWindow();
    image.width = window.max.x - window.min.x + 1;
    image.height = window.max.y - window.min.y + 1;
    image.metadata = metadata(header);
    read_values(file, image);
    return image;
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(std::string("damaged EXR image: ") + error.what());
  }
}

}  // namespace raytracing
