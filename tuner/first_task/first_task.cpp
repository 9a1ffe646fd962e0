#include "tuner/first_task/first_task.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "armtune/error.hpp"
#include "core/control/laws/starting_gains.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/perturbation.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/first_task/estimated_robot.hpp"

namespace armtune::internal {
namespace {

constexpr std::array kSlowness = {1.0, 2.0, 4.0};
constexpr std::array kCalmer = {1.0, 0.7, 0.5, 0.35};       // factors on Kp and Kd
constexpr std::array kLearnSlower = {1.0, 0.1, 0.01, 0.0};  // factors on the adaptation

/// Starting gains with slower errors: S dies with M^-1 Kd, then the error with Kp, so both are lowered.
Gains calmed(Gains gains, double calmer, double learning) {
  gains.joint_space_gains_p *= calmer;
  gains.joint_space_gains_d *= calmer;
  gains.task_space_gains_p *= calmer;
  gains.task_space_gains_d *= calmer;
  gains.adaptation_gain *= learning;
  return gains;
}

bool keeps_limits(const RolloutResult& result) {
  const Metrics& metrics = result.metrics;
  return result.status == RolloutStatus::kCompleted &&
         metrics[Metric::kJointVelocityMaxRatio] <= kFirstTaskRatio &&
         metrics[Metric::kJointEffortMaxRatio] <= kFirstTaskRatio &&
         !(metrics[Metric::kJointPositionMinMargin] < 0.0) && contact_text(metrics).empty();
}

/// What a rollout that does not keep its limits has to say.
std::string failure(const RolloutResult& result) {
  if (result.status != RolloutStatus::kCompleted) return result.reason;
  const Metrics& metrics = result.metrics;
  if (metrics[Metric::kJointPositionMinMargin] < 0.0) return "a joint leaves its position limits";
  if (const std::string contact = contact_text(metrics); !contact.empty()) return "the arm " + contact;
  if (metrics[Metric::kJointVelocityMaxRatio] > kFirstTaskRatio) {
    return fmt::format("{} reaches {:.3g} of its velocity limit", metrics.max_ratio_joint,
                       metrics[Metric::kJointVelocityMaxRatio]);
  }
  return fmt::format("a commanded torque reaches {:.3g} of its effort limit",
                     metrics[Metric::kJointEffortMaxRatio]);
}

/// One task, and every pair of factors until the arm completes it.
class Trial {
 public:
  explicit Trial(DefaultTask task)
      : task_(std::move(task)),
        start_(starting_gains(*task_.scenario.robot, task_.scenario.start_position, task_.goal,
                              task_.manipulability)),
        native_(task_.scenario, Stepper::kMidpoint, Engine::kNative) {
    if (task_.scenario.robot->estimated_rotors.empty()) return;
    for (const double factor : {1.0 / kRotorFactor, kRotorFactor})
      other_rotors_.push_back(with_rotors_scaled(task_.scenario, factor));
  }

  std::optional<FirstTask> find() {
    for (const double calmer : kCalmer) {
      for (const double learning : kLearnSlower) {
        const Gains gains = calmed(start_, calmer, learning);
        if (const auto metrics = completed_with(gains)) return FirstTask{task_, gains, *metrics, "", ""};
      }
    }
    return std::nullopt;
  }

  /// How the last rollout failed.
  const std::string& failed() const { return failed_; }

 private:
  /// armtune's own dynamics are quick, Simbody decides.
  std::optional<Metrics> completed_with(const Gains& gains) {
    const RolloutResult quick = native_.run(gains);
    if (!passes(quick, "")) return std::nullopt;
    if (!simbody_) simbody_.emplace(task_.scenario, Stepper::kMidpoint, Engine::kSimbody);
    const RolloutResult result = simbody_->run(gains);
    if (!passes(result, "")) return std::nullopt;
    for (const Scenario& scenario : other_rotors_) {
      Rollout other(scenario, Stepper::kMidpoint, Engine::kSimbody);
      if (!passes(other.run(gains), " with other rotor inertia than estimated")) return std::nullopt;
    }
    return result.metrics;
  }

  bool passes(const RolloutResult& result, const char* where) {
    if (keeps_limits(result)) return true;
    failed_ = failure(result) + where;
    return false;
  }

  DefaultTask task_;
  Gains start_;
  Rollout native_;
  std::optional<Rollout> simbody_;
  std::vector<Scenario> other_rotors_;  ///< a third and three times what was estimated
  std::string failed_;
};

}  // namespace

FirstTask find_first_task(const std::string& robot, const TaskOptions& options) {
  const RobotFile file = read_robot_file(robot);
  std::shared_ptr<const RobotModel> arm = load_robot(robot);
  std::string robot_yaml;
  if (lacks_rotors(file, *arm)) {
    RobotModel estimated = *arm;
    estimate_rotors(estimated);
    robot_yaml = estimated_robot_yaml(file, estimated);
    arm = std::make_shared<const RobotModel>(std::move(estimated));
  }
  TaskOptions in_cell = options;
  std::vector<std::string> inputs;
  if (const auto cell = cell_of(file, inputs)) {
    if (options.floor) {
      throw InputError(fmt::format(
          "{}: its 'cell' says what stands around the arm; leave --floor out, and give 'floor' there",
          file.path));
    }
    in_cell.cell = *cell;
  }
  std::string failed;
  for (const double slowness : kSlowness) {
    TaskOptions slower = in_cell;
    slower.slowness *= slowness;
    Trial trial(default_task(arm, slower));
    if (auto found = trial.find()) {
      found->robot_file = robot_yaml.empty() ? portable_reference(file.path) : "robot.yaml";
      found->robot_yaml = robot_yaml;
      return *found;
    }
    failed = trial.failed();
  }
  throw InputError(fmt::format(
      "{}: no gains were found with which {} completes a first task within its limits. With the calmest of those "
      "tried, {}. Check limits and masses, or write a scenario and gains of its own",
      arm->source, arm->name, failed));
}

}  // namespace armtune::internal
