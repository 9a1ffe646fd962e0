#include "sim/lanes/rollout_lanes.hpp"

#include <array>
#include <bit>
#include <stdexcept>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/robot/physical_theta.hpp"
#include "sim/lanes/chain_numbers.hpp"
#include "sim/lanes/rollout_lane.hpp"
#include "sim/plant/flush_denormals.hpp"
#include "sim/rollout/true_state.hpp"

namespace armtune::internal {
namespace {

constexpr int kMostLanes = 8;

std::array<double, kMostChainNumbers> numbers_of(const Chain& chain) {
  std::array<double, kMostChainNumbers> numbers{};
  std::size_t count = 0;
  for_each_number(chain, [&](double x) { numbers[count++] = x; });
  return numbers;
}

const double* numbers_of(std::span<const Obstacle> obstacles) {
  static_assert(sizeof(Obstacle) == 4 * sizeof(double));
  return obstacles.empty() ? nullptr : obstacles.front().center.data();
}

}  // namespace

std::optional<ArmLawKind> lane_law(const Gains& gains) {
  return controller_kind(gains.controller).lanes;
}

LaneKind lane_kind(const Scenario& scenario, Stepper stepper, std::size_t most_obstacles, ArmLawKind law) {
  if (stepper == Stepper::kReference) {
    throw InputError("the stepper 'reference' needs Simbody");
  }
  const Chain& chain = scenario.robot->chain;
  const double rate = scenario.plant.rate;
  const int drive_steps =
      commands_drives(law) ? steps_in(scenario.control_period, drive_frequency(*scenario.robot, rate)) : 1;
  return {chain.n,
          chain.motion,
          scenario.mask,
          most_obstacles,
          chain.link_radius.size() > 0,
          scenario.control_period,
          drive_steps,
          steps_in(scenario.control_period / drive_steps, rate),
          stepper,
          law};
}

RolloutLanes::RolloutLanes(const LaneKind& kind, int lanes, Processor processor)
    : kind_(kind), arms_(make_arm_lanes(kind, lanes, processor)) {
  lanes_.resize(static_cast<std::size_t>(arms_->lanes()));
}

RolloutLanes::~RolloutLanes() = default;

bool RolloutLanes::is_busy(int lane) const {
  return lanes_[static_cast<std::size_t>(lane)] != nullptr;
}

double RolloutLanes::time(int lane) const {
  return lanes_[static_cast<std::size_t>(lane)]->running.time();
}

int RolloutLanes::free_lane() const {
  for (int lane = 0; lane < lanes(); ++lane) {
    if (!is_busy(lane)) return lane;
  }
  return -1;
}

void RolloutLanes::start(int lane, LaneJob job) {
  const Scenario& own = job.scenario->scenario;
  const std::optional<ArmLawKind> law = lane_law(job.gains);
  if (!law)
    throw InputError(job.gains.controller +
                     ": rollouts with this controller cannot be simulated in parallel lanes");
  if (own.obstacles.size() > kind_.most_obstacles ||
      lane_kind(own, kind_.stepper, kind_.most_obstacles, *law) != kind_) {
    throw InputError(
        own.name +
        ": the joints, task_mask, control period, rate of plant or drives, obstacles or controller differ from "
        "those of the scenarios that are simulated together with it; simulate this scenario alone");
  }
  auto& place = lanes_[static_cast<std::size_t>(lane)];
  if (place) throw InputError("the lane for " + own.name + " is busy");
  const FlushDenormals flush;  // as at the start of a single Rollout
  const bool first = busy_ == 0;
  place = std::make_unique<Lane>(std::move(job), *law);
  ++busy_;
  const PreparedScenario& scenario = *place->job.scenario;
  const auto control = numbers_of(scenario.scenario.robot->chain);
  const auto plant = numbers_of(scenario.plant.chain);
  const ControlLogic& logic = place->logic;
  LawStorage storage;
  // Lanes without a rollout are computed too. The first rollout gives them its arm, to have valid numbers.
  for (int l = 0; l < lanes(); ++l) {
    if (l != lane && !(first && !is_busy(l))) continue;
    const JointCentering& centering = logic.centering();
    arms_->start(l, {.control_chain = control.data(),
                     .plant_chain = plant.data(),
                     .damping = logic.damping(),
                     .law = law_numbers(place->law_setup(), storage),
                     .centering_middle = centering.middle.data(),
                     .centering_rate = centering.rate.data(),
                     .theta_true = scenario.theta_true.data(),
                     .q = place->q.data(),
                     .qd = place->qd.data()});
  }
}

const World& RolloutLanes::world_of(int lane) {
  Lane& own = *lanes_[static_cast<std::size_t>(lane)];
  own.period = own.running.period();
  for (int l = 0; l < lane; ++l) {
    const Lane* other = lanes_[static_cast<std::size_t>(l)].get();
    if (other != nullptr && other->job.scenario == own.job.scenario && other->period == own.period) {
      own.world_in = other->world_in;
      return *own.world_in;
    }
  }
  world_at(own.running.scenario(), own.period, own.world);
  own.world_in = &own.world;
  return own.world;
}

void RolloutLanes::sense() {
  exact_ = true;
  const Lane* some = nullptr;
  for (int l = 0; l < lanes(); ++l) {
    Lane* lane = lanes_[static_cast<std::size_t>(l)].get();
    if (lane == nullptr) continue;
    some = lane;
    lane->running.sense(lane->q, lane->qd, world_of(l));
    const JointState& measured = lane->running.measured();
    const std::span<const Obstacle> obstacles = lane->running.scene().obstacles;
    arms_->sense(l, {measured.q.data(), measured.qd.data(), numbers_of(obstacles), obstacles.size()});
    exact_ = exact_ && lane->running.measures_exactly();
  }
  if (some == nullptr || busy_ == lanes()) return;
  // A lane without a rollout gets the state of another lane. Computing with extreme values takes longer.
  for (int l = 0; l < lanes(); ++l) {
    if (is_busy(l)) continue;
    const JointState& measured = some->running.measured();
    arms_->sense(l, {measured.q.data(), measured.qd.data(), nullptr, 0});
    arms_->place(l, some->q.data(), some->qd.data());
  }
}

void RolloutLanes::control() {
  arms_->measure();
  bool some_keep_pace = false;
  for (int l = 0; l < lanes(); ++l) {
    Lane* lane = lanes_[static_cast<std::size_t>(l)].get();
    if (lane == nullptr) continue;
    ArmView& view = lane->view;
    arms_->seen(l, {{view.R_0T.data(), view.p_0T.data(), view.twist.data()},
                    &view.manipulability,
                    &view.damped,
                    &view.obstacle_distance});
    const RunningRollout& running = lane->running;
    if (lane->logic.decide(running.measured(), view, running.scene(), running.time())) {
      const TaskReference& task = lane->logic.task_reference();
      const ControlOutput& out = lane->logic.output();
      arms_->follow_task(l,
                         {{task.rate.data(), task.acceleration.data()},
                          out.errors.pose.data(),
                          out.state == ControlState::kAvoidObstacles},
                         lane->logic.Kd().data());
    } else {
      const ControlOutput& out = lane->logic.output();
      arms_->follow_joints(l, {out.reference.velocity.data(), out.reference.acceleration.data()},
                           lane->logic.Kd().data());
      const PlannedJoints& plan = lane->plan.read(out, running.scene(), running.time());
      if (plan.active) {
        arms_->follow_plan(l, {plan.position.data(), plan.velocity.data(), plan.fed_velocity.data()});
      }
    }
    some_keep_pace = some_keep_pace || lane->logic.keeps_pace();
  }
  arms_->resolve();
  for (int l = 0; some_keep_pace && l < lanes(); ++l) {
    Lane* lane = lanes_[static_cast<std::size_t>(l)].get();
    if (lane == nullptr || !lane->logic.keeps_pace()) continue;
    JointReference& reference = lane->logic.output().reference;
    arms_->reference(l, reference.velocity.data(), reference.acceleration.data());
    lane->logic.keep_pace(lane->running.scene(), lane->running.time());
    arms_->replace_reference(l, {reference.velocity.data(), reference.acceleration.data()});
  }
  arms_->torque();
}

void RolloutLanes::act() {
  std::array<bool, kMostLanes> adapting{};
  for (int l = 0; l < lanes(); ++l) {
    if (is_busy(l)) arms_->commanded(l, lanes_[static_cast<std::size_t>(l)]->logic.output().commanded.data());
  }
  if (commands_drives(kind_.law)) begin_drives();
  for (int l = 0; l < lanes(); ++l) {
    Lane* lane = lanes_[static_cast<std::size_t>(l)].get();
    if (lane == nullptr) continue;
    lane->logic.limit_torque(lane->running.measured(), lane->view, lane->running.scene());
    if (lane->drives) lane->drives->keep_added(lane->logic.output().commanded);
    adapting[static_cast<std::size_t>(l)] = lane->logic.conclude();
  }
  arms_->adapt(adapting.data());
  if (kind_.law == ArmLawKind::kAdaptive) project(adapting.data());
  arms_->observe(exact_);
}

void RolloutLanes::project(const bool* adapting) {
  std::array<bool, kMostLanes> projecting{};
  bool some = false;
  for (std::size_t l = 0; l < lanes_.size(); ++l) {
    projecting[l] = adapting[l] && lanes_[l]->logic.gains().adaptation_projection;
    some = some || projecting[l];
  }
  if (!some) return;
  std::array<std::uint32_t, kMostLanes> invalid{};
  arms_->project(projecting.data(), invalid.data());
  for (int l = 0; l < lanes(); ++l) {
    for (std::uint32_t links = invalid[static_cast<std::size_t>(l)]; links != 0; links &= links - 1) {
      const int link = std::countr_zero(links);
      LinkParameters parameters;
      arms_->link_theta(l, link, parameters.data());
      make_physical(parameters);
      arms_->replace_link_theta(l, link, parameters.data());
    }
  }
}

void RolloutLanes::move() {
  const bool adaptive = kind_.law == ArmLawKind::kAdaptive;  // only this law's torque contains -Kd S
  std::array<bool, kMostLanes> moving{};
  for (int l = 0; l < lanes(); ++l) {
    Lane* lane = lanes_[static_cast<std::size_t>(l)].get();
    if (lane == nullptr) continue;
    Observation& o = lane->running.act(lane->logic.output(), lane->job.scenario->theta_start,
                                       adaptive ? &lane->logic.Kd() : nullptr);
    Poses& pose = lane->pose;
    if (exact_) {
      pose.R_0T = lane->view.R_0T;
      pose.p_0T = lane->view.p_0T;
      o.twist = lane->view.twist;
    }
    arms_->observed(
        l, {{pose.R_0T.data(), pose.p_0T.data(), o.twist.data()}, &o.clearance, &o.compensation_error});
    o.poses = &pose;
    see_errors(lane->running.sees_exactly(), o);
    if (lane->running.judge({})) {
      arms_->push(l, o.applied->data());
      moving[static_cast<std::size_t>(l)] = true;
    }
  }
  arms_->step();
  for (int k = 1; k < kind_.drive_steps; ++k) {
    drive(k, moving.data());
    arms_->step();
  }
  for (int l = 0; l < lanes(); ++l) {
    if (!moving[static_cast<std::size_t>(l)]) continue;
    Lane& lane = *lanes_[static_cast<std::size_t>(l)];
    arms_->moved(l, lane.q.data(), lane.qd.data());
    lane.running.moved(lane.q, lane.qd, {});
  }
}

void RolloutLanes::end(int lane, const Finished& finished) {
  RolloutResult result = lanes_[static_cast<std::size_t>(lane)]->running.result();
  lanes_[static_cast<std::size_t>(lane)] = nullptr;
  --busy_;
  finished(lane, std::move(result));
}

void RolloutLanes::step(const Finished& finished) {
  if (busy_ == 0) return;
  {
    const FlushDenormals flush;
    sense();
    control();
    act();
    move();
  }
  for (int l = 0; l < lanes(); ++l) {
    if (is_busy(l) && !lanes_[static_cast<std::size_t>(l)]->running.goes_on()) end(l, finished);
  }
}

}  // namespace armtune::internal
