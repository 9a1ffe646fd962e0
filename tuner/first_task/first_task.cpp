#include "tuner/first_task/first_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
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
#include "tuner/first_task/first_gain_sets.hpp"
#include "tuner/first_task/first_study.hpp"

namespace armtune::internal {
namespace {

/// A pace, and at how many places it is tried: a slow task takes longer to try.
struct Pace {
  double slowness;
  std::size_t places;
};
constexpr std::array kPaces = {Pace{1.0, 6}, Pace{2.0, 2}, Pace{4.0, 1}};

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

/// One task, and gain sets until the arm completes it.
class Trial {
 public:
  Trial(DefaultTask task, int workers)
      : task_(std::move(task)),
        gains_(first_gain_sets(starting_gains(*task_.scenario.robot, task_.scenario.start_position,
                                              task_.goal, task_.manipulability))),
        native_({task_.scenario}, Stepper::kMidpoint, workers),
        demands_(task_.scenario, gains_.front(), workers) {
    if (task_.scenario.robot->estimated_rotors.empty()) return;
    for (const double factor : {1.0 / kRotorFactor, kRotorFactor})
      other_rotors_.push_back(with_rotors_scaled(task_.scenario, factor));
  }

  std::optional<FirstTask> find() {
    const std::atomic<bool> stop = false;
    Conditions conditions;
    conditions.engine = Engine::kNative;
    const auto quick = *native_.run(gains_, stop, {}, conditions);
    for (std::size_t i = 0; i < gains_.size(); ++i) {
      if (!passes(quick[i].front(), "")) continue;
      if (const auto metrics = completed_with(gains_[i]))
        return FirstTask{task_, gains_[i], *metrics, "", ""};
    }
    return std::nullopt;
  }

  /// How the last rollout failed.
  const std::string& failed() const { return failed_; }

 private:
  /// armtune's own dynamics are quick, Simbody decides.
  std::optional<Metrics> completed_with(const Gains& gains) {
    if (const std::string broken = demands_.broken(gains); !broken.empty()) {
      failed_ = broken;
      return std::nullopt;
    }
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
  std::vector<Gains> gains_;
  CandidateRunner native_;
  FirstDemands demands_;
  std::optional<Rollout> simbody_;
  std::vector<Scenario> other_rotors_;  ///< a third and three times what was estimated
  std::string failed_;
};

using Progress = std::function<void(const std::string&)>;

/// Tasks of an arm, where it moves well first, and each at several paces.
class Search {
 public:
  /// progress: outlives the search.
  Search(std::shared_ptr<const RobotModel> arm, TaskOptions options, int workers, const Progress& progress)
      : arm_(std::move(arm)), options_(std::move(options)), workers_(workers), progress_(progress) {}

  /// Throws InputError if there is not one task for the arm.
  std::optional<FirstTask> find() {
    std::size_t there_are = kPaces.front().places;
    for (const Pace& pace : kPaces) {
      for (std::size_t place = 0; place < std::min(pace.places, there_are); ++place) {
        if (progress_) {
          progress_(fmt::format("trying a first task{}{}: place {} of {}, {} times its time",
                                options_.position_alone ? " of position alone" : "",
                                options_.without_floor ? " without a floor" : "", place + 1, pace.places,
                                pace.slowness));
        }
        std::optional<DefaultTask> task = task_at(place, pace.slowness);
        if (!task) {
          there_are = place;
          break;
        }
        Trial trial(std::move(*task), workers_);
        if (auto found = trial.find()) return found;
        failed_ = trial.failed();
      }
    }
    return std::nullopt;
  }

  /// How the last rollout failed.
  const std::string& failed() const { return failed_; }

 private:
  std::optional<DefaultTask> task_at(std::size_t place, double slowness) const {
    TaskOptions options = options_;
    options.passed_over = place;
    options.slowness *= slowness;
    try {
      return default_task(arm_, options);
    } catch (const InputError&) {
      if (place == 0) throw;
      return std::nullopt;
    }
  }

  std::shared_ptr<const RobotModel> arm_;
  TaskOptions options_;
  int workers_;
  const Progress& progress_;
  std::string failed_;
};

/// What a task may go without, from the one that asks the most of the arm on.
std::vector<TaskOptions> ever_easier(const RobotModel& robot, const TaskOptions& given) {
  std::vector<TaskOptions> all;
  for (const bool without_floor : {false, true}) {
    // A floor that nobody gave is left out before an arm is refused.
    if (without_floor && !assumes_floor(robot, given)) continue;
    for (const bool position_alone : {false, true}) {
      TaskOptions options = given;
      options.without_floor = without_floor;
      options.position_alone = position_alone;
      all.push_back(options);
    }
  }
  return all;
}

/// Throws InputError that says why there is no task.
FirstTask found_for(const std::shared_ptr<const RobotModel>& arm, const TaskOptions& options, int workers,
                    const Progress& progress) {
  std::string last;  // what came closest to a task
  for (const TaskOptions& easier : ever_easier(*arm, options)) {
    Search search(arm, easier, workers, progress);
    try {
      if (auto found = search.find()) return *found;
      last = fmt::format(
          "{}: no gains were found with which {} completes a first task within its limits. With the last of those "
          "tried, {}. Check limits and masses, or write a scenario and gains of its own",
          arm->source, arm->name, search.failed());
    } catch (const InputError& no_place) {
      if (last.empty()) last = no_place.what();
    }
  }
  throw InputError(last);
}

}  // namespace

FirstTask find_first_task(const std::string& robot, const TaskOptions& options, int workers,
                          const Progress& progress) {
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
  FirstTask found = found_for(arm, in_cell, workers, progress);
  found.robot_file = robot_yaml.empty() ? portable_reference(file.path) : "robot.yaml";
  found.robot_yaml = robot_yaml;
  return found;
}

}  // namespace armtune::internal
