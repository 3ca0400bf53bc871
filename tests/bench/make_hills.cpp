// Writes FOLDER/hills.toml and the files it names: a scene of 2 N^2 triangles and a square light.
//   make_hills FOLDER N

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

#include "bench/hills.h"

namespace {

void write(const std::string& path, std::initializer_list<std::string_view> parts) {
  std::ofstream file(path, std::ios::binary);
  for (const std::string_view part : parts) file << part;
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

void write_scene(const std::string& folder, std::size_t n) {
  write(folder + "/hills.toml", {R"([film]
width = 256
height = 256
[camera]
origin = [0, 0.7, 1.2]
target = [0, 0, 0.05]
up = [0, 1, 0]
fov = 45
[[models]]
obj = "hills.obj"
)"});
  write(folder + "/hills.mtl",
        {"newmtl ground\nKd 0.7 0.6 0.5\nnewmtl light\nKd 0 0 0\nKe 20 20 20\n"});
  write(folder + "/hills.obj",
        {"mtllib hills.mtl\n", raytracing::hills_obj(n),
         "usemtl light\nv -0.2 0.6 -0.4\nv 0.2 0.6 -0.4\nv 0.2 0.6 0\nv -0.2 0.6 0\n"
         "f -4 -3 -2 -1\n"});
}

}  // namespace

int main(int argc, char** argv) {
  const long n = argc == 3 ? std::atol(argv[2]) : 0;
  if (n < 1) {
    std::fputs("usage: make_hills FOLDER N\n", stderr);
    return 2;
  }
  try {
    write_scene(argv[1], static_cast<std::size_t>(n));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_hills: %s\n", error.what());
    return 4;
  }
}
