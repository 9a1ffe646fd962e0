#pragma once
// Finds how close an arm comes to itself, to its robot cell and to the floor during a motion. ClearanceWatch
// finds the smallest distances over the whole motion. ClearanceNow finds the smallest distances at one time.

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "sim/cell/far_pairs.hpp"
#include "sim/cell/pair_distances.hpp"

namespace armtune::internal {

/// The smallest distance of one kind (self, cell or floor), with its time and its pair of bodies.
struct LeastClearance {
  double distance = std::numeric_limits<double>::infinity();  ///< [m]
  double time = 0.0;                                          ///< [s]
  const ContactPair* pair = nullptr;
};

/// The smallest distances by kind of clearance.
using LeastClearances = std::array<LeastClearance, kClearances>;
inline const LeastClearance& least_of(Clearance kind, const LeastClearances& least) {
  return least[static_cast<std::size_t>(kind)];
}

/// Finds the smallest distance of each kind over all calls of see(). The distances are exact. A contact is
/// found if it exists at the time of one of these calls.
class ClearanceWatch {
 public:
  explicit ClearanceWatch(std::shared_ptr<const ClearanceModel> model)
      : ClearanceWatch(std::move(model), {}) {}
  /// required: distance below which a pair is too near, for each pair of the model [m]; empty: no pair is.
  ClearanceWatch(std::shared_ptr<const ClearanceModel> model, const std::vector<double>& required);

  /// Checks the arm at joint positions q (n) [rad, m], at `time` [s]. Allocates nothing.
  void see(double time, const JointVector& q);

  const LeastClearances& least() const { return least_; }
  /// Returns the smallest distance of every pair that was too near, in the order of ClearanceModel::pairs.
  std::vector<LeastClearance> too_near() const;
  /// Returns the number of distances that were computed.
  long computed() const { return distances_.computed(); }

 private:
  /// Returns the distance below which pair k is of interest: it would be the smallest of its kind, or smaller
  /// than before where the pair is too near.
  double limit(std::size_t k) const;
  void look_at(std::size_t k, double time);

  PairDistances distances_;
  FarPairs far_;
  std::vector<double> spare_;  ///< of every pair, for FarPairs::choose
  LeastClearances least_;
  std::vector<LeastClearance> by_pair_;  ///< the smallest distance below the required one; none: no `pair`
};

/// Finds the smallest distance of each kind at the time of the last call of see(). Recordings contain these
/// distances.
class ClearanceNow {
 public:
  explicit ClearanceNow(std::shared_ptr<const ClearanceModel> model) : distances_(std::move(model)) {}

  /// Checks the arm at joint positions q (n) [rad, m], at `time` [s]. A second call for the same time does
  /// nothing.
  void see(double time, const JointVector& q);

  const LeastClearances& least() const { return least_; }
  /// Returns the smallest distance of all kinds, and the two points between which it lies. If there are no
  /// pairs, both points are zero.
  const Closest& closest() const { return closest_; }

 private:
  PairDistances distances_;
  LeastClearances least_;
  std::array<std::size_t, kClearances> last_{};  ///< index of the last call's closest pair, by kind
  Closest closest_;
  double time_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace armtune::internal
