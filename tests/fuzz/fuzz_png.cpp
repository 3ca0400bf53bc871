// Fuzzes the PNG reader. The checksum of each chunk is corrected, or hardly any input would get
// past the checksums. libpng is the system's library, without instrumentation.

#include <zlib.h>

#include "fuzz_picture.h"

namespace {

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

void repair_checksums(std::string& bytes) {
  constexpr std::size_t kSignature = 8, kNameAndLength = 8, kChecksum = 4;
  for (std::size_t at = kSignature; at + kNameAndLength + kChecksum <= bytes.size();) {
    const std::size_t length = big_endian(bytes, at);
    if (length > bytes.size() - at - kNameAndLength - kChecksum) return;
    const auto* name = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
    const auto sum = static_cast<std::uint32_t>(crc32(0, name, static_cast<uInt>(4 + length)));
    at += kNameAndLength + length;
    for (std::size_t i = 0; i < 4; ++i, ++at) bytes[at] = static_cast<char>(sum >> (24 - 8 * i));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  repair_checksums(bytes);
  raytracing::fuzz::read_picture(bytes);
  return 0;
}
