#pragma once
// A model of any size, the same bytes every time: hills over a square, a normal at each vertex.

#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace raytracing {

/// OBJ text of 2 n^2 triangles, 1 wide and deep, y up: v, vn and "f a//a b//b c//c".
inline std::string hills_obj(std::size_t n) {
  std::string text = "usemtl ground\n";
  text.reserve((n + 1) * (n + 1) * 58 + 2 * n * n * 56);
  const auto put = [&](const char* before, auto value, auto... format) {
    char digits[32];
    text += before;
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value, format...).ptr);
  };
  const auto record = [&](const char* keyword, double x, double y, double z) {
    put(keyword, x, std::chars_format::fixed, 6);
    put(" ", y, std::chars_format::fixed, 6);
    put(" ", z, std::chars_format::fixed, 6);
    text += '\n';
  };
  const double step = 1 / static_cast<double>(n);
  for (const bool normals : {false, true}) {
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t j = 0; j <= n; ++j) {
        const double x = step * static_cast<double>(i) - 0.5;
        const double z = step * static_cast<double>(j) - 0.5;
        // Two waves, of which each normal is the gradient.
        const double ripple = 0.004 * std::sin(90 * (x + z));
        const double y = 0.05 * std::sin(17 * x) * std::cos(13 * z) + ripple;
        const double both = 0.36 * std::cos(90 * (x + z));
        const double dx = 0.85 * std::cos(17 * x) * std::cos(13 * z) + both;
        const double dz = -0.65 * std::sin(17 * x) * std::sin(13 * z) + both;
        const double length = std::sqrt(dx * dx + 1 + dz * dz);
        if (normals) {
          record("vn ", -dx / length, 1 / length, -dz / length);
        } else {
          record("v ", x, y, z);
        }
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t a = i * (n + 1) + j + 1, b = a + n + 1;
      for (const auto& [second, third] : {std::pair{b + 1, b}, std::pair{a + 1, b + 1}}) {
        text += 'f';
        for (const std::size_t number : {a, second, third}) {
          put(" ", number);
          put("//", number);
        }
        text += '\n';
      }
    }
  }
  return text;
}

}  // namespace raytracing
