#include "core/control/laws/controller.hpp"

#include "core/control/laws/controller_kind.hpp"
#include "core/control/obstacle_distance.hpp"
#include "core/control/task_resolution.hpp"

namespace armtune::internal {

Controller::Controller(std::shared_ptr<const RobotModel> model, const Gains& gains,
                       const ParameterVector& theta, double period, TaskMask mask, const DriveTiming& timing)
    : logic_(std::move(model), gains, period, mask),
      law_(controller_kind(gains.controller)
               .make({logic_.model(), logic_.gains(), theta, period, mask, timing})),
      drives_(law_->drives()) {}

const ControlOutput& Controller::update(const JointState& measured, const Scene& scene, double time) {
  const Chain& chain = logic_.model().chain;
  ControlOutput& out = logic_.output();
  arm_.measure(chain, measured.q, measured.qd, logic_.damping(), logic_.mask());
  const ArmView view{arm_.poses.R_0T,
                     arm_.poses.p_0T,
                     arm_.twist,
                     arm_.inverse.manipulability(),
                     arm_.inverse.damped(),
                     obstacle_distance(chain, arm_.poses, scene.obstacles),
                     &arm_};
  if (logic_.decide(measured, view, scene, time)) {
    arm_.differentiate(chain, measured.qd);
    resolve(logic_.task_reference(), arm_, logic_.centering(), measured.q, measured.qd, out.reference);
  }
  logic_.keep_pace(scene, time);

  out.S = measured.qd - out.reference.velocity;
  law_->torque({measured, arm_, out, logic_.Kd(), scene, time}, out.commanded);
  logic_.limit_torque(measured, view, scene);
  if (has_drives()) drives_->keep_added(out.commanded);
  law_->conclude(logic_.conclude());
  return out;
}

}  // namespace armtune::internal
