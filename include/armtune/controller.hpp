#pragma once
// Controllers of one's own: a law that turns references into joint torques, and the declaration of its gains.
// States, references, gaze, returns, obstacles, the velocity governor and the limits are those of every
// controller.

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

/// One control period as a law sees it, on an arm of n joints. It lives for the call alone.
class LawState {
 public:
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  using Jacobian = Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic>>;

  Vector position() const;                ///< q, measured (n) [rad, m]
  Vector velocity() const;                ///< q', measured (n) [rad/s, m/s]
  Vector reference_velocity() const;      ///< qr' (n) [rad/s, m/s]
  Vector reference_acceleration() const;  ///< qr'' (n) [rad/s^2, m/s^2]
  Vector sliding() const;                 ///< S = q' - qr' (n) [rad/s, m/s]
  Vector damping() const;                 ///< Kd of the active state (n) [N m s/rad, N s/m]
  Jacobian jacobian() const;              ///< of the tool, (v, w) = J q' in the base frame (6 x n)
  /// The controller's state, such as "followTrajectory".
  const char* state() const;
  /// True in states whose reference is a joint motion: there is neither a path nor a gaze in them.
  bool tracks_joints() const;

  /// tau = M(q) a + C(q, q') v + g(q) + friction(q') of the arm as the controller knows it (n each).
  /// Allocates nothing. Throws InputError if one has another size.
  void model_torque(const Eigen::Ref<const Eigen::VectorXd>& v, const Eigen::Ref<const Eigen::VectorXd>& a,
                    Eigen::Ref<Eigen::VectorXd> tau) const;

 private:
  friend class LawInside;
  LawState(const internal::LawInput& in, class LawInside& law) : in_(in), law_(law) {}
  const internal::LawInput& in_;
  class LawInside& law_;
};

class Law {
 public:
  Law() = default;
  Law(const Law&) = delete;
  Law& operator=(const Law&) = delete;
  virtual ~Law() = default;

  /// Sets the torques (n) [N m, N] before repulsion, velocity barrier and effort limits. Called once in every
  /// control period; nothing in it may allocate.
  virtual void torque(const LawState& state, Eigen::Ref<Eigen::VectorXd> tau) = 0;
  /// The period is over. learning: no joint was saturated, and adaptation is wanted.
  virtual void conclude(bool /*learning*/) {}
  /// True if every torque contains -Kd S, with the Kd of LawState::damping.
  virtual bool contains_damping() const { return false; }
};

/// How many numbers a gain has.
enum class GainShape {
  kScalar,
  kTask,   ///< six: x y z rx ry rz
  kJoints  ///< one for each joint
};

/// A gain that a controller alone has. Files, help, search space, journal and report know it from here.
struct GainDeclaration {
  GainShape shape = GainShape::kScalar;
  std::string name = {};
  std::string unit = {};
  std::string meaning = {};  ///< a few words
  double otherwise = 0.0;    ///< each of its numbers where nothing else is said
  bool positive = false;     ///< zero is refused
  bool in_loop = true;  ///< a factor on it is one on the loop's gain: not so for a length, an angle, a scale
  double lower_factor = 0.2;  ///< it is searched from here ...
  double upper_factor = 5.0;  ///< ... to there times its start, unless a study says otherwise
};

/// What a law is made from.
struct LawSetup {
  Robot robot;  ///< as the controller knows it
  Gains gains;
  double period;  ///< of control [s]
  std::vector<double>
      theta;  ///< what the controller takes the arm for: 13 numbers for each joint (docs/theory.md)
};

/// A kind of controller, as gains files name it: "controller: NAME".
struct ControllerKind {
  std::string name = {};
  std::string meaning = {};  ///< one line
  /// Those of armtune's gains that the law has, such as "task_space_gains_p".
  std::vector<std::string> uses = {};
  std::vector<GainDeclaration> own = {};
  std::function<std::unique_ptr<Law>(const LawSetup&)> make = {};
  bool learns = false;  ///< true if the law adapts its model of the arm online
  /// Sets own gains to begin with, on an arm without any that is at q (n) on its task; empty: they are as
  /// declared.
  std::function<void(const Robot&, std::span<const double> q, Gains&)> start = {};
};

/// Adds a kind, before anything is loaded and while nothing is simulated. Throws InputError if its name or
/// that of a gain is taken, or `uses` names a gain that is none of a law.
void register_controller(const ControllerKind& kind);

/// What each joint feels at q (n) with the others free, 1 / (M^-1)_ii [kg m^2, kg]: first gains follow it.
/// Throws InputError if q has another size.
std::vector<double> joint_inertia(const Robot& robot, std::span<const double> q);

/// A rate [1/s] that an arm's controller can hold to begin with: first gains are it times an inertia.
double first_rate();

}  // namespace armtune
