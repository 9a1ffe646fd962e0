#pragma once
// The distances of all pairs of a clearance model along a motion, each computed only when it may matter.
//
// The distance of a pair cannot have fallen by more than its joints have turned since it was computed, each
// times the lever of its joint, and its part of the cell has moved. So there is always a bound below it, and
// a pair whose bound is above what is looked for need not be computed.

#include <memory>
#include <vector>

#include "sim/cell/clearance_model.hpp"

namespace armtune::internal {

class PairDistances {
 public:
  explicit PairDistances(std::shared_ptr<const ClearanceModel> model);

  /// The arm is at joint positions q (n) [rad, m], at `time` [s]; q stays as it is until the next call.
  void move_to(double time, const JointVector& q);

  /// The distance of pair k is at least this [m].
  double at_least(std::size_t k) const;
  /// Computes the distance of pair k, where arm and cell are now. Allocates nothing.
  const Closest& compute(std::size_t k);

  const ClearanceModel& model() const { return *model_; }
  std::size_t size() const { return known_.size(); }
  /// How many distances were computed.
  long computed() const { return computed_; }

 private:
  /// When a pair's distance was computed last.
  struct Known {
    Closest closest;
    JointVector q;           ///< empty: not yet
    Vec3 at = Vec3::Zero();  ///< where the part of the cell was
  };

  std::shared_ptr<const ClearanceModel> model_;
  std::vector<Known> known_;  ///< one per pair
  std::vector<Vec3> parts_;   ///< where the parts of the cell are
  JointVector travel_;        ///< how far from 0 the levers let a joint slide [m]
  const JointVector* q_ = nullptr;
  bool beyond_ = false;  ///< a joint has slid farther than that
  bool placed_ = false;  ///< the poses are those of *q_
  Poses poses_;
  long computed_ = 0;
};

}  // namespace armtune::internal
