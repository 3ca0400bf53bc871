#include "raytracing/sampling/spherical.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "raytracing/math/numeric.h"

namespace raytracing {
namespace {

// Keeps the planes of an observer on the line of an edge free of 0 / 0.
constexpr float kSmallest = std::numeric_limits<float>::min();

// The plane through the observer and one edge, by the angle of its normal from the rectangle's.
struct EdgePlane {
  float cosine, sine;
  // `offset` of the edge from the observer's foot, inwards; `height` of the observer.
  EdgePlane(float offset, float height) {
    const float distance = std::sqrt(std::max(height * height + offset * offset, kSmallest));
    cosine = offset / distance;
    sine = height / distance;
  }
};

// The angle between neighbouring planes, whose cosine is -a b, as a unit complex number (cosine,
// sine). Its sine comes without cancellation from the sines, which an observer close to the
// rectangle's plane needs.
Vec2 inner_angle(const EdgePlane& a, const EdgePlane& b) {
  return {-a.cosine * b.cosine, std::sqrt(square(a.sine) + square(a.cosine * b.sine))};
}

}  // namespace

SphericalRectangle::SphericalRectangle(const Rectangle& rectangle, const Vec3& from)
    : from_(from), x_(rectangle.x), y_(rectangle.y), z_(cross(rectangle.x, rectangle.y)) {
  const Vec3 d = rectangle.corner - from;
  x0_ = dot(d, x_);
  y0_ = dot(d, y_);
  z0_ = dot(d, z_);
  if (z0_ > 0) {
    z_ = -z_;
    z0_ = -z0_;
  }
  x1_ = x0_ + rectangle.width;
  y1_ = y0_ + rectangle.height;

  const EdgePlane n0(-y0_, -z0_), n1(x1_, -z0_), n2(y1_, -z0_), n3(-x0_, -z0_);
  // The rectangle's inner angles on the sphere as unit complex numbers; their product turns by
  // solid angle + 2 pi. Ureña's k = 2 pi - g2 - g3 stays a complex number too.
  const Vec2 g01 = complex_product(inner_angle(n0, n1), inner_angle(n1, n2));
  const Vec2 g23 = complex_product(inner_angle(n2, n3), inner_angle(n3, n0));
  const Vec2 all = complex_product(g01, g23);
  b0_ = n0.cosine;
  b1_ = n2.cosine;
  k_ = {g23.x, -g23.y};
  solid_angle_ = std::atan2(all.y, all.x);
  if (solid_angle_ < 0) solid_angle_ += 2 * kPi;
}

float SphericalRectangle::sample_x(float u) const {
  const float turn = u * solid_angle_;
  const Vec2 au = complex_product(k_, {std::cos(turn), std::sin(turn)});
  const float fu = (au.x * b0_ - b1_) / au.y;
  const float cu2 = 1 / (fu * fu + b0_ * b0_);
  const float cu = std::copysign(std::sqrt(std::min(cu2, 1.0f)), fu);
  return std::clamp(-(cu * z0_) / safe_sqrt(1 - cu2), x0_, x1_);
}

Vec3 SphericalRectangle::sample(const Vec2& u) const {
  const float x = sample_x(u.x);
  const float d2 = x * x + z0_ * z0_;
  const float h0 = y0_ / std::sqrt(d2 + y0_ * y0_);
  const float h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
  const float h = h0 + u.y * (h1 - h0);
  const float y = std::clamp(h * std::sqrt(d2) / safe_sqrt((1 - h) * (1 + h)), y0_, y1_);
  return from_ + x * x_ + y * y_ + z0_ * z_;
}

SphericalRectangle::Strip SphericalRectangle::strip(float u) const {
  const float x = sample_x(u);
  const float d2 = x * x + z0_ * z0_;
  const float h0 = y0_ / std::sqrt(d2 + y0_ * y0_);
  const float h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
  return {x - x0_, -z0_ * (h1 - h0) / (d2 * solid_angle_), y0_, d2};
}

SphericalTriangle::SphericalTriangle(const std::array<Vec3, 3>& corners, const Vec3& from)
    : from_(from),
      normal_(cross(DVec3(corners[1]) - DVec3(corners[0]), DVec3(corners[2]) - DVec3(corners[0]))),
      height_(dot(DVec3(corners[0]) - DVec3(from), normal_)),
      a_(normalize(DVec3(corners[0]) - DVec3(from))),
      b_(normalize(DVec3(corners[1]) - DVec3(from))),
      c_(normalize(DVec3(corners[2]) - DVec3(from))) {
  const double volume = std::abs(dot(a_, cross(b_, c_)));
  const double denominator = 1 + dot(a_, b_) + dot(b_, c_) + dot(c_, a_);
  solid_angle_ = 2 * std::atan2(volume, denominator);
  const DVec3 n_ab = cross(a_, b_);
  const DVec3 n_ac = cross(a_, c_);
  alpha_ = std::atan2(length(cross(n_ab, n_ac)), dot(n_ab, n_ac));
  cos_c_ = dot(a_, b_);
}

std::optional<Vec3> SphericalTriangle::sample(const Vec2& u) const {
  if (!(solid_angle_ > 0) || height_ == 0) return std::nullopt;
  // The sub-triangle (A, B, C') with the share u.x of the area: Arvo's q is cos of the arc AC'.
  const double phi = u.x * solid_angle_ - alpha_;
  const double s = std::sin(phi), t = std::cos(phi);
  const double sin_alpha = std::sin(alpha_), cos_alpha = std::cos(alpha_);
  const double p = t - cos_alpha;
  const double r = s + sin_alpha * cos_c_;
  const double denominator = (r * s + p * t) * sin_alpha;
  if (denominator == 0) return std::nullopt;
  const double q = std::clamp(((r * t - p * s) * cos_alpha - r) / denominator, -1.0, 1.0);
  const DVec3 towards_c = c_ - dot(c_, a_) * a_;
  const DVec3 c_prime =
      q * a_ + std::sqrt(std::max(0.0, 1 - q * q)) * (towards_c / length(towards_c));
  // A point on the arc from B to C', uniform in the cosine of its distance from B.
  const double z = 1 - u.y * (1 - dot(c_prime, b_));
  const DVec3 towards = c_prime - dot(c_prime, b_) * b_;
  const double span = length(towards);
  const DVec3 w =
      span > 0 ? z * b_ + std::sqrt(std::max(0.0, (1 - z) * (1 + z))) * (towards / span) : b_;
  // In double too: a direction rounded to float that grazes the plane meets it far away.
  return Vec3(from_ + (height_ / dot(w, normal_)) * w);
}

}  // namespace raytracing
