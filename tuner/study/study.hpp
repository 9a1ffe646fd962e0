#pragma once
// A study is the complete definition of one tuning task: which gains are tuned, in which scenarios, for which
// metrics, under which constraints, and by which search. It is usually read from a YAML file.

#include <optional>
#include <string>
#include <vector>

#include "core/control/laws/ros_distro.hpp"
#include "tuner/samples/sample_set.hpp"
#include "tuner/solver/solver.hpp"
#include "tuner/study/objective.hpp"
#include "tuner/study/parameter.hpp"
#include "tuner/study/thresholds.hpp"
#include "tuner/study/warm_start.hpp"

namespace armtune::internal {

/// One axis of the sweep. The sweep is a coarse grid of gains, whose best point is compared with the result
/// of the search. Along an axis, several parameters are multiplied by the same factor.
struct SweepAxis {
  std::vector<std::size_t> parameters;  ///< indices into ParameterSpace::free
  std::vector<double> factors;          ///< factors on the start values; results are clamped to the bounds
};

struct Study {
  std::string name;
  std::string source;  ///< path of the study's file; empty: the study was read from a text
  std::string description;
  std::string gains;  ///< path of the file with the start gains; empty: none
  std::string node;   ///< name of the controller in that file, if it contains several; otherwise empty
  std::optional<RosDistro> distro;  ///< distribution of ROS whose rules that controller follows, if given
  std::vector<Scenario> scenarios;
  ParameterSpace space;
  std::optional<Gains> given;  ///< the study's own start gains, if armtune replaced them
  std::string given_failure;   ///< why the gains `given` cannot be used: the failing scenario and its end
  std::vector<ObjectiveTerm> terms;
  OwnObjective own_objective;           ///< replaces the terms, for a study with a user's own objective
  std::vector<Constraint> constraints;  ///< the constraints that come from `margins` are the last
  std::vector<MarginDemand> margins;    ///< demanded in every scenario; one corner rollout per scenario
  std::vector<SweepAxis> sweep;         ///< may be empty
  std::optional<SampleSet> robust;      ///< random arms to tune on; none: only the scenarios' own arms
  std::optional<WarmStart> warm;        ///< none: the search starts at the start gains
  VerdictThresholds thresholds;         ///< thresholds of the checks after the search
  SolverOptions solver;                 ///< options of the local search
  std::size_t starts = 1;               ///< local searches at once; the first starts where a single one would
  std::string global_algorithm;         ///< global search before the local one; empty: no global search
  bool global_by_default = false;       ///< true if the study's file named no algorithm at all
  double global_share = 0.5;   ///< global search's share of the evaluations that start gains and sweep leave
  bool final_phase = false;    ///< true: a last phase models every metric separately (final_phase.hpp)
  double final_share = 0.5;    ///< its share of the evaluations that are left to it and the local searches
  long max_evaluations = 300;  ///< those of the start gains and the sweep included
  double max_minutes = 0.0;    ///< wall time from the start to the last evaluation [min]; 0: no limit
  Stepper stepper = Stepper::kMidpoint;
  Engine engine = Engine::kSimbody;  ///< of sweep and search; Simbody always simulates start gains and result
  double verify_share = 0.03;        ///< share of evaluations and minutes reserved for Simbody, if it is not
                                     ///< the engine of the search
};

/// Returns the name with which messages about the study begin: the path of its file, or its name.
inline const std::string& where(const Study& study) {
  return study.source.empty() ? study.name : study.source;
}

/// Returns all scenarios that are simulated for an evaluation: the study's scenarios, then the corners of its
/// margins, margin by margin.
std::vector<Scenario> simulated_scenarios(const Study& study);
/// Returns the number of results of an evaluation: one for each of these scenarios. With `robust`, a result
/// is combined over the arms.
std::size_t results_per_evaluation(const Study& study);
/// Returns the number of rollouts of an evaluation. With `robust`, there is one for each arm and scenario,
/// and one for each corner.
std::size_t rollouts_per_evaluation(const Study& study);

/// Returns the study's solver, with the initial step of its warm start if there is one.
inline SolverOptions solver_of(const Study& study) {
  SolverOptions solver = study.solver;
  if (study.warm) solver.initial_step = study.warm->step.value_or(solver.initial_step * study.warm->box);
  return solver;
}

/// Returns the algorithm of the global search, or an empty text if there is none. The default global search
/// is left out if the study has a warm start, because a warm start already gives a good point.
inline std::string global_of(const Study& study) {
  return study.warm && study.global_by_default ? std::string() : study.global_algorithm;
}

/// Parts of a study that a program passes. Each part that is not empty replaces a key of the study's YAML.
struct StudyParts {
  std::vector<Scenario> scenarios = {};  ///< replaces `scenarios`
  std::optional<Gains> start = {};       ///< valid gains; replaces `gains`
  std::vector<std::string> joints = {};  ///< names of the joints of the arm to which `start` belongs
  OwnObjective objective = {};           ///< replaces `objective`
};

/// Reads a bundled study by name, or a study file by path. controller: the kind of controller to tune; empty:
/// the kind that the study gives. If the start gains are of another kind, they are converted (convert_gains).
/// If `controller` is not the kind that the study gives, the study's `parameters` are ignored, and all gains
/// that are tuned by default are tuned. Throws InputError.
Study load_study(const std::string& name_or_path, const std::string& controller = {},
                 const StudyParts& parts = {});

/// Reads a study from a text. The study has no source file, so it cannot have a run folder. Throws
/// InputError.
Study parse_study(const std::string& yaml, const StudyParts& parts);

/// Returns the study as YAML that load_study can read, with every default written out. gains_file, warm_file:
/// paths, relative to the study's file, of the start gains and of the warm start's gains. If warm_file is
/// empty, the warm start is left out.
std::string study_yaml(const Study& study, const std::string& gains_file, const std::string& warm_file = {});

}  // namespace armtune::internal
