#pragma once
// Computes the distances between pairs of bodies along a motion of the arm: link to link, link to a part of
// the robot cell, link to floor. Lower bounds avoid most of the computations.
//
// Since a time at which a lower bound of a pair's distance was known, the distance cannot have fallen by more
// than this sum: the motion of each joint times the joint's lever arm, plus the motion of the cell's part.
// This gives a lower bound. If it is not above the distance of interest, a closer one follows from two planes
// between the bodies (ClearanceModel::gap). A pair with a bound above that distance need not be computed.

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
  double bound(std::size_t k) const;
  /// Returns true if the distance of pair k is known to be at least `limit` [m], without computing it.
  bool at_least(std::size_t k, double limit);
  /// Computes the distance of pair k at the arm's current position and time. Allocates nothing.
  const Closest& compute(std::size_t k);

  const ClearanceModel& model() const { return *model_; }
  std::size_t size() const { return known_.size(); }
  const JointVector& position() const { return *q_; }
  /// Returns the positions of the parts of the cell [m].
  const std::vector<Vec3>& parts() const { return parts_; }
  /// Returns false if the last motion was not within the positions at which the levers are valid.
  bool levers_hold() const { return levers_hold_; }
  /// Returns the number of distances that were computed.
  long computed() const { return computed_; }

 private:
  /// What is known of a pair, and the state at that time.
  struct Known {
    double least = 0.0;         ///< lower bound of the distance [m]
    JointVector q;              ///< empty: nothing is known
    Vec3 at = Vec3::Zero();     ///< position of the part of the cell
    Vec3 away = Vec3::UnitZ();  ///< Closest::away of the last computed distance, in the frame of away_frame()
  };

  void place();
  Vec3 part_of(const ContactPair& pair) const;
  /// Returns the orientation of the second body of a pair. Bodies that turn together keep a direction in it.
  const Mat3& away_frame(const ContactPair& pair) const;

  std::shared_ptr<const ClearanceModel> model_;
  std::vector<Known> known_;  ///< one per pair
  std::vector<Vec3> parts_;   ///< current positions of the parts of the cell
  JointVector travel_;        ///< largest |q| at which the levers are valid [m]; infinite for revolute joints
  const JointVector* q_ = nullptr;
  bool beyond_ = false;  ///< true if the |q| of a joint exceeds travel_
  bool levers_hold_ = true;
  bool placed_ = false;  ///< true if poses_ was computed for *q_
  Poses poses_;
  Closest closest_;
  long computed_ = 0;
};

}  // namespace armtune::internal
