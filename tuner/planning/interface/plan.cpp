#include "armtune/plan.hpp"

#include <algorithm>

#include "tuner/interface/observing.hpp"
#include "tuner/planning/output/plan_facts.hpp"
#include "tuner/planning/output/plan_sample.hpp"
#include "tuner/planning/session/motion_planner.hpp"
#include "tuner/planning/session/plan_session.hpp"
#include "tuner/record/words.hpp"

namespace armtune {
namespace {

std::vector<double> numbers_of(const internal::JointVector& values) {
  return {values.data(), values.data() + values.size()};
}

std::string name(internal::PlanStatus status) {
  switch (status) {
    case internal::PlanStatus::kSolved:
      return internal::kept_words::kSolved;
    case internal::PlanStatus::kInfeasible:
      return internal::kept_words::kInfeasible;
    case internal::PlanStatus::kStalled:
      return "stalled";
    case internal::PlanStatus::kInterrupted:
      return "interrupted";
  }
  return "";
}

void add_motion(const internal::PlanTask& task, const internal::PlanOutcome& outcome, Plan& plan) {
  const internal::Trajectory& trajectory = outcome.planned.trajectory;
  internal::PlanSampler sampler(task, *outcome.problem, trajectory);
  for (Eigen::Index k = 0; k < trajectory.position.cols(); ++k) {
    const internal::PlanSample& sample = sampler.at_knot(k);
    plan.time.push_back(sample.time);
    plan.position.push_back(numbers_of(sample.q));
    plan.velocity.push_back(numbers_of(sample.qd));
    plan.effort.push_back(numbers_of(sample.tau));
  }
  plan.duration = plan.time.back() - plan.time.front();
}

}  // namespace

Plan plan(const std::string& task, const PlanOptions& options) {
  internal::PlanSettings settings;
  settings.folder = options.folder;
  settings.task = internal::load_plan_task(task);
  const std::atomic<bool> never{false};
  Observing<internal::SessionObserver> observer(options.watch);
  internal::PlanSession session(settings, {options.watch.stop != nullptr ? *options.watch.stop : never},
                                observer);
  const internal::PlanOutcome outcome = session.run();

  Plan plan;
  plan.status = name(outcome.planned.result.status);
  plan.solved = outcome.planned.result.status == internal::PlanStatus::kSolved;
  plan.joints = internal::joint_names(*settings.task.scenario.robot);
  plan.files = outcome.files;
  if (outcome.problem) {
    plan.headline = internal::plan_headline(settings.task, *outcome.problem, outcome.planned);
    if (plan.solved) add_motion(settings.task, outcome, plan);
  }
  for (const internal::LimitUse& use : outcome.uses) {
    const bool between = use.between > use.at_knots;
    plan.limits.push_back({use.limit, use.part, std::max(use.at_knots, use.between),
                           between ? use.between_time : std::numeric_limits<double>::quiet_NaN(),
                           use.share > 0.0});
  }
  return plan;
}

std::shared_ptr<const internal::MotionPlanner> motion_planner() {
  return std::make_shared<const internal::MotionPlanner>(internal::motion_planner());
}

}  // namespace armtune
