#pragma once
// What is tuned, over which scenarios, for what, and inside which limits.

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
struct Study;
}

/// Parts of a study in place of what its text says under `scenarios`, `gains` and `objective`, or of keys
/// that it lacks.
struct StudyInputs {
  std::vector<Scenario> scenarios = {};
  std::optional<Gains> start = std::nullopt;
  /// From one rollout for each scenario, all of them completed and without recordings: a number above zero,
  /// less is better, and the same for the same rollouts. The search sees it relative to that of the start,
  /// and up to ten times that. It is called from any thread, one call at a time; what it throws ends the
  /// search. Where the study is `robust`, each rollout has the measure over the arms for its metrics.
  std::function<double(const std::vector<Rollout>&)> objective = {};
};

/// A value: a setter changes this object alone.
class Study {
 public:
  /// Reads a bundled study by name, or a study file by path. controller: of another kind than the gains are
  /// for; empty: as the study says. Throws InputError.
  static Study load(const std::string& name_or_path, const std::string& controller = {});
  /// Makes one of the text of a study file (docs/file_formats.md). Paths are relative to the current folder.
  /// It leaves no run folder, since no file says what it is. Throws InputError.
  static Study parse(const std::string& yaml, const StudyInputs& inputs = {});

  const std::string& name() const;
  const std::vector<Scenario>& scenarios() const { return scenarios_; }
  Gains start() const;  ///< a copy
  /// Names of the numbers that are tuned, such as "task_space_gains_p/x": the order of a point's coordinates.
  std::vector<std::string> parameters() const;
  long max_evaluations() const;  ///< start and sweep included
  std::uint64_t seed() const;    ///< of algorithms that draw random numbers
  /// Throws InputError where a value is not positive.
  void set_max_evaluations(long most);
  void set_seed(std::uint64_t seed);

  /// For armtune itself. files: null where no file says what it is.
  Study(internal::Study inside, std::vector<Scenario> scenarios, std::shared_ptr<const InputFiles> files);
  const internal::Study& inside() const { return *inside_; }
  const std::shared_ptr<const InputFiles>& files() const { return files_; }

 private:
  std::shared_ptr<const internal::Study> inside_;
  std::vector<Scenario> scenarios_;
  std::shared_ptr<const InputFiles> files_;
};

}  // namespace armtune
