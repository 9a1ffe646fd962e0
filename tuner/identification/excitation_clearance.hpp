#pragma once
// Distances that an exciting trajectory (excitation.hpp) keeps between the links of the arm, and between the
// arm and the cell of its robot file.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/cell/clearance_watch.hpp"
#include "tuner/identification/excitation.hpp"

namespace armtune::internal {

/// The distances that a trajectory must keep. They are those of planned motions, with one exception: two
/// links never have to keep more than half of the distance that they have at the centre of the trajectory. In
/// many arms, some links are always closer to each other than the 5 mm that planned motions keep.
struct KeptDistances {
  std::shared_ptr<const ClearanceModel> model;  ///< null: no distance is checked
  double clearance = 0.02;  ///< least distance from the parts and the floor of the cell [m]

  /// Returns the distance [m] that each pair of bodies must keep in a trajectory around this centre (n), in
  /// the order of ClearanceModel::pairs. spare: added to every distance [m]. For two links, the result is
  /// nevertheless at most half of their distance at the centre.
  std::vector<double> least(const JointVector& center, double spare = 0.0) const;
};

/// The time between two positions at which distances_along computes distances [s].
inline constexpr double kDistancePeriod = 0.002;

/// Judges distances at some positions of a trajectory.
class DistanceTally {
 public:
  /// center: (n) [rad, m]; spare: added to the distances that must be kept [m].
  DistanceTally(const KeptDistances& kept, const JointVector& center, double spare);

  /// Checks the arm at joint positions q (n) [rad, m], at `time` [s].
  void see(double time, const JointVector& q);

  /// Returns 0 if no distance is too near. Otherwise returns the share of the positions that are too near,
  /// plus the largest shortfall of a distance as a share of the distance required. The result is at most 2.
  double shortfall() const;

 private:
  std::optional<PairDistances> distances_;
  std::vector<double> least_;  ///< per pair [m]
  double most_ = 0.0;          ///< largest shortfall
  std::size_t seen_ = 0;
  std::size_t near_ = 0;
};

/// The distances along a trajectory.
struct DistancesAlong {
  LeastClearances nearest;               ///< the smallest distance of each kind
  std::vector<LeastClearance> too_near;  ///< the smallest distance of each pair that comes too near
};

/// Returns the distances along the whole trajectory, at every kDistancePeriod.
DistancesAlong distances_along(const Excitation& excitation, const KeptDistances& kept);

/// Throws InputError if the arm touches itself at the centre (n), or is nearer to its cell than allowed.
/// Every trajectory begins there.
void check_distances_at(const JointVector& center, const KeptDistances& kept);

/// Returns the trajectory with its amplitudes reduced by one common factor, the largest found by bisection
/// with which it keeps the distances. The centre must keep them.
Excitation shrunk_to_keep(const Excitation& excitation, const KeptDistances& kept);

/// Returns a clause that names every pair that comes too near, with its smallest distance and time. Returns
/// an empty text if there are none.
std::string too_near_clause(const std::vector<LeastClearance>& too_near, const KeptDistances& kept);

/// Returns sentences that say which distances were checked along a trajectory, how small they are, and what
/// was not checked.
std::string contact_sentences(const LeastClearances& nearest, const KeptDistances& kept);

}  // namespace armtune::internal
