// Fuzzes the TIFF reader. libtiff is the system's library, without instrumentation.

#include "fuzz_picture.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  raytracing::fuzz::read_picture(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
