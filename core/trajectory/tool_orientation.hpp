#pragma once
// How the tool is to be turned where it is no gaze: fixed, along the path, or through orientations in time.

#include <memory>
#include <optional>

#include "core/trajectory/path.hpp"
#include "core/trajectory/slerp.hpp"

namespace armtune::internal {

struct ToolOrientation {
  /// Tool in the base frame; of a turn its beginning. Counts where there is no `approach`.
  Eigen::Quaterniond start = Eigen::Quaterniond::Identity();
  /// Rotation vector [rad, base frame] in time: the orientation is exp(turn(t)) start; null: it is fixed.
  std::shared_ptr<const PositionSpline> turn = nullptr;
  /// Base frame. With it the tool's x axis points where the path goes, and its z axis lies as near to this as
  /// that leaves it.
  std::optional<Vec3> approach = std::nullopt;

  /// At t [s], with its exact rates; path: the tool's. Allocates nothing.
  OrientationPoint at(double t, const Path& path) const;

  /// Whether it never turns.
  bool rests(const Path& path) const { return !turn && (!approach || path.rests()); }
};

/// Where the path goes at t [s]: u = v / |v| with u' and u''. Before the beginning and after the end of one
/// that does not loop, where it begins or ends to go, at rest. Zero where it rests in between.
MotionPoint<Vec3> heading(const Path& path, double t);

/// Farther than this from its beginning [rad] a turn through waypoints is none: near a whole turn a rotation
/// vector tells no axis.
inline constexpr double kMostTurn = 1.5 * M_PI;

/// Turns through orientations at given times [s], rising, at least two: the cubic spline
/// through their rotation vectors from the first, at rest at both ends. Each is the one nearest to the last;
/// those beyond kMostTurn are for the caller to refuse.
ToolOrientation turning_through(const std::vector<double>& time,
                                const std::vector<Eigen::Quaterniond>& orientations);

}  // namespace armtune::internal
