#pragma once
// A study is the complete definition of one tuning task: which gains are tuned, in which scenarios, for which
// metrics, under which constraints, and by which search. It is usually read from a YAML file.

#include <optional>
#include <string>
#include <vector>

#include "tuner/samples/sample_set.hpp"
#include "tuner/solver/solver.hpp"
#include "tuner/study/objective.hpp"
#include "tuner/study/parameter.hpp"
#include "tuner/study/thresholds.hpp"
#include "tuner/study/warm_start.hpp"

namespace armtune::internal {

/// One direction of the coarse sweep that the search is compared with. Its parameters are all multiplied by
/// the same factor.
struct SweepAxis {
  std::vector<std::size_t> parameters;  ///< indices into ParameterSpace::free
  std::vector<double> factors;          ///< on the start's value; the result is clamped to the bounds
};

struct Study {
  std::string name;
  std::string source;  ///< file; empty: a text
  std::string description;
  std::string gains;  ///< file of the start gains; empty: none
  std::string node;   ///< the controller in that file, if it is a ROS parameter file with several; else empty
  std::vector<Scenario> scenarios;
  ParameterSpace space;
  std::optional<Gains> given;  ///< the file's start gains, if others replaced them
  std::string given_failure;   ///< the scenario that is not completed with them, and how it ends
  std::vector<ObjectiveTerm> terms;
  OwnObjective own_objective;           ///< in place of terms, of a study that was not read from a file
  std::vector<Constraint> constraints;  ///< those of `margins` come after the others
  std::vector<MarginDemand> margins;    ///< demanded in every scenario, one corner rollout each
  std::vector<SweepAxis> sweep;         ///< may be empty
  std::optional<SampleSet> robust;      ///< none: the scenarios' own arms
  std::optional<WarmStart> warm;        ///< none: the search begins at the start gains
  VerdictThresholds thresholds;         ///< those of the simulation checks after the search
  SolverOptions solver;
  std::size_t starts = 1;          ///< local searches at once; the first begins where a single one would
  std::string global_algorithm;    ///< searches before the local one does; empty: none
  bool global_by_default = false;  ///< true if the study's file named neither the global nor the local one
  double global_share = 0.5;       ///< its part of the evaluations that start and sweep leave
  long max_evaluations = 300;      ///< start and sweep included
  double max_minutes = 0.0;        ///< wall time from the start to the last evaluation; 0: no limit
  Stepper stepper = Stepper::kMidpoint;
  Engine engine = Engine::kSimbody;  ///< engine of sweep and search; Simbody simulates start and result too
  double verify_share = 0.03;        ///< with another engine: part of evaluations and minutes left to Simbody
};

/// Returns the text with which messages about the study begin: its file, or its name.
inline const std::string& where(const Study& study) {
  return study.source.empty() ? study.name : study.source;
}

/// Returns all scenarios that are simulated for an evaluation: the study's scenarios, then the corners of its
/// margins, margin by margin.
std::vector<Scenario> simulated_scenarios(const Study& study);
/// Returns the number of results of an evaluation: one for each of these scenarios, combined over the arms of
/// `robust`.
std::size_t results_per_evaluation(const Study& study);
/// Returns the number of rollouts of an evaluation, with all arms of `robust`.
std::size_t rollouts_per_evaluation(const Study& study);

/// Returns the study's solver, with the initial step of its warm start if there is one.
inline SolverOptions solver_of(const Study& study) {
  SolverOptions solver = study.solver;
  if (study.warm) solver.initial_step = study.warm->step.value_or(solver.initial_step * study.warm->box);
  return solver;
}

/// Returns the algorithm of the global search, or an empty text if there is none. A default global search is
/// left out after a warm start, which gives what it would look for.
inline std::string global_of(const Study& study) {
  return study.warm && study.global_by_default ? std::string() : study.global_algorithm;
}

/// Parts that replace those of a study's text under `scenarios`, `gains` and `objective`, if they are given.
struct StudyParts {
  std::vector<Scenario> scenarios = {};
  std::optional<Gains> start = {};       ///< valid gains
  std::vector<std::string> joints = {};  ///< names of the joints that `start` is for
  OwnObjective objective = {};           ///< in place of `objective`
};

/// Reads a bundled study by name, or a file by path. controller: the kind of controller to tune (empty: that
/// of the study). If it is not the kind of the start gains, these are converted (convert_gains), and all
/// gains that are tuned by default are tuned. Throws InputError.
Study load_study(const std::string& name_or_path, const std::string& controller = {},
                 const StudyParts& parts = {});

/// Reads a study from a text. It has no source, so that it can leave no run folder. Throws InputError.
Study parse_study(const std::string& yaml, const StudyParts& parts);

/// Returns the study with every default written out, as YAML that load_study reads. `gains_file`,
/// `warm_file`: where the gains of start and warm start are kept beside it; an empty `warm_file` leaves the
/// warm start out.
std::string study_yaml(const Study& study, const std::string& gains_file, const std::string& warm_file = {});

}  // namespace armtune::internal
