// Fuzzes the EXR reader. OpenEXR is the system's library, without the instrumentation of sanitizers
// and fuzzer: only accesses to memory that our code allocates are checked. Data windows are made
// small; tests/io/decode_image_test.cpp covers huge ones, which are slow here.

#include "fuzz_picture.h"

namespace {

void shrink_window(std::string& bytes) {
  constexpr std::string_view kWindow("dataWindow\0box2i", 16);
  const std::size_t at = bytes.find(kWindow);
  const std::size_t numbers = at + kWindow.size() + 1 + 4;  // behind the type's end and the size
  if (at == std::string::npos || numbers + 16 > bytes.size()) return;
  for (const std::size_t number : {0u, 4u, 8u, 12u})  // the low bytes stay: at most 4096 pixels
    bytes[numbers + number + 2] = bytes[numbers + number + 3] = '\0';
  for (const std::size_t number : {0u, 4u, 8u, 12u}) bytes[numbers + number + 1] &= 0x0f;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  shrink_window(bytes);
  raytracing::fuzz::read_picture(bytes);
  return 0;
}
