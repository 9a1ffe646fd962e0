#pragma once
// The smallest distances between an arm, itself and its cell: over a whole motion, and at single moments.

#include <array>
#include <limits>
#include <memory>

#include "sim/cell/pair_distances.hpp"

namespace armtune::internal {

/// The smallest distance of one kind, with its time and its pair.
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

/// A watch for the smallest distances over all moments that it sees. They are exact, and no contact at any of
/// these moments is missed.
class ClearanceWatch {
 public:
  explicit ClearanceWatch(std::shared_ptr<const ClearanceModel> model) : distances_(std::move(model)) {}

  /// Checks the arm at joint positions q (n) [rad, m], at `time` [s]. Allocates nothing.
  void see(double time, const JointVector& q);

  const LeastClearances& least() const { return least_; }
  /// Returns the number of distances that were computed.
  long computed() const { return distances_.computed(); }

 private:
  PairDistances distances_;
  LeastClearances least_;
};

/// A finder of the smallest distances at one moment after another, for recordings.
class ClearanceNow {
 public:
  explicit ClearanceNow(std::shared_ptr<const ClearanceModel> model) : distances_(std::move(model)) {}

  /// Checks the arm at joint positions q (n) [rad, m], at `time` [s]. A second call for the same time does
  /// nothing.
  void see(double time, const JointVector& q);

  const LeastClearances& least() const { return least_; }
  /// Returns the two points that are closest to each other among all kinds. For an arm without pairs both are
  /// zero.
  const Closest& closest() const { return closest_; }

 private:
  PairDistances distances_;
  LeastClearances least_;
  std::array<std::size_t, kClearances> last_{};  ///< the pair that was closest the last time, by kind
  Closest closest_;
  double time_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace armtune::internal
