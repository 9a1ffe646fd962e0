#include "core/trajectory/polyline.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

/// Straight pieces shorter than this share of a blend are left out, and the next blend begins where the last
/// one ended. A quintic that short would consist of rounding errors.
constexpr double kNoPiece = 1e-4;

class Builder {
 public:
  Builder(double speed, double blend) : speed_(speed), blend_(blend) {}

  /// Continues the motion to `position` [m], where it has `velocity` [m/s]. It takes `duration` [s].
  void to(const Vec3& position, const Vec3& velocity, double duration) {
    if (!time_.empty() && duration <= kNoPiece * blend_ / speed_) return;
    time_.push_back(time_.empty() ? 0.0 : time_.back() + duration);
    knots_.push_back({position, velocity, Vec3::Zero()});
  }
  PositionSpline spline(bool loops) const { return {time_, knots_, loops}; }

 private:
  double speed_, blend_;
  std::vector<double> time_;
  std::vector<MotionPoint<Vec3>> knots_;
};

}  // namespace

PositionSpline polyline(const std::vector<Vec3>& corners, double speed, double blend, bool closed) {
  const std::size_t n = corners.size();
  if (n < (closed ? 3U : 2U)) {
    throw InputError(fmt::format("the line has {} corners; a {} line needs at least {}", n,
                                 closed ? "closed" : "open", closed ? 3 : 2))
        .with_value(std::to_string(n), fmt::format("at least {} corners", closed ? 3 : 2));
  }
  if (!(speed > 0.0) || !(blend > 0.0)) {
    throw InputError(fmt::format("speed {} m/s and blend {} m must be above zero", speed, blend))
        .with_value(fmt::to_string(speed > 0.0 ? blend : speed), "above zero");
  }
  // Side s leads from corner s to the next.
  const std::size_t sides = closed ? n : n - 1;
  std::vector<Vec3> direction;
  std::vector<double> length;
  for (std::size_t s = 0; s < sides; ++s) {
    const Vec3 side = corners[(s + 1) % n] - corners[s];
    length.push_back(side.norm());
    if (!(length[s] >= 2.0 * blend * (1.0 - 1e-9))) {
      throw InputError(
          fmt::format("corners {} and {} are {:.6g} m apart, which is less than the two blends of {:.6g} m "
                      "between them; reduce the blend",
                      s + 1, (s + 1) % n + 1, length[s], blend))
          .with_value(fmt::format("{:.6g}", length[s]), fmt::format("at least {:.6g} m", 2.0 * blend));
    }
    direction.push_back(side / length[s]);
  }
  const auto velocity = [&](std::size_t s) { return Vec3(speed * direction[s]); };
  const double blending = 2.0 * blend / speed;  // duration of a blend, and of a start or stop at the ends
  Builder builder(speed, blend);
  if (closed) {
    builder.to(corners[0] + blend * direction[0], velocity(0), 0.0);
  } else {
    builder.to(corners[0], Vec3::Zero(), 0.0);
    builder.to(corners[0] + blend * direction[0], velocity(0), blending);
  }
  for (std::size_t s = 0; s < sides; ++s) {
    const Vec3& corner = corners[(s + 1) % n];
    builder.to(corner - blend * direction[s], velocity(s), (length[s] - 2.0 * blend) / speed);
    if (s + 1 == sides && !closed) {
      builder.to(corner, Vec3::Zero(), blending);
      break;
    }
    const std::size_t next = (s + 1) % sides;
    builder.to(corner + blend * direction[next], velocity(next), blending);
  }
  return builder.spline(closed);
}

}  // namespace armtune::internal
