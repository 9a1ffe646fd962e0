#pragma once
// The desired orientation of a tool that does not point at a target. It is fixed, follows the direction of
// the tool's path, or moves through given orientations.

#include <memory>
#include <optional>

#include "core/trajectory/path.hpp"
#include "core/trajectory/slerp.hpp"

namespace armtune::internal {

struct ToolOrientation {
  /// Tool orientation in the base frame. If `turn` is given, this is the orientation from which it turns. If
  /// `approach` is given, this member is not used.
  Eigen::Quaterniond start = Eigen::Quaterniond::Identity();
  /// Rotation vector over time [rad, base frame]: the orientation is exp(turn(t)) start. Null: the
  /// orientation stays at `start`, unless there is an `approach`.
  std::shared_ptr<const PositionSpline> turn = nullptr;
  /// Approach direction, base frame. If given, the tool's x axis points along the path, and its z axis is the
  /// direction nearest to this one that is perpendicular to x.
  std::optional<Vec3> approach = std::nullopt;

  /// Returns the orientation at t [s], with exact rates. path: the path of the tool. Allocates nothing.
  OrientationPoint at(double t, const Path& path) const;

  /// True if the tool never turns.
  bool rests(const Path& path) const { return !turn && (!approach || path.rests()); }
};

/// Returns the direction of the path's motion at t [s]: u = v / |v| with u' and u''. Before the start and
/// after the end of a spline that does not loop, u is constant: the direction at its start or at its end. If
/// the path rests in between, u is zero there.
MotionPoint<Vec3> heading(const Path& path, double t);

/// Largest rotation [rad] from the first orientation of turning_through to any other. Near a whole turn, a
/// rotation vector does not determine an axis.
inline constexpr double kMostTurn = 1.5 * M_PI;

/// Returns an orientation that moves through the given orientations at the given times. time [s]: increasing,
/// at least two. Each given orientation is described by its rotation vector from the first one. Of the
/// vectors that describe the same orientation, the one nearest to the previous vector is chosen. The motion
/// is the cubic spline through these vectors, at rest at both ends. The caller must refuse vectors longer
/// than kMostTurn.
ToolOrientation turning_through(const std::vector<double>& time,
                                const std::vector<Eigen::Quaterniond>& orientations);

}  // namespace armtune::internal
