// A controller that armtune does not have, tuned by everything armtune has: sliding mode control with a
// boundary layer (Slotine and Li, Applied Nonlinear Control, section 7.2),
//   tau = Y theta - rho tanh(S / phi),
// that holds S at zero against whatever the model does not know, up to rho.

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/first_gains.hpp"
#include "tuner/cli/program.hpp"

namespace {

using namespace armtune;

class SlidingMode final : public TorqueLaw {
 public:
  explicit SlidingMode(const LawSetup& setup)
      : TorqueLaw(setup), rho_(own(setup.gains, "rho")), phi_(own(setup.gains, "phi")) {}

  // Once per control period; nothing here may allocate.
  void torque(const LawInput& in, JointVector& tau) override {
    const JointReference& reference = in.control.reference;
    model_torque(in.arm, in.measured.qd, reference.velocity, reference.acceleration, tau);
    tau.array() -= rho_.array() * (in.control.S.array() / phi_.array()).tanh();
  }

 private:
  JointVector rho_, phi_;
};

ControllerKind sliding_mode() {
  ControllerKind kind;
  kind.name = "sliding_mode";
  kind.meaning = "sliding mode with a boundary layer: Y theta - rho tanh(S / phi)";
  // Of armtune's own gains, those of the Cartesian references qr' and qr''.
  kind.uses = {"task_space_gains_p", "task_space_gains_i"};
  // One line each: files, --help, search space, journal and report know it from here.
  constexpr auto kJoints = GainShape::kJoints;
  kind.own = {
      own_gain(kJoints, "rho", "N m", "most torque against what the model does not know", 30.0),
      not_in_loop(positive(own_gain(kJoints, "phi", "rad/s", "S at which tanh has most of it", 0.3)))};
  kind.make = [](const LawSetup& setup) { return std::make_unique<SlidingMode>(setup); };
  // Where a search begins: a share of what the motors can do, with a slope that every joint's inertia stands.
  kind.start = [](const RobotModel& robot, const JointVector& q, Gains& gains) {
    own(gains, "rho") = 0.2 * robot.effort_limits();
    own(gains, "phi") = own(gains, "rho").cwiseQuotient(kFirstRate * joint_inertia(robot, q));
  };
  return kind;
}

}  // namespace

int main(int argc, char** argv) {
  armtune::register_controller(sliding_mode());
  return armtune::cli::run(argc, argv);
}
