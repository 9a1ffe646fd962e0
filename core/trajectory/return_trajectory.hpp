#pragma once
// The trajectory on which the tool returns to its path, for example after avoiding an obstacle (equation 8 in
// NOTATION.md). The desired point moves along the path meanwhile, so the duration is computed in two steps. A
// first duration follows from the distance to the desired point now. The final one follows from the distance
// to where the desired point will be after the first duration.

#include "core/trajectory/path.hpp"
#include "core/trajectory/quintic.hpp"

namespace armtune::internal {

/// Returns dt* = k_t |p - pc(t0 + dt)| with dt = k_t |p - pc(t0)|, at least kShortestInterpolation [s].
/// k_t: trajectoryDurationErrorGain [s/m].
inline double return_duration(const Vec3& p_0T, const Path& path, double t0, double k_t) {
  const double naive = k_t * (p_0T - path.at(t0).position).norm();
  return std::max(kShortestInterpolation, k_t * (p_0T - path.at(t0 + naive).position).norm());
}

/// Returns the quintic from `start` at t0 to the path's own motion at t0 + dt*.
inline Quintic<Vec3> return_trajectory(const MotionPoint<Vec3>& start, const Path& path, double t0,
                                       double k_t) {
  const double duration = return_duration(start.position, path, t0, k_t);
  return {start, path.at(t0 + duration), duration};
}

}  // namespace armtune::internal
