// Writes FOLDER/hills.toml and the files it names: a scene of 2 N^2 triangles and a square light.
//   make_hills FOLDER N

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "bench/hills.h"

int main(int argc, char** argv) {
  const long n = argc == 3 ? std::atol(argv[2]) : 0;
  if (n < 1) {
    std::fputs("usage: make_hills FOLDER N\n", stderr);
    return 2;
  }
  const std::string folder = argv[1];
  std::ofstream(folder + "/hills.toml") << R"([film]
width = 256
height = 256
[camera]
origin = [0, 0.7, 1.2]
target = [0, 0, 0.05]
up = [0, 1, 0]
fov = 45
[[models]]
obj = "hills.obj"
)";
  std::ofstream(folder + "/hills.mtl") << "newmtl ground\nKd 0.7 0.6 0.5\n"
                                          "newmtl light\nKd 0 0 0\nKe 20 20 20\n";
  std::ofstream obj(folder + "/hills.obj", std::ios::binary);
  const std::string text = raytracing::hills_obj(static_cast<std::size_t>(n));
  obj << "mtllib hills.mtl\n" << text
      << "usemtl light\nv -0.2 0.6 -0.4\nv 0.2 0.6 -0.4\nv 0.2 0.6 0\nv -0.2 0.6 0\n"
         "f -4 -3 -2 -1\n";
  return obj.flush() ? 0 : 4;
}
