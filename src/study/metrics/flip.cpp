#include "raytracing/study/metrics/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

// The names are the paper's: Y Cx Cz is the linear opponent space that filters work in, ppd are
// pixels per degree of the field of view.

namespace raytracing {
namespace {

/// One channel of a picture, top row first.
struct Plane {
  int width, height;
  std::vector<float> values;

  Plane(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
};

/// The weights at -radius .. radius, an odd number of them.
using Kernel = std::vector<float>;

// Filters the rows of a plane and transposes it. Beyond its ends a row continues with its last
// values.
Plane filtered_and_transposed(const Plane& plane, const Kernel& kernel) {
  const std::size_t width = static_cast<std::size_t>(plane.width), radius = kernel.size() / 2;
  const auto height = static_cast<std::size_t>(plane.height);
  Plane result(plane.height, plane.width);
  std::vector<float> padded(width + 2 * radius), filtered(width);
  for (std::size_t y = 0; y < height; ++y) {
    const float* row = plane.values.data() + y * width;
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, width, padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill_n(padded.rbegin(), radius, row[width - 1]);
    std::fill(filtered.begin(), filtered.end(), 0.0f);
    for (std::size_t k = 0; k < kernel.size(); ++k)
      for (std::size_t x = 0; x < width; ++x) filtered[x] += kernel[k] * padded[x + k];
    for (std::size_t x = 0; x < width; ++x) result.values[x * height + y] = filtered[x];
  }
  return result;
}

Plane convolve(const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
  return filtered_and_transposed(filtered_and_transposed(plane, along_x), along_y);
}

using DMat3 = glm::dmat3;
using Opponent = std::array<Plane, 3>;  // Y, Cx, Cz

constexpr double kPi = std::numbers::pi;

// The matrix takes linear sRGB to CIE XYZ; its columns are the primaries, which add up to white.
const DMat3 kXyz{10135552.0 / 24577794, 2613072.0 / 12288897, 1425312.0 / 73733382,
                 8788810.0 / 24577794,  8788810.0 / 12288897, 8788810.0 / 73733382,
                 4435075.0 / 24577794,  887015.0 / 12288897,  70074185.0 / 73733382};
const DVec3 kWhite = kXyz * DVec3(1);
const DMat3 kRgb = glm::inverse(kXyz);

DVec3 to_opponent(const DVec3& rgb) {
  const DVec3 v = kXyz * rgb / kWhite;
  return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}

DVec3 from_opponent(const DVec3& c) {
  const double y = (c.x + 16) / 116;
  return kRgb * (DVec3(y + c.y / 500, y, y - c.z / 200) * kWhite);
}

// Converts to CIE L*a*b* with Hunt's adjustment: dark colours lose their chroma.
DVec3 to_hunt_lab(const DVec3& rgb) {
  constexpr double kDelta = 6.0 / 29;
  const auto f = [](double t) {
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
  };
  const DVec3 v = kXyz * rgb / kWhite;
  const double lightness = 116 * f(v.y) - 16;
  const double hunt = 0.01 * lightness;
  return {lightness, hunt * 500 * (f(v.x) - f(v.y)), hunt * 200 * (f(v.y) - f(v.z))};
}

double hyab(const DVec3& a, const DVec3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

Opponent opponent_planes(const ImageData& image) {
  const RgbView view(image);
  const Plane empty(image.width, image.height);
  Opponent planes{empty, empty, empty};
  for (std::size_t i = 0; i < view.pixels(); ++i) {
    DVec3 rgb = view[i];
    for (int c = 0; c < 3; ++c) rgb[c] = rgb[c] > 0 ? std::min(rgb[c], 1.0) : 0;  // NaN too
    const DVec3 v = to_opponent(rgb);
    for (std::size_t c = 0; c < 3; ++c)
      planes[c].values[i] = static_cast<float>(v[static_cast<int>(c)]);
  }
  return planes;
}

Kernel to_kernel(const std::vector<double>& weights, double scale) {
  Kernel kernel;
  for (double w : weights) kernel.push_back(static_cast<float>(w * scale));
  return kernel;
}

// One term a sqrt(pi / b) exp(-pi^2 d^2 / b) of a contrast sensitivity function, d in degrees.
struct CsfTerm {
  double a, b;
};

// Filters a channel by a contrast sensitivity function. Each of its terms is a product of functions
// of x and y; the sum of the terms is normalised.
Plane filter_by_csf(const Plane& plane, const std::vector<CsfTerm>& terms, double ppd) {
  constexpr double kWidestB = 0.04;
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kWidestB / (2 * kPi * kPi)) * ppd));
  std::vector<Kernel> kernels;
  std::vector<double> sums;
  for (const CsfTerm& term : terms) {
    std::vector<double> weights;
    for (int k = -radius; k <= radius; ++k)
      weights.push_back(std::exp(-kPi * kPi * (k / ppd) * (k / ppd) / term.b));
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    kernels.push_back(to_kernel(weights, 1 / sum));
    sums.push_back(term.a * std::sqrt(kPi / term.b) * sum * sum);
  }
  const double total = std::accumulate(sums.begin(), sums.end(), 0.0);
  Plane result(plane.width, plane.height);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const Plane filtered = convolve(plane, kernels[t], kernels[t]);
    const auto weight = static_cast<float>(sums[t] / total);
    for (std::size_t i = 0; i < result.values.size(); ++i)
      result.values[i] += weight * filtered.values[i];
  }
  return result;
}

// The colours perceived at this viewing distance, in L*a*b* with Hunt's adjustment.
std::vector<DVec3> seen_colours(const Opponent& planes, double ppd) {
  const Plane y = filter_by_csf(planes[0], {{1, 0.0047}}, ppd);
  const Plane cx = filter_by_csf(planes[1], {{1, 0.0053}}, ppd);
  const Plane cz = filter_by_csf(planes[2], {{34.1, 0.04}, {13.5, 0.025}}, ppd);
  std::vector<DVec3> colours;
  colours.reserve(y.values.size());
  for (std::size_t i = 0; i < y.values.size(); ++i) {
    const DVec3 rgb = from_opponent({y.values[i], cx.values[i], cz.values[i]});
    colours.push_back(to_hunt_lab(glm::clamp(rgb, DVec3(0), DVec3(1))));
  }
  return colours;
}

// Compresses a colour distance so that the largest becomes 1 and large ones differ little.
double colour_error(const DVec3& test, const DVec3& reference, double largest) {
  constexpr double kExponent = 0.7, kKnee = 0.4, kErrorAtKnee = 0.95;
  const double error = std::pow(hyab(test, reference), kExponent);
  const double most = std::pow(largest, kExponent), knee = kKnee * most;
  if (error < knee) return kErrorAtKnee * error / knee;
  return kErrorAtKnee + (error - knee) / (most - knee) * (1 - kErrorAtKnee);
}

// Scales the positive weights to a sum of 1 and the negative ones to a sum of -1.
Kernel balanced(const std::vector<double>& weights) {
  double positive = 0, negative = 0;
  for (double w : weights) (w > 0 ? positive : negative) += std::abs(w);
  Kernel kernel;
  for (double w : weights) kernel.push_back(static_cast<float>(w / (w > 0 ? positive : negative)));
  return kernel;
}

struct FeatureKernels {
  Kernel smooth, edge, point;  // a Gaussian, its first and its second derivative
};

FeatureKernels feature_kernels(double ppd) {
  constexpr double kFeatureWidth = 0.082;  // degrees
  const double sd = 0.5 * kFeatureWidth * ppd;
  const int radius = static_cast<int>(std::ceil(3 * sd));
  std::vector<double> gaussian, edge, point;
  for (int k = -radius; k <= radius; ++k) {
    const double x = k / sd, g = std::exp(-0.5 * x * x);
    gaussian.push_back(g);
    edge.push_back(-x * g);
    point.push_back((x * x - 1) * g);
  }
  const double sum = std::accumulate(gaussian.begin(), gaussian.end(), 0.0);
  return {to_kernel(gaussian, 1 / sum), balanced(edge), balanced(point)};
}

// The strength of a feature in any direction, per pixel.
std::vector<float> feature_strength(const Plane& y, const Kernel& feature, const Kernel& smooth) {
  const Plane along_x = convolve(y, feature, smooth), along_y = convolve(y, smooth, feature);
  std::vector<float> strength(y.values.size());
  for (std::size_t i = 0; i < strength.size(); ++i)
    strength[i] = std::hypot(along_x.values[i], along_y.values[i]);
  return strength;
}

struct Features {
  std::vector<float> edges, points;

  Features(Plane y, const FeatureKernels& kernels) {
    for (float& v : y.values) v = (v + 16) / 116;
    edges = feature_strength(y, kernels.edge, kernels.smooth);
    points = feature_strength(y, kernels.point, kernels.smooth);
  }
};

}  // namespace

std::vector<float> flip_map(const ImageData& test, const ImageData& reference, double ppd) {
  check_same_size(test, reference);
  const Opponent tests = opponent_planes(test), references = opponent_planes(reference);
  const std::vector<DVec3> test_colours = seen_colours(tests, ppd);
  const std::vector<DVec3> reference_colours = seen_colours(references, ppd);
  const FeatureKernels kernels = feature_kernels(ppd);
  const Features test_features(tests[0], kernels), reference_features(references[0], kernels);
  // No two colours of the cube are farther apart than green and blue.
  const double largest = hyab(to_hunt_lab({0, 1, 0}), to_hunt_lab({0, 0, 1}));
  std::vector<float> map;
  map.reserve(test_colours.size());
  for (std::size_t i = 0; i < test_colours.size(); ++i) {
    const double edge = std::abs(test_features.edges[i] - reference_features.edges[i]);
    const double point = std::abs(test_features.points[i] - reference_features.points[i]);
    const double feature_error = std::sqrt(std::max(edge, point) / std::numbers::sqrt2);
    const double error = colour_error(test_colours[i], reference_colours[i], largest);
    map.push_back(static_cast<float>(std::pow(error, 1 - feature_error)));
  }
  return map;
}

}  // namespace raytracing
