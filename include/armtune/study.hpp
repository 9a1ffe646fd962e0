#pragma once
// A study. It defines which gains are tuned, over which scenarios, for which objective, and under which
// constraints.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "armtune/gains.hpp"
#include "armtune/rollout.hpp"
#include "armtune/scenario.hpp"

namespace armtune {

namespace internal {
struct MotionPlanner;
struct Study;
}  // namespace internal

/// Parts of a study that are passed as objects. They replace the keys `scenarios`, `gains` and `objective` of
/// the study's text, which may then be missing.
struct StudyInputs {
  std::vector<Scenario> scenarios = {};
  std::optional<Gains> start = std::nullopt;
  /// Computes the objective from one rollout for each scenario, all completed and without recordings. The
  /// value must be above zero, and a lower value is better. The same rollouts must give the same value. The
  /// search divides the value by that of the start gains, and limits the ratio to ten. The function is called
  /// from any thread, one call at a time. An exception from it ends the search. A `robust` study simulates
  /// several arms; each metric is then combined over the arms by the study's measure, such as the worst case.
  std::function<double(const std::vector<Rollout>&)> objective = {};
};

/// The options of Study::from_controllers, as those of the command `armtune init`.
struct ControllerStudyOptions {
  /// Folder for the files of the study; required. It must be new, or contain exactly these files already.
  std::string folder = {};
  /// Without a parameter file: kind of controller, such as "position_streaming". Its start gains are computed
  /// from the arm, and `rate` must be given.
  std::string controller = {};
  std::string node = {};    ///< name of the controller in a file with several
  std::string distro = {};  ///< distribution of ROS: jazzy, humble or noetic; empty: depends on the file
  double rate = 0.0;        ///< control rate [Hz]; 0: that of the file
  double speed = 1.0;       ///< factor on the speed of the motions
  bool degrees = false;     ///< true: angles in CSV files are in degrees, not in radians
  /// Largest stiffness of an impedance controller [N m/rad, N/m]: one number, or one for each joint. For a
  /// task of the tool: two numbers, for translations and rotations, or six. Empty: the stiffness is not
  /// tuned.
  std::vector<double> max_stiffness = {};
  int workers = 1;  ///< threads that simulate the start gains
  /// Result of motion_planner() in plan.hpp. Null: files of joint positions without times are refused. So are
  /// files of waypoints of the tool if the controller follows joint motions.
  std::shared_ptr<const internal::MotionPlanner> planner = {};
  Watch watch = {};  ///< warnings: the assumptions that were made
};

/// A tuning study. It is a value: a setter changes this object only.
class Study {
 public:
  /// Reads a bundled study by name, or a study file by path. controller: kind of controller to tune instead
  /// of the one that the start gains belong to; empty: as the study specifies. Throws InputError.
  static Study load(const std::string& name_or_path, const std::string& controller = {});
  /// Parses the text of a study file (docs/file_formats.md). Paths are relative to the current folder.
  /// Functions that write a run folder do not accept such a study, because there is no file that they could
  /// copy into the folder. Throws InputError.
  static Study parse(const std::string& yaml, const StudyInputs& inputs = {});
  /// Makes a study from the files of a robot, writes it into options.folder, and loads it. robot: bundled
  /// name, robot file or URDF. controllers: ROS parameter file of the controller, or a map of its gains;
  /// empty: see options.controller. trajectories: files of the motions for which the gains are tuned. If the
  /// arm does not complete a motion with the start gains, or oscillates, and armtune finds better ones, these
  /// are the start gains. If every check passes, `tune` also writes the parameter file with the tuned gains
  /// into its run folder. Throws InputError if the study cannot be made; FailedError if Watch::stop ended it.
  static Study from_controllers(const std::string& robot, const std::string& controllers,
                                const std::vector<std::string>& trajectories,
                                const ControllerStudyOptions& options);

  const std::string& name() const;
  const std::vector<Scenario>& scenarios() const { return scenarios_; }
  Gains start() const;  ///< a copy
  /// Returns the names of the tuned numbers, such as "task_space_gains_p/x". The coordinates of a point have
  /// this order.
  std::vector<std::string> parameters() const;
  long max_evaluations() const;  ///< includes the start gains and the sweep, a coarse grid around them
  std::uint64_t seed() const;    ///< seed of algorithms that draw random numbers
  /// Sets the largest number of evaluations. Throws InputError if it is not positive.
  void set_max_evaluations(long most);
  void set_seed(std::uint64_t seed);

  /// For armtune's own code. files: null if no file matches the study.
  Study(internal::Study inside, std::vector<Scenario> scenarios, std::shared_ptr<const InputFiles> files);
  const internal::Study& inside() const { return *inside_; }
  const std::shared_ptr<const InputFiles>& files() const { return files_; }

 private:
  std::shared_ptr<const internal::Study> inside_;
  std::vector<Scenario> scenarios_;
  std::shared_ptr<const InputFiles> files_;
};

}  // namespace armtune
