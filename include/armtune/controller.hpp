#pragma once
// The interface for adding a controller of your own. You write a control law, which computes joint torques
// from references and the measured state, and you declare its gains.
//
// armtune supplies the rest, which is the same for every controller: the state machine, the references for
// the tool's path and gaze, trajectories that lead the tool back to the path, the repulsion from obstacles,
// the velocity governor and the effort limits.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "armtune/gains.hpp"
#include "armtune/robot.hpp"

namespace armtune {

namespace internal {
struct LawInput;
}

/// The inputs of a control law in one control period, for an arm of n joints. The object is valid only during
/// the call that receives it.
class LawState {
 public:
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  using Jacobian = Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic>>;

  Vector position() const;                ///< q, measured (n) [rad, m]
  Vector velocity() const;                ///< q', measured (n) [rad/s, m/s]
  Vector reference_velocity() const;      ///< qr' (n) [rad/s, m/s]
  Vector reference_acceleration() const;  ///< qr'' (n) [rad/s^2, m/s^2]
  Vector sliding() const;                 ///< S = q' - qr' (n) [rad/s, m/s]
  Vector damping() const;                 ///< damping gains Kd of the current state (n) [N m s/rad, N s/m]
  Jacobian jacobian() const;              ///< J of the tool, (v, w) = J q' in the base frame (6 x n)
  /// Returns the name of the current state of the controller's state machine, such as "followTrajectory".
  const char* state() const;
  /// True in states whose reference is a joint motion. In these states the tool follows no path and aims at
  /// no target.
  bool tracks_joints() const;

  /// Computes tau = M(q) a + C(q, q') v + g(q) + friction(q') with the controller's model of the arm (n
  /// each). Allocates nothing. Throws InputError if a vector does not have n entries.
  void model_torque(const Eigen::Ref<const Eigen::VectorXd>& v, const Eigen::Ref<const Eigen::VectorXd>& a,
                    Eigen::Ref<Eigen::VectorXd> tau) const;

 private:
  friend class LawInside;
  LawState(const internal::LawInput& in, class LawInside& law) : in_(in), law_(law) {}
  const internal::LawInput& in_;
  class LawInside& law_;
};

/// A control law: the base class to derive from.
class Law {
 public:
  Law() = default;
  Law(const Law&) = delete;
  Law& operator=(const Law&) = delete;
  virtual ~Law() = default;

  /// Sets the torques (n) [N m, N]. armtune then adds the repulsion from obstacles and the damping of the
  /// velocity barrier, which acts near the velocity limits. Finally, it applies the effort limits. This
  /// function is called once in every control period and must not allocate.
  virtual void torque(const LawState& state, Eigen::Ref<Eigen::VectorXd> tau) = 0;
  /// Is called at the end of every control period, for example to adapt parameters of the law. learning: true
  /// if no joint was saturated and adaptation is wanted.
  virtual void conclude(bool /*learning*/) {}
  /// True if every torque contains -Kd S, with the Kd of LawState::damping. If a rollout diverges, armtune
  /// then checks whether this Kd is too high for the control period.
  virtual bool contains_damping() const { return false; }
};

/// The number of values of a gain.
enum class GainShape {
  kScalar,
  kTask,   ///< six: x y z rx ry rz
  kJoints  ///< one for each joint
};

/// The declaration of a gain that belongs to one controller only. From it, armtune builds the gain's entries
/// in gains files, help texts, search space, journal (log of a search) and report.
struct GainDeclaration {
  GainShape shape = GainShape::kScalar;
  std::string name = {};
  std::string unit = {};
  std::string meaning = {};   ///< description in a few words
  double otherwise = 0.0;     ///< default value, the same for each of its values
  bool positive = false;      ///< zero is refused
  bool in_loop = true;        ///< true if the gain scales the loop gain; false for a length, angle or scale
  double lower_factor = 0.2;  ///< default lower bound of the search, as a factor on the start value
  double upper_factor = 5.0;  ///< default upper bound, in the same way; a study can set both
};

/// The data that a law is constructed from.
struct LawSetup {
  Robot robot;  ///< the controller's model of the arm
  Gains gains;
  double period;  ///< control period [s]
  std::vector<double>
      theta;  ///< parameters of the controller's model of the arm: 13 for each joint (docs/theory.md)
};

/// A kind of controller. A gains file selects it with "controller: NAME".
struct ControllerKind {
  std::string name = {};
  std::string meaning = {};  ///< description in one line
  /// Names of armtune's own gains that the law uses, such as "task_space_gains_p".
  std::vector<std::string> uses = {};
  std::vector<GainDeclaration> own = {};
  std::function<std::unique_ptr<Law>(const LawSetup&)> make = {};
  bool learns = false;  ///< true if the law adapts its model of the arm online
  /// Sets start values of the kind's own gains for an arm that has no gains yet. q (n): joint positions
  /// with the tool on its path. If this function is empty, the gains get their declared defaults.
  std::function<void(const Robot&, std::span<const double> q, Gains&)> start = {};
};

/// Adds a kind of controller. Call it before any gains, scenario or study is loaded, and while nothing is
/// simulated. Throws InputError if the name of the kind or of a gain is taken or not allowed, if `make` is
/// empty, if a gain's default or search factors are out of range, or if `uses` names a gain that does not
/// belong to a law.
void register_controller(const ControllerKind& kind);

/// Returns the inertia that each joint moves at q (n) while the others are free, 1 / (M^-1)_ii [kg m^2, kg].
/// Start gains are usually proportional to it. Throws InputError if q has another size.
std::vector<double> joint_inertia(const Robot& robot, std::span<const double> q);

/// Returns a closed-loop rate [1/s] that an arm's controller can usually reach. Start gains are this rate
/// times an inertia.
double first_rate();

}  // namespace armtune
