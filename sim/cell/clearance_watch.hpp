#pragma once
// The smallest distances over a motion, and those of a moment.

#include <array>
#include <limits>
#include <memory>

#include "sim/cell/pair_distances.hpp"

namespace armtune::internal {

/// The smallest distance of one kind, and where it was.
struct LeastClearance {
  double distance = std::numeric_limits<double>::infinity();  ///< [m]
  double time = 0.0;                                          ///< [s]
  const ContactPair* pair = nullptr;
};

/// By kind of clearance.
using LeastClearances = std::array<LeastClearance, kClearances>;
inline const LeastClearance& least_of(Clearance kind, const LeastClearances& least) {
  return least[static_cast<std::size_t>(kind)];
}

/// Finds the smallest distances over all moments that it sees: exactly, and no contact at any of them is
/// missed.
class ClearanceWatch {
 public:
  explicit ClearanceWatch(std::shared_ptr<const ClearanceModel> model) : distances_(std::move(model)) {}

  /// The arm at joint positions q (n) [rad, m], at `time` [s]. Allocates nothing.
  void see(double time, const JointVector& q);

  const LeastClearances& least() const { return least_; }
  /// How many distances were computed.
  long computed() const { return distances_.computed(); }

 private:
  PairDistances distances_;
  LeastClearances least_;
};

/// Finds the smallest distances at one moment after another, for recordings.
class ClearanceNow {
 public:
  explicit ClearanceNow(std::shared_ptr<const ClearanceModel> model) : distances_(std::move(model)) {}

  /// The arm at joint positions q (n) [rad, m], at `time` [s]. A second call for the same moment costs
  /// nothing.
  void see(double time, const JointVector& q);

  const LeastClearances& least() const { return least_; }
  /// The two points that are closest to each other of all kinds; of an arm without pairs both are zero.
  const Closest& closest() const { return closest_; }

 private:
  PairDistances distances_;
  LeastClearances least_;
  std::array<std::size_t, kClearances> last_{};  ///< the pair that was closest the last time, by kind
  Closest closest_;
  double time_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace armtune::internal
