#pragma once
// Finds the pairs of bodies that need not be examined one by one for a while, because they are far apart. One
// bound holds for all of them: the smallest spare distance of these pairs, minus the motion of each joint
// times the largest of their lever arms, minus the largest motion of a part of the cell.

#include <vector>

#include "sim/cell/pair_distances.hpp"

namespace armtune::internal {

class FarPairs {
 public:
  /// pairs, parts: numbers of pairs and of parts of the cell, so that choose() allocates nothing.
  FarPairs(std::size_t pairs, std::size_t parts);
  /// Chooses the far pairs anew, at the present position. spare: for each pair, a lower bound of its distance
  /// minus the distance of interest [m].
  void choose(const PairDistances& distances, const std::vector<double>& spare);
  /// Returns true if no far pair can have come as near as its distance of interest since choose(), provided
  /// that this distance has not grown. False before the first choose(), or if the position is not a number.
  bool stay_far(const PairDistances& distances) const;
  /// Returns the indices of all other pairs.
  const std::vector<std::size_t>& near() const { return near_; }

 private:
  std::vector<std::size_t> near_;
  JointVector q_;            ///< position at choose(); empty: nothing was chosen yet
  std::vector<Vec3> parts_;  ///< positions of the parts of the cell at choose()
  double spare_ = 0.0;       ///< smallest spare distance of a far pair [m]
  JointVector lever_;        ///< largest lever of a far pair, for each joint
};

}  // namespace armtune::internal
