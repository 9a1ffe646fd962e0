#include "armtune/controller.hpp"

#include <fmt/format.h>

#include <deque>

#include "armtune/error.hpp"

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/first_gains.hpp"
#include "core/control/state_machine.hpp"

namespace armtune {
namespace {

/// Returns a copy of the robot, because the receiver may keep it.
Robot copied(const internal::RobotModel& model) {
  return Robot(std::make_shared<const internal::RobotModel>(model));
}

LawState::Vector mapped(const internal::JointVector& values) {
  return {values.data(), values.size()};
}

internal::JointVector joint_vector(std::span<const double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

/// Wraps a control law of the public interface as a law of armtune's controller.
class LawInside final : public internal::TorqueLaw {
 public:
  LawInside(const internal::LawSetup& setup, std::unique_ptr<Law> law)
      : TorqueLaw(setup), law_(std::move(law)), tau_(setup.model.n()) {}

  void torque(const internal::LawInput& in, internal::JointVector& tau) override {
    tau.resize(in.measured.q.size());
    law_->torque(LawState(in, *this), Eigen::Map<Eigen::VectorXd>(tau.data(), tau.size()));
  }

  void conclude(bool learning) override { law_->conclude(learning); }
  bool contains_Kd() const override { return law_->contains_damping(); }

  using TorqueLaw::model_torque;

 private:
  friend class LawState;
  std::unique_ptr<Law> law_;
  internal::JointVector v_, a_, tau_;
};

LawState::Vector LawState::position() const {
  return mapped(in_.measured.q);
}
LawState::Vector LawState::velocity() const {
  return mapped(in_.measured.qd);
}
LawState::Vector LawState::reference_velocity() const {
  return mapped(in_.control.reference.velocity);
}
LawState::Vector LawState::reference_acceleration() const {
  return mapped(in_.control.reference.acceleration);
}
LawState::Vector LawState::sliding() const {
  return mapped(in_.control.S);
}
LawState::Vector LawState::damping() const {
  return mapped(in_.Kd);
}
LawState::Jacobian LawState::jacobian() const {
  return {in_.arm.J.data(), 6, in_.arm.J.cols()};
}
const char* LawState::state() const {
  return internal::name(in_.control.state);
}
bool LawState::tracks_joints() const {
  return internal::tracks_joints(in_.control.state);
}

void LawState::model_torque(const Eigen::Ref<const Eigen::VectorXd>& v,
                            const Eigen::Ref<const Eigen::VectorXd>& a,
                            Eigen::Ref<Eigen::VectorXd> tau) const {
  const Eigen::Index n = in_.measured.q.size();
  if (v.size() != n || a.size() != n || tau.size() != n) {
    throw InputError(fmt::format("model_torque: v, a and tau must have {} numbers each", n));
  }
  law_.v_ = v;
  law_.a_ = a;
  law_.model_torque(in_.arm, in_.measured.qd, law_.v_, law_.a_, law_.tau_);
  tau = law_.tau_;
}

void register_controller(const ControllerKind& kind) {
  // The fields hold pointers to these texts, which must therefore exist until the program ends.
  static std::deque<std::string> texts;
  const auto kept = [](const std::string& text) { return texts.emplace_back(text).c_str(); };
  internal::ControllerKind inside;
  inside.name = kind.name;
  inside.meaning = kind.meaning;
  inside.uses = kind.uses;
  inside.learns = kind.learns;
  for (const GainDeclaration& gain : kind.own) {
    constexpr internal::GainShape kShapes[] = {internal::GainShape::kScalar, internal::GainShape::kTask,
                                               internal::GainShape::kJoints};
    internal::GainField field =
        internal::own_gain(kShapes[static_cast<std::size_t>(gain.shape)], kept(gain.name), kept(gain.unit),
                           kept(gain.meaning), gain.otherwise, gain.lower_factor, gain.upper_factor);
    if (gain.positive) field = internal::positive(field);
    if (!gain.in_loop) field = internal::not_in_loop(field);
    inside.own.push_back(field);
  }
  inside.make = [make = kind.make](const internal::LawSetup& setup) {
    return std::make_unique<LawInside>(setup,
                                       make({copied(setup.model),
                                             Gains(setup.gains, internal::joint_names(setup.model)),
                                             setup.period,
                                             {setup.theta.data(), setup.theta.data() + setup.theta.size()}}));
  };
  if (kind.start) {
    inside.start = [start = kind.start](const internal::RobotModel& robot, const internal::JointVector& q,
                                        internal::Gains& gains) {
      Gains given(gains, internal::joint_names(robot));
      start(copied(robot), {q.data(), static_cast<std::size_t>(q.size())}, given);
      gains = given.inside();
    };
  }
  internal::register_controller(std::move(inside));
}

std::vector<double> joint_inertia(const Robot& robot, std::span<const double> q) {
  if (q.size() != robot.joints().size()) {
    throw InputError(fmt::format("joint_inertia: {} positions are given, but {} has {} joints", q.size(),
                                 robot.name(), robot.joints().size()));
  }
  const internal::JointVector inertia = internal::joint_inertia(*robot.model(), joint_vector(q));
  return {inertia.data(), inertia.data() + inertia.size()};
}

double first_rate() {
  return internal::kFirstRate;
}

}  // namespace armtune
