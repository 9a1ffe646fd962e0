#pragma once
// Lists the pairs of bodies that must not touch: two links of the arm, or a link and a part of the robot cell
// or the floor. It also computes the distance between the two bodies of a pair.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/robot/kinematics.hpp"
#include "sim/cell/arm_solids.hpp"
#include "sim/cell/cell.hpp"

namespace armtune::internal {

/// The kinds of things that a body of the arm must not touch: the arm itself, parts of the cell, the floor.
enum class Clearance : std::size_t { kSelf, kCell, kFloor, kCount };
inline constexpr std::size_t kClearances = static_cast<std::size_t>(Clearance::kCount);

/// A body of the arm, and the body that it must not touch.
struct ContactPair {
  Clearance of = Clearance::kSelf;
  std::size_t solid = 0;  ///< index of a solid of the arm
  std::size_t other = 0;  ///< kSelf: index of another solid of the arm, closer to the base; kCell: index of a
                          ///< part of the cell; kFloor: 0
  /// Upper bound of the change of the distance per unit of motion of each joint (n) [m/rad, m/m]. It is valid
  /// at all positions within the joint limits.
  JointVector lever;
};

/// The names of two links, the one closer to the base first.
using LinkPair = std::array<std::string, 2>;

class ClearanceModel {
 public:
  /// A robot without known shapes has no pairs.
  ClearanceModel(std::shared_ptr<const RobotModel> robot, Cell cell);

  const std::vector<ContactPair>& pairs() const { return pairs_; }
  bool has(Clearance kind) const;
  const Cell& cell() const { return cell_; }
  const ArmSolids& arm() const { return arm_; }
  const RobotModel& robot() const { return *robot_; }
  /// Returns the pairs of links of the arm that are not checked: neighbours, and links whose shapes touch at
  /// nearly every position within the joints' limits.
  const std::vector<LinkPair>& left_out() const { return left_out_; }
  /// Returns those pairs of left_out() whose links are not neighbours, such as "link_5 and link_7". Their
  /// shapes touch at nearly every position.
  std::vector<std::string> left_out_by_their_make() const;

  /// Returns a copy in which the obstacles move along other paths. paths: one for each part of the cell with
  /// is_obstacle, in the order of the parts.
  ClearanceModel with_obstacles_on(const std::vector<Path>& paths) const;
  /// Returns a copy that does not check distances from obstacles.
  ClearanceModel without_obstacles() const;

  /// Returns the distance between the two bodies of a pair for these poses of the arm. at: position of the
  /// part of the cell, base frame [m]; used only for pairs of the kind kCell.
  Closest distance(const ContactPair& pair, const Poses& poses, const Vec3& at) const;

  /// Returns a lower bound of that distance, at a small part of its cost: the distance of two parallel planes
  /// between which neither body reaches, negative if there are none. away: their normal, a unit vector from
  /// the second body to the first, base frame. The bound is the distance itself if `away` is Closest::away.
  double gap(const ContactPair& pair, const Poses& poses, const Vec3& at, const Vec3& away) const;

  /// Distances are computed only at certain times, which are `period` [s] apart. Returns an upper bound [m]
  /// for all pairs of how far a distance can fall between two such times below its smaller value at both of
  /// them. The bound assumes that the joints keep their velocity limits and that the cell rests. If a part of
  /// the cell moves, add half of the way that it moves in a period.
  double most_unseen(double period) const;

  /// Returns the name of a pair, such as "forearm_link and table".
  std::string name(const ContactPair& pair) const;

 private:
  void add_self_pairs();
  void add_cell_pairs();
  void add_floor_pairs();
  /// Tests 200 fixed joint positions. True if the two bodies do not touch at `fewest` or more of them.
  /// sampled: the arm's poses at the first of these positions. Poses that are needed and missing are added.
  bool is_free_at(unsigned fewest, const ContactPair& pair, std::vector<Poses>& sampled) const;
  ContactPair pair(Clearance of, std::size_t solid, std::size_t other) const;
  JointVector floor_levers(JointVector lever) const;

  std::shared_ptr<const RobotModel> robot_;
  Cell cell_;
  Vec3 up_;
  ArmSolids arm_;
  std::vector<ContactPair> pairs_;
  std::vector<LinkPair> left_out_;
};

}  // namespace armtune::internal
