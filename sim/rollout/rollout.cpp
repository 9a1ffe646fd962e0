#include "sim/rollout/rollout.hpp"

#include "sim/plant/flush_denormals.hpp"
#include "sim/rollout/running_rollout.hpp"
#include "sim/rollout/true_state.hpp"

namespace armtune::internal {

Rollout::Rollout(const Scenario& scenario, Stepper stepper, Engine engine)
    : Rollout(std::make_shared<const PreparedScenario>(scenario), stepper, engine) {}

Rollout::Rollout(std::shared_ptr<const PreparedScenario> prepared, Stepper stepper, Engine engine)
    : prepared_(std::move(prepared)), plant_(make_plant(prepared_->plant, stepper, engine)) {}

RolloutResult Rollout::run(const Gains& gains, const Observer& observer, const EndLimits& limits) {
  const FlushDenormals flush;
  const Scenario& scenario = prepared_->scenario;
  RunningRollout running(*prepared_, gains.slerpAngularErrorThreshold, limits);
  Controller controller(scenario.robot, with_goal(gains, scenario), prepared_->theta_start,
                        scenario.control_period, scenario.mask);
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
      plant_->step(*o.applied, scenario.control_period, o.poses);
    } catch (const std::exception& e) {
      failure = e.what();
    }
    running.moved(plant_->q(), plant_->qd(), failure);
  }
  return running.result();
}

}  // namespace armtune::internal
