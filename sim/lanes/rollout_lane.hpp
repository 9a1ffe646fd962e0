#pragma once
// Private to rollout_lanes.cpp and lane_drives.cpp: the rollout of one lane, that is, of one of the arms that
// are simulated at once. Its sensors, its controller except for the law, and its drives are computed arm by
// arm.

#include "core/control/laws/arm_torque_law.hpp"
#include "core/control/laws/plan_reader.hpp"
#include "sim/lanes/rollout_lanes.hpp"
#include "sim/rollout/running_rollout.hpp"

namespace armtune::internal {

struct RolloutLanes::Lane {
  /// law: the control law of the job's gains.
  Lane(LaneJob given, ArmLawKind law)
      : job(std::move(given)),
        logic(job.scenario->scenario.robot, with_goal(job.gains, job.scenario->scenario),
              job.scenario->scenario.control_period, job.scenario->scenario.mask),
        plan(logic.model().n(), logic.gains(), logic.period()),
        drives(make_drives(law, law_setup())),
        running(*job.scenario, job.gains.slerpAngularErrorThreshold, job.limits,
                drives ? 0 : job.scenario->scenario.plant.torque_delay_periods, drives ? drives->steps() : 1),
        q(job.scenario->scenario.start_position),
        qd(running.start_velocity()) {
    logic.output().commanded.setZero(q.size());
    logic.output().reference = {JointVector::Zero(q.size()), JointVector::Zero(q.size())};
    running.record(job.series);
    weight.setZero(q.size());
  }

  LawSetup law_setup() const {
    return {logic.model(),  logic.gains(), job.scenario->theta_start,
            logic.period(), logic.mask(),  job.scenario->drive_timing()};
  }

  LaneJob job;
  ControlLogic logic;
  PlanReader plan;
  std::optional<JointDrives> drives;
  RunningRollout running;
  JointVector q, qd;   ///< state of the plant
  JointVector weight;  ///< torque that holds the arm, for the drives
  ArmView view;
  Poses pose;  ///< true pose of the tool
  int period = 0;
  World world;
  const World* world_in = nullptr;  ///< `world`, or that of a lane with the same scenario and period
};

}  // namespace armtune::internal
