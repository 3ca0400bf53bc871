// Fuzzes the TIFF reader. libtiff is the system's library, without instrumentation. Images are made
// small, in files of little-endian numbers, since large ones are slow here.

#include "fuzz_picture.h"

namespace {

std::size_t number_at(const std::string& bytes, std::size_t at, std::size_t count) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < count; ++i)
    number |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + i])) << 8 * i;
  return number;
}

// Leaves at most 255 pixels a side in the first directory, whose entries have 12 bytes: tag, type,
// count and value.
void shrink(std::string& bytes) {
  constexpr std::size_t kEntry = 12, kValue = 8, kWidth = 256, kHeight = 257;
  if (!bytes.starts_with("II*") || bytes.size() < 8) return;
  const std::size_t directory = number_at(bytes, 4, 4);
  if (directory > bytes.size() - 2) return;
  const std::size_t entries = number_at(bytes, directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + i * kEntry;
    if (at + kEntry > bytes.size()) return;
    const std::size_t tag = number_at(bytes, at, 2);
    if (tag != kWidth && tag != kHeight) continue;
    for (std::size_t byte = 1; byte < 4; ++byte) bytes[at + kValue + byte] = '\0';
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  shrink(bytes);
  raytracing::fuzz::read_picture(bytes);
  return 0;
}
