#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "raytracing/scene/description.h"

namespace raytracing {
namespace {

const CameraDescription kOblique{{3.0f, 1.0f, -2.0f}, {-1.0f, 2.0f, 5.0f}, {0.1f, 1.0f, 0.2f}, 50};

/// Returns the direction in the frame of the camera.
struct View {
  explicit View(const CameraDescription& d)
      : forward(normalize(d.target - d.origin)),
        right(normalize(cross(d.target - d.origin, d.up))),
        up(cross(right, forward)) {}
  Vec3 forward, right, up;
  double tan_x(const Ray& ray) const {
    return double{dot(ray.direction, right)} / dot(ray.direction, forward);
  }
  double tan_y(const Ray& ray) const {
    return double{dot(ray.direction, up)} / dot(ray.direction, forward);
  }
};

TEST(Camera, PixelZeroIsUpperLeftAndRightIsCrossOfForwardAndUp) {
  const Camera camera(kOblique, 40, 30);
  const View view(kOblique);
  const double t = std::tan(25 * std::numbers::pi / 180);
  const struct {
    float x, y;
    double tan_x, tan_y;
  } corners[]{{0, 0, -t * 4 / 3, t},
              {40, 0, t * 4 / 3, t},
              {0, 30, -t * 4 / 3, -t},
              {40, 30, t * 4 / 3, -t}};
  for (const auto& corner : corners) {
    const Ray ray = camera.ray(corner.x, corner.y);
    EXPECT_NEAR(view.tan_x(ray), corner.tan_x, 1e-6);
    EXPECT_NEAR(view.tan_y(ray), corner.tan_y, 1e-6);
  }
}

TEST(Camera, MiddleOfThePictureIsTheTarget) {
  for (const auto& [width, height] : {std::pair{40, 30}, {30, 40}, {7, 5}}) {
    const Ray ray = Camera(kOblique, width, height)
                        .ray(0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height));
    EXPECT_EQ(ray.origin, kOblique.origin);
    EXPECT_NEAR(length(ray.direction), 1, 1e-6);
    EXPECT_NEAR(length(ray.direction - normalize(kOblique.target - kOblique.origin)), 0, 1e-6);
  }
}

// The field of view spans the height of the image; pixels are square.
TEST(Camera, AngleOfViewIsVerticalAndPixelsAreSquare) {
  const View view(kOblique);
  for (const auto& [width, height] : {std::pair{40, 30}, {30, 40}, {64, 64}}) {
    const Camera camera(kOblique, width, height);
    const float x = 0.5f * static_cast<float>(width), y = static_cast<float>(height);
    const double cosine = dot(camera.ray(x, 0).direction, camera.ray(x, y).direction);
    EXPECT_NEAR(cosine, std::cos(50 * std::numbers::pi / 180), 1e-6);
    const double step_x = view.tan_x(camera.ray(5, 5)) - view.tan_x(camera.ray(4, 5));
    const double step_y = view.tan_y(camera.ray(5, 4)) - view.tan_y(camera.ray(5, 5));
    EXPECT_NEAR(step_x, step_y, 1e-6);
  }
}

TEST(Camera, StraightAheadHasRightAtPlusX) {
  const Camera camera({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 90}, 2, 2);
  EXPECT_NEAR(length(camera.ray(2, 0).direction - normalize(Vec3(1, 1, -1))), 0, 1e-6);
  EXPECT_NEAR(length(camera.ray(0, 2).direction - normalize(Vec3(-1, -1, -1))), 0, 1e-6);
}

}  // namespace
}  // namespace raytracing
