#include "tuner/first_task/first_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/holding_torques.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/first_task/estimated_robot.hpp"
#include "tuner/first_task/first_trial.hpp"

namespace armtune::internal {
namespace {

/// Share of an effort limit. If gravity alone takes this share, little torque is left for motion.
constexpr double kHeavy = 0.6;

/// A factor on the task's duration, and the number of places at which tasks with this factor are tried. Slow
/// tasks take longer to try, so there are fewer places.
struct Pace {
  double slowness;
  std::size_t places;
};
constexpr std::array kPaces = {Pace{1.0, 6}, Pace{2.0, 2}};

using TellProgress = std::function<void(const std::string&)>;

/// Tries tasks of an arm at several paces. At each pace, it begins with the places where the arm moves well.
class TaskSearch {
 public:
  /// progress: must outlive the search.
  TaskSearch(std::shared_ptr<const RobotModel> arm, TaskOptions options, int workers,
             const TellProgress& progress)
      : arm_(std::move(arm)), options_(std::move(options)), workers_(workers), progress_(progress) {}

  std::optional<FirstTask> find() {
    for (const Pace& pace : kPaces) {
      std::vector<DefaultTask> tasks = tasks_at(pace);
      if (tasks.empty()) break;  // then a slower task has no place either
      has_place_ = true;
      for (std::size_t place = 0; place < tasks.size(); ++place) {
        if (progress_) {
          progress_(fmt::format(
              "looking for a first task{}{}{}: place {} of {}{}",
              options_.mask == TaskMask::kPosition ? ", tool position only" : "",
              options_.without_floor ? ", without a floor" : "",
              options_.thorough ? ", among ten times as many places" : "", place + 1, tasks.size(),
              pace.slowness == 1.0 ? std::string()
                                   : fmt::format(", {} times the usual duration", pace.slowness)));
        }
        if (tasks[place].load < lightest_) {
          lightest_ = tasks[place].load;
          loaded_ = tasks[place].loaded;
        }
        FirstTrial trial(tasks[place], workers_);
        if (auto found = trial.find())
          return FirstTask{std::move(tasks[place]), std::move(found->gains), found->metrics, "", ""};
        failed_ = trial.failed();
      }
    }
    return std::nullopt;
  }

  /// Returns true if there is any place for a task, even if no gains were found for it.
  bool has_place() const { return has_place_; }

  /// Returns how the last rollout failed. For a heavy arm, it adds the torque that holds the arm.
  std::string failed() const {
    if (lightest_ < kHeavy) return failed_;
    const double effort = arm_->joints[static_cast<std::size_t>(loaded_)].limits.effort;
    const char* unit = effort_unit(*arm_, loaded_);
    return fmt::format(
        "{}; even in the tried task with the least load, joint '{}' needs {:.3g} {} only to hold the arm "
        "still, and its effort limit is {:.3g} {}",
        failed_, arm_->joints[static_cast<std::size_t>(loaded_)].name, lightest_ * effort, unit, effort,
        unit);
  }

 private:
  std::vector<DefaultTask> tasks_at(const Pace& pace) const {
    TaskOptions options = options_;
    options.slowness *= pace.slowness;
    try {
      return default_tasks(arm_, options, pace.places);
    } catch (const InputError&) {
      return {};  // a task that lasts longer may drift to where the arm cannot go
    }
  }

  std::shared_ptr<const RobotModel> arm_;
  TaskOptions options_;
  int workers_;
  const TellProgress& progress_;
  bool has_place_ = false;
  std::string failed_;
  double lightest_ = std::numeric_limits<double>::infinity();  ///< least load of a task
  int loaded_ = 0;                                             ///< the joint with this load
};

/// Returns the options to try, from the most demanding task to the easiest. The task first has the usual
/// floor, and then none if that floor was only assumed. In both cases it first includes the gaze, and then
/// only the position. Each of these tasks is tried with a quick search for places, and then with a thorough
/// one.
std::vector<TaskOptions> ever_easier(const RobotModel& robot, const TaskOptions& given) {
  std::vector<TaskOptions> all;
  for (const bool without_floor : {false, true}) {
    if (without_floor && !assumes_floor(robot, given)) continue;
    for (const TaskMask mask : {TaskMask::kPositionAndAxis, TaskMask::kPosition}) {
      if (components(mask) > robot.n() || (given.mask && mask != *given.mask)) continue;
      for (const bool thorough : {false, true}) {
        TaskOptions options = given;
        options.without_floor = given.without_floor || without_floor;
        options.mask = mask;
        options.thorough = thorough;
        all.push_back(options);
      }
    }
  }
  return all;
}

/// Returns the first task that was found. Throws InputError with the reason if there is none.
FirstTask found_for(const std::shared_ptr<const RobotModel>& arm, const TaskOptions& options, int workers,
                    const TellProgress& progress) {
  std::string last;  // the reason of the last failure
  for (const TaskOptions& easier : ever_easier(*arm, options)) {
    TaskSearch search(arm, easier, workers, progress);
    if (auto found = search.find()) return *found;
    if (!search.has_place()) continue;
    last = fmt::format(
        "no start gains were found with which {} completes an easy motion within its limits. The last "
        "attempt failed: {}. Check limits and masses, or write a scenario and start gains yourself",
        arm->name, search.failed());
  }
  if (last.empty()) default_task(arm, options);  // throws an error that says why there is no place
  throw InputError(InputPlace{arm->source}, last);
}

}  // namespace

FirstTask find_first_task(const std::string& robot, const TaskOptions& options, int workers,
                          const TellProgress& progress) {
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
      throw InputError(
          InputPlace{file.path, 0, "cell"},
          "the key 'cell' describes the surroundings; leave --floor out, and give 'floor' under 'cell'")
          .with_value(fmt::to_string(*options.floor), "no --floor");
    }
    in_cell.cell = *cell;
  }
  FirstTask found = found_for(arm, in_cell, workers, progress);
  found.robot_file = robot_yaml.empty() ? portable_reference(file.path) : "robot.yaml";
  found.robot_yaml = robot_yaml;
  return found;
}

}  // namespace armtune::internal
