#pragma once
// Computes the distances between pairs of bodies along a motion of the arm: link to link, link to a part of
// the robot cell, link to floor. Lower bounds avoid most of the computations.
//
// Since its last computation, the distance of a pair cannot have fallen by more than this sum: the motion of
// each joint times the joint's lever arm, plus the motion of the cell's part. This gives a lower bound. A
// pair whose bound is above the distance of interest need not be computed.

#include <memory>
#include <vector>

#include "sim/cell/clearance_model.hpp"

namespace armtune::internal {

class PairDistances {
 public:
  explicit PairDistances(std::shared_ptr<const ClearanceModel> model);

  /// Moves the arm to joint positions q (n) [rad, m], at `time` [s]. q must stay unchanged until the next
  /// call.
  void move_to(double time, const JointVector& q);

  /// Returns a lower bound of the distance of pair k [m]; -infinity if no bound is known.
  double at_least(std::size_t k) const;
  /// Computes the distance of pair k at the arm's current position and time. Allocates nothing.
  const Closest& compute(std::size_t k);

  const ClearanceModel& model() const { return *model_; }
  std::size_t size() const { return known_.size(); }
  /// Returns the number of distances that were computed.
  long computed() const { return computed_; }

 private:
  /// The last distance of a pair that was computed, and the state at that time.
  struct Known {
    Closest closest;
    JointVector q;           ///< empty: not yet computed
    Vec3 at = Vec3::Zero();  ///< position of the part of the cell
  };

  std::shared_ptr<const ClearanceModel> model_;
  std::vector<Known> known_;  ///< one per pair
  std::vector<Vec3> parts_;   ///< current positions of the parts of the cell
  JointVector travel_;        ///< largest |q| at which the levers are valid [m]; infinite for revolute joints
  const JointVector* q_ = nullptr;
  bool beyond_ = false;  ///< true if the |q| of a joint exceeds travel_
  bool placed_ = false;  ///< true if poses_ was computed for *q_
  Poses poses_;
  long computed_ = 0;
};

}  // namespace armtune::internal
