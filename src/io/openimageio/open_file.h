#pragma once
// An image file in memory, opened by the library.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace raytracing::openimageio {

/// A kind of file, by its first bytes.
struct Format {
  std::string_view magic;
  std::string_view name;   ///< of OpenImageIO
  std::string_view title;  ///< for messages

  /// Whether a file can hold several images or mip levels.
  bool holds_several() const { return name == "openexr" || name == "tiff"; }
};

/// Returns the format of a file by its first bytes. Throws InputError, with a list of formats.
const Format& format_of(const std::string& bytes);

/// A file in memory. The library's own class reads beyond the end when it is asked for bytes that
/// begin behind it.
class MemoryReader : public OIIO::Filesystem::IOMemReader {
 public:
  explicit MemoryReader(const std::string& bytes)
      : IOMemReader(const_cast<char*>(bytes.data()), bytes.size()) {}

  std::size_t pread(void* to, std::size_t count, std::int64_t offset) override;
};

/// A file that the library has opened, at its first image.
struct OpenFile {
  const Format& format;
  MemoryReader memory;
  std::unique_ptr<OIIO::ImageInput> input;

  /// Keeps a reference to the bytes. Throws InputError.
  explicit OpenFile(const std::string& bytes);
  OpenFile(const OpenFile&) = delete;  // the library keeps the address of `memory`
  OpenFile& operator=(const OpenFile&) = delete;

  /// Throws InputError with what the library says of its last failure.
  [[noreturn]] void fail() const;
  /// Throws InputError unless what the library did was good. It also returns true after failures
  /// that it only reports, such as a strip of TIFF that is cut off.
  void check(bool good) const;

 private:
  [[noreturn]] void fail(std::string why) const;
};

}  // namespace raytracing::openimageio
