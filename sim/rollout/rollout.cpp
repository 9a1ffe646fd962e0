#include "sim/rollout/rollout.hpp"

#include <cmath>

#include "sim/plant/flush_denormals.hpp"
#include "sim/rollout/running_rollout.hpp"
#include "sim/rollout/true_state.hpp"

namespace armtune::internal {

Rollout::Rollout(const Scenario& scenario, Stepper stepper, Engine engine)
    : Rollout(std::make_shared<const PreparedScenario>(scenario), stepper, engine) {}

Rollout::Rollout(std::shared_ptr<const PreparedScenario> prepared, Stepper stepper, Engine engine)
    : prepared_(std::move(prepared)), plant_(make_plant(prepared_->plant, stepper, engine)) {}

RolloutResult Rollout::run(const Gains& gains, const Observer& observer, const EndLimits& limits,
                           const std::vector<Metric>& series) {
  const FlushDenormals flush;
  const Scenario& scenario = prepared_->scenario;
  const PlantConditions& conditions = scenario.plant;
  Controller controller(scenario.robot, with_goal(gains, scenario), prepared_->theta_start,
                        scenario.control_period, scenario.mask, prepared_->drive_timing());
  // Commands for drives are late on their way to the drives, which then act at once.
  RunningRollout running(*prepared_, gains.slerpAngularErrorThreshold, limits,
                         controller.has_drives() ? 0 : conditions.torque_delay_periods,
                         controller.drive_steps());
  running.record(series);
  // The arm takes whole steps in each period of the drives, and without drives in each control period.
  const int held = steps_in(scenario.control_period / controller.drive_steps(), conditions.rate);
  const int steps = controller.drive_steps() * held;
  const double step = scenario.control_period / steps;
  TrueState truth(*scenario.robot, prepared_->theta_true);
  plant_->set_state(scenario.start_position, running.start_velocity());
  World world;
  while (running.goes_on()) {
    world_at(scenario, running.period(), world);
    running.sense(plant_->q(), plant_->qd(), world);
    const ControlOutput& out = controller.update(running.measured(), running.scene(), running.time());
    Observation& o = running.act(out, controller.theta(), controller.Kd());
    truth.observe(running, controller, o);
    if (!running.judge(observer)) break;
    std::string failure;
    try {
      plant_->step(*o.applied, step, o.poses);
      const JointVector* torque = o.applied;
      for (int k = 1; k < steps && std::isfinite(plant_->qd().sum()); ++k) {
        if (k % held == 0) {
          DriveInstant& at = running.begin_drive_period(k * step, plant_->q(), plant_->qd());
          controller.drive(running.measured_by_drives(), at.commanded, at.torque);
          torque = &at.torque;
        }
        plant_->step(*torque, step);
      }
    } catch (const std::exception& e) {
      failure = e.what();
    }
    running.moved(plant_->q(), plant_->qd(), failure);
  }
  return running.result();
}

}  // namespace armtune::internal
