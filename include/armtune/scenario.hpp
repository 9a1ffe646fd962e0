#pragma once
// A scenario: a task for an arm (the tool's path, gaze targets, obstacles), and how the real arm differs from
// the controller's model of it.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "armtune/robot.hpp"

namespace armtune {

namespace internal {
struct Scenario;
}

/// The files that were read: the path of each, and the hash of its content.
using InputFiles = std::vector<std::pair<std::string, std::string>>;

/// A scenario. It is a value: a setter changes this object only.
class Scenario {
 public:
  /// Reads a bundled scenario by name, or a scenario file by path. Throws InputError.
  static Scenario load(const std::string& name_or_path);

  const std::string& name() const;
  Robot robot() const;
  double duration() const;        ///< simulated time [s]
  double control_period() const;  ///< [s]

  /// Sets the name of the scenario and of its results. A name consists of letters, digits, '_', '-' and '.',
  /// and does not begin with '.' or '-'.
  /// Scenarios that are simulated together need different names. Throws InputError.
  void set_name(const std::string& name);
  /// Sets the simulated time [s], at least one control period. Throws InputError.
  void set_duration(double seconds);
  /// True if the scenario was read from files and no setter was called since. Functions that write a run
  /// folder accept only such scenarios, because the folder gets copies of the files.
  bool as_in_file() const { return files_ != nullptr; }

  /// For armtune's own code. files: null if no file matches the scenario.
  Scenario(internal::Scenario inside, std::shared_ptr<const InputFiles> files);
  const internal::Scenario& inside() const { return *inside_; }
  const std::shared_ptr<const InputFiles>& files() const { return files_; }

 private:
  std::shared_ptr<const internal::Scenario> inside_;
  std::shared_ptr<const InputFiles> files_;
};

}  // namespace armtune
