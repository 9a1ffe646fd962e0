#include "core/robot/link_radius.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

double radius_of(const Shape& shape) {
  if (shape.kind == ShapeKind::kMesh || shape.kind == ShapeKind::kNoSize)
    return std::numeric_limits<double>::quiet_NaN();
  if (shape.kind != ShapeKind::kBox) return shape.size[0];
  const double longest = shape.size.maxCoeff();
  return 0.5 * std::sqrt(std::max(0.0, shape.size.squaredNorm() - longest * longest));
}

}  // namespace

JointVector shape_radii(const RobotModel& model) {
  const auto largest = [&](int body, bool collision) {
    double radius = std::numeric_limits<double>::quiet_NaN();
    for (const Shape& shape : model.shapes) {
      if (shape.body == body && shape.collision == collision) radius = std::fmax(radius, radius_of(shape));
    }
    return radius;
  };
  JointVector radii(model.n());
  for (int i = 0; i < model.n(); ++i) {
    radii[i] = largest(i, true);
    if (std::isnan(radii[i])) radii[i] = largest(i, false);
  }
  return radii;
}

RobotModel with_link_surfaces(const RobotModel& model) {
  std::vector<std::string> unknown;
  for (int i = 0; i < model.n(); ++i) {
    const bool known = i < model.link_radii.size() && std::isfinite(model.link_radii[i]);
    if (!known) unknown.push_back(model.joints[static_cast<std::size_t>(i)].link);
  }
  if (!unknown.empty()) {
    throw InputError(
        InputPlace{model.source, 0, "link_radius/" + unknown.front()},
        fmt::format(
            "the thickness of these links is not known: {}. They have no box, cylinder, sphere or capsule as "
            "a shape; give link_radius [m] in the robot's YAML",
            fmt::join(unknown, ", ")))
        .with_value({}, "a radius in m for: " + fmt::format("{}", fmt::join(unknown, ", ")));
  }
  RobotModel result = model;
  result.chain.link_radius = model.link_radii;
  return result;
}

}  // namespace armtune::internal
