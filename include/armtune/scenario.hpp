#pragma once
// A task for an arm: the tool's path, gaze targets, obstacles, and how the real arm differs from the
// controller's model.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "armtune/robot.hpp"

namespace armtune {

namespace internal {
struct Scenario;
}

/// Files that were read: path, and the hash of what was in it.
using InputFiles = std::vector<std::pair<std::string, std::string>>;

/// A value: a setter changes this object alone.
class Scenario {
 public:
  /// Reads a bundled scenario by name, or a scenario file by path. Throws InputError.
  static Scenario load(const std::string& name_or_path);

  const std::string& name() const;
  Robot robot() const;
  double duration() const;        ///< simulated time [s]
  double control_period() const;  ///< [s]

  /// What its results are called by: letters, digits, '_', '-' and '.'. Two scenarios that are simulated
  /// together need different names. Throws InputError.
  void set_name(const std::string& name);
  /// [s]; one control period at least. Throws InputError.
  void set_duration(double seconds);
  /// False once a setter was called: no file says what it is now, and it cannot be simulated into a run
  /// folder.
  bool as_in_file() const { return files_ != nullptr; }

  /// For armtune itself. files: null where no file says what it is.
  Scenario(internal::Scenario inside, std::shared_ptr<const InputFiles> files);
  const internal::Scenario& inside() const { return *inside_; }
  const std::shared_ptr<const InputFiles>& files() const { return files_; }

 private:
  std::shared_ptr<const internal::Scenario> inside_;
  std::shared_ptr<const InputFiles> files_;
};

}  // namespace armtune
