// Builds armtune's program with one more controller: sliding mode control with a boundary layer (Slotine and
// Li, Applied Nonlinear Control, section 7.2),
//   tau = Y theta - rho tanh(S / phi).
// It keeps S near zero despite torques of up to rho that the model does not explain.

#include <armtune/controller.hpp>
#include <armtune/program.hpp>

namespace {

Eigen::VectorXd numbers(const armtune::LawSetup& setup, const char* gain) {
  const auto values = setup.gains.numbers(gain);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

class SlidingMode final : public armtune::Law {
 public:
  explicit SlidingMode(const armtune::LawSetup& setup)
      : rho_(numbers(setup, "rho")), phi_(numbers(setup, "phi")) {}

  // Called once per control period. It must not allocate memory.
  void torque(const armtune::LawState& state, Eigen::Ref<Eigen::VectorXd> tau) override {
    state.model_torque(state.reference_velocity(), state.reference_acceleration(), tau);
    tau.array() -= rho_.array() * (state.sliding().array() / phi_.array()).tanh();
  }

 private:
  Eigen::VectorXd rho_, phi_;
};

armtune::ControllerKind sliding_mode() {
  armtune::ControllerKind kind;
  kind.name = "sliding_mode";
  kind.meaning = "sliding mode with a boundary layer: Y theta - rho tanh(S / phi)";
  // The gains of armtune that this controller uses: those of the Cartesian references qr' and qr''.
  kind.uses = {"task_space_gains_p", "task_space_gains_i"};
  // The controller's own gains. Files, --help, search space, journal and report take them from this list.
  constexpr auto kJoints = armtune::GainShape::kJoints;
  kind.own = {{kJoints, "rho", "N m", "most torque against what the model does not know", 30.0},
              {.shape = kJoints,
               .name = "phi",
               .unit = "rad/s",
               .meaning = "S at which tanh has most of it",
               .otherwise = 0.3,
               .positive = true,
               .in_loop = false}};
  kind.make = [](const armtune::LawSetup& setup) { return std::make_unique<SlidingMode>(setup); };
  // The start gains of a search: a share of the effort limits, and a slope rho / phi in proportion to the
  // inertia of each joint.
  kind.start = [](const armtune::Robot& robot, std::span<const double> q, armtune::Gains& gains) {
    const std::vector<double> inertia = armtune::joint_inertia(robot, q);
    const std::vector<double> effort = robot.effort_limits();
    for (std::size_t i = 0; i < effort.size(); ++i) {
      gains.numbers("rho")[i] = 0.2 * effort[i];
      gains.numbers("phi")[i] = 0.2 * effort[i] / (armtune::first_rate() * inertia[i]);
    }
  };
  return kind;
}

}  // namespace

int main(int argc, char** argv) {
  armtune::register_controller(sliding_mode());
  return armtune::run_program(argc, argv);
}
