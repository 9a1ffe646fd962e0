#include "core/control/controller.hpp"

#include "core/control/obstacle_impedance.hpp"
#include "core/control/task_resolution.hpp"

namespace armtune {

Controller::Controller(std::shared_ptr<const RobotModel> model, const Gains& gains,
                       const ParameterVector& theta, double period, TaskMask mask)
    : logic_(std::move(model), gains, period, mask), adaptation_(theta) {}

const ControlOutput& Controller::update(const JointState& measured, const Scene& scene, double time) {
  const Chain& chain = logic_.model().chain;
  ControlOutput& out = logic_.output();
  arm_.measure(chain, measured.q, measured.qd, logic_.damping(), logic_.mask());
  const ArmView view{arm_.poses.R_0T,
                     arm_.poses.p_0T,
                     arm_.twist,
                     arm_.inverse.manipulability(),
                     arm_.inverse.damped(),
                     obstacle_distance(arm_.poses, scene.obstacles),
                     &arm_};
  if (logic_.decide(measured, view, scene, time)) {
    arm_.differentiate(chain, measured.qd);
    resolve(logic_.task_reference(), arm_, logic_.centering(), measured.q, measured.qd, out.reference);
  }
  logic_.keep_pace(scene, time);

  out.S = measured.qd - out.reference.velocity;
  slotine_li_forward(chain, arm_.poses, measured.qd, out.reference.velocity, out.reference.acceleration,
                     motion_);
  slotine_li_torque(chain, arm_.poses, motion_, adaptation_.theta(), out.commanded);
  out.commanded -= logic_.Kd().cwiseProduct(out.S);
  logic_.limit_torque(measured, view, scene);

  if (logic_.conclude()) {
    const Gains& gains = logic_.gains();
    adaptation_.step(motion_, gains.adaptation_gain, logic_.period());
    if (gains.adaptation_leakage > 0.0) adaptation_.leak(gains.adaptation_leakage, logic_.period());
    if (gains.adaptation_projection) adaptation_.project();
  }
  return out;
}

}  // namespace armtune
