#pragma once
// The parts of a run's record (run_record.hpp): the circumstances of every run, and the results of each kind
// of run. Their members are declared once, as in record/declaration.hpp. JSON has finite numbers only. A
// number that can be infinite or NaN is therefore optional, and is missing in that case.

#include <optional>
#include <string>
#include <vector>

#include "sim/plant/engine.hpp"
#include "sim/plant/stepper.hpp"
#include "tuner/record/declaration.hpp"
#include "tuner/run/search_end.hpp"

namespace armtune::internal {

/// A library or program, and its version.
struct ComponentVersion {
  std::string name, version;
  bool operator==(const ComponentVersion&) const = default;

  static void declare(auto& f, auto& one) {
    f.type("ComponentVersion")("name", one.name)("version", one.version);
  }
};

struct MachineFacts {
  std::string processor;
  unsigned hardware_threads = 0;
  bool operator==(const MachineFacts&) const = default;

  static void declare(auto& f, auto& machine) {
    f.type("MachineFacts")("processor", machine.processor)("hardware_threads", machine.hardware_threads);
  }
};

/// The floating-point arithmetic of the process (arithmetic.hpp). Empty in records of older versions.
struct ArithmeticFacts {
  std::string level, fingerprint;
  bool operator==(const ArithmeticFacts&) const = default;

  static void declare(auto& f, auto& arithmetic) {
    using enum record::Presence;
    f.type("ArithmeticFacts")("level", arithmetic.level, "", kIfAny);
    f("fingerprint", arithmetic.fingerprint, "Equal fingerprints mean equal results.", kIfAny);
  }
};

/// An input file of a run.
struct InputFact {
  std::string path;      ///< as the command named it; "bundled DIR/NAME" for armtune's own files
  std::string hash;      ///< hash of the bytes that were read, such as "fnv1a-7ea5f0f7399df7ba"
  std::string copy;      ///< path of its copy below the run folder; empty: there is none
  bool bundled = false;  ///< true: armtune's own file; false also in records of older versions
  bool operator==(const InputFact&) const = default;

  static void declare(auto& f, auto& input) {
    f.type("InputFact")("path", input.path)("hash", input.hash, "Hash of the bytes that were read.");
    f("copy", input.copy, "Path of its copy below the run folder.", record::Presence::kIfAny);
    f("bundled", input.bundled, "True: armtune's own file.", record::Presence::kLater);
  }
};

/// The way in which `simulate` and `compare` computed rollouts.
struct SimulationFacts {
  Stepper stepper = Stepper::kMidpoint;
  Engine engine = Engine::kSimbody;
  std::string gains_hash;  ///< hash of gains.yaml in the folder; empty for `compare`, which has several
  bool operator==(const SimulationFacts&) const = default;

  static void declare(auto& f, auto& simulation) {
    f.type("SimulationFacts")("stepper", simulation.stepper)("engine", simulation.engine);
    f("gains_hash", simulation.gains_hash, "Hash of gains.yaml.", record::Presence::kIfAny);
  }
};

/// The gain sets of `compare`.
struct CompareFacts {
  std::vector<std::string> sets;  ///< names in their order; each has errors_NAME.csv and rollouts_NAME/
  bool operator==(const CompareFacts&) const = default;

  static void declare(auto& f, auto& compare) {
    f.type("CompareFacts")("sets", compare.sets, "Names of the gain sets.");
  }
};

/// The search of `tune` and `pareto`.
struct SearchFacts {
  std::string study;      ///< path of the study file
  std::string start;      ///< name of the start gains
  std::string algorithm;  ///< in words, such as "DIRECT_L, then COBYLA"; empty for a front
  Stepper stepper = Stepper::kMidpoint;
  Engine engine = Engine::kSimbody;  ///< engine of the search; Simbody computes the results in any case
  long evaluations = 0;
  SearchEnd ended = SearchEnd::kConverged;
  std::string reason;  ///< the same in words, for people; empty for a front
  bool operator==(const SearchFacts&) const = default;

  static void declare(auto& f, auto& search) {
    using enum record::Presence;
    f.type("SearchFacts")("study", search.study)("start", search.start);
    f("algorithm", search.algorithm, "", kIfAny)("stepper", search.stepper)("engine", search.engine);
    f("evaluations", search.evaluations)("ended", search.ended);
    f("reason", search.reason, "Why the search ended, in words.", kIfAny);
  }
};

/// The gains that `tune` chose.
struct TunedFacts {
  bool feasible = false;
  std::optional<double> objective;  ///< 1: as good as the start gains; missing if it is not finite
  std::string gains_hash;           ///< hash of gains.yaml as the run wrote it
  bool operator==(const TunedFacts&) const = default;

  static void declare(auto& f, auto& tuned) {
    f.type("TunedFacts")("feasible", tuned.feasible);
    f("objective", tuned.objective, "1: as good as the start gains.", record::Presence::kIfAny);
    f("gains_hash", tuned.gains_hash, "Hash of gains.yaml.");
  }
};

/// The front that `pareto` found.
struct FrontFacts {
  std::vector<std::string> criteria;  ///< columns of pareto.csv; the first was minimised
  long points = 0;
  bool verified = false;  ///< true if every point was simulated again with the same results
  std::optional<double> hypervolume;
  bool operator==(const FrontFacts&) const = default;

  static void declare(auto& f, auto& front) {
    f.type("FrontFacts")("criteria", front.criteria)("points", front.points)("verified", front.verified);
    f("hypervolume", front.hypervolume, "Relative to the start gains.", record::Presence::kIfAny);
  }
};

/// A limit of a metric.
struct LimitFact {
  std::string metric;
  bool upper = true;  ///< true: at most `value`; false: at least `value`
  double value = 0.0;
  bool operator==(const LimitFact&) const = default;

  static void declare(auto& f, auto& limit) {
    f.type("LimitFact")("metric", limit.metric)("relation", limit.upper, {"at_least", "at_most"});
    f("value", limit.value);
  }
};

/// The samples of `robustness`.
struct RobustnessFacts {
  long samples = 0;
  Stepper stepper = Stepper::kMidpoint;
  Engine engine = Engine::kSimbody;  ///< an arm that breaks a limit here is simulated again in Simbody
  std::vector<LimitFact> limits;
  bool operator==(const RobustnessFacts&) const = default;

  static void declare(auto& f, auto& all) {
    f.type("RobustnessFacts")("samples", all.samples)("stepper", all.stepper)("engine", all.engine);
    f("limits", all.limits);
  }
};

/// The stability margins of `margins`.
struct MarginsFacts {
  long margins = 0;  ///< number of margins that were searched
  Stepper stepper = Stepper::kMidpoint;
  bool operator==(const MarginsFacts&) const = default;

  static void declare(auto& f, auto& all) {
    f.type("MarginsFacts")("margins", all.margins)("stepper", all.stepper);
  }
};

/// A part of a planned motion, such as the acquisition of the next target.
struct PhaseFact {
  std::string name;
  double duration = 0.0;  ///< [s]
  bool operator==(const PhaseFact&) const = default;

  static void declare(auto& f, auto& phase) {
    f.type("PhaseFact")("name", phase.name)("duration", phase.duration, "s");
  }
};

/// The largest use, between knots, of limits that a plan enforces at the knots only.
struct BetweenFact {
  std::string kind;             ///< "torque", "tool_path", "gaze" or "distance"
  std::string limit, part;      ///< as in limits.csv
  std::optional<double> share;  ///< share of the limit that is used: 1 at the limit
  double time = 0.0;            ///< [s]
  bool operator==(const BetweenFact&) const = default;

  static void declare(auto& f, auto& worst) {
    f.type("BetweenFact")("kind", worst.kind, {"torque", "tool_path", "gaze", "distance"});
    f("limit", worst.limit)("part", worst.part);
    f("share", worst.share, "1: at the limit.", record::Presence::kIfAny)("time", worst.time, "s");
  }
};

/// The solution of a planning task, and its accuracy.
struct PlanFacts {
  std::string task;       ///< kind of the task, such as "switch"
  std::string scenario;   ///< name
  std::string headline;   ///< the result as a sentence, for people
  double duration = 0.0;  ///< [s]
  std::vector<PhaseFact> phases;
  long knots = 0;
  double violation = 0.0;  ///< largest violation of a constraint, relative to its limit
  double objective = 0.0;
  double objective_weight = 1.0;  ///< factor by which the solver multiplied the objective
  double stationarity = 0.0;      ///< KKT residual
  double complementarity = 0.0;   ///< KKT residual
  long interior_point_steps = 0;  ///< on all grids
  std::vector<BetweenFact> between_knots;
  bool operator==(const PlanFacts&) const = default;

  static void declare(auto& f, auto& plan) {
    f.type("PlanFacts")("task", plan.task)("scenario", plan.scenario)("headline", plan.headline);
    f("duration", plan.duration, "s")("phases", plan.phases)("knots", plan.knots);
    f("violation", plan.violation, "Relative to the limit.")("objective", plan.objective);
    f("objective_weight", plan.objective_weight)("kkt_stationarity", plan.stationarity);
    f("kkt_complementarity", plan.complementarity)("interior_point_steps", plan.interior_point_steps);
    f("between_knots", plan.between_knots, "", record::Presence::kIfAny);
  }
};

/// The torque of a joint in the logs of `identify`, and the RMS errors of models that predict it [N m, N]. A
/// value is missing if it was not computed.
struct JointTorqueFact {
  std::string joint;
  std::optional<double> rms;         ///< of the logged torque
  std::optional<double> fitted;      ///< error of theta, on the data of the fit
  std::optional<double> held_out;    ///< error of theta, on data that the fit did not use
  std::optional<double> robot_file;  ///< error of the robot file's parameters, on the data of the fit
  bool operator==(const JointTorqueFact&) const = default;

  static void declare(auto& f, auto& torque) {
    using enum record::Presence;
    f.type("JointTorqueFact")("joint", torque.joint)("rms", torque.rms, "", kIfAny);
    f("not_explained_fitted", torque.fitted, "", kIfAny);
    f("not_explained_held_out", torque.held_out, "", kIfAny);
    f("not_explained_robot_file", torque.robot_file, "", kIfAny);
  }
};

/// The result of `identify`.
struct IdentificationFacts {
  long samples = 0;
  long base_parameters = 0;
  std::optional<double> condition_number;
  bool made_physical = false;  ///< true if the fit had to be changed to be physically possible
  std::vector<JointTorqueFact> torque;
  std::vector<std::string> accepted_although;  ///< doubts that the user accepted, one sentence each
  bool operator==(const IdentificationFacts&) const = default;

  static void declare(auto& f, auto& found) {
    using enum record::Presence;
    f.type("IdentificationFacts")("samples", found.samples)("base_parameters", found.base_parameters);
    f("condition_number", found.condition_number, "", kIfAny)("made_physical", found.made_physical);
    f("torque", found.torque)("accepted_although", found.accepted_although, "", kIfAny);
  }
};

/// The quality with which a robot file predicts one joint of a log. A value is missing if it was not
/// compared.
struct JointMatchFact {
  std::string joint;
  bool matches = false;                ///< true if the prediction matches in everything that was compared
  std::optional<double> explained;     ///< share of the torque's variance that the model explains
  std::optional<double> residual_rms;  ///< of measured minus predicted torque [N m, N]
  std::optional<double> torque_rms;    ///< of the measured torque [N m, N]
  std::optional<double> motion;        ///< position error divided by its threshold, where it is judged
  bool operator==(const JointMatchFact&) const = default;

  static void declare(auto& f, auto& one) {
    using enum record::Presence;
    f.type("JointMatchFact")("joint", one.joint)("matches", one.matches);
    f("explained", one.explained, "", kIfAny)("residual_rms", one.residual_rms, "", kIfAny);
    f("torque_rms", one.torque_rms, "", kIfAny);
    f("motion", one.motion, "Position error over the largest that matches.", kIfAny);
  }
};

/// A threshold of `validate`. validation_thresholds.hpp has its unit and meaning.
struct ThresholdFact {
  std::string name;
  double value = 0.0;
  bool operator==(const ThresholdFact&) const = default;

  static void declare(auto& f, auto& one) { f.type("ThresholdFact")("name", one.name)("value", one.value); }
};

/// What `validate` found wrong with the log itself.
struct LogFindingFact {
  std::string kind;             ///< such as "torque_offset"; docs/validation.md lists them
  std::string joint;            ///< empty: the whole log
  std::string other;            ///< the second joint, of those that are exchanged
  std::optional<double> value;  ///< size of the mistake, in the unit of its kind
  std::optional<double> time;   ///< when it begins [s], in the time of the log
  std::string text;             ///< the same as a sentence, for people
  bool operator==(const LogFindingFact&) const = default;

  static void declare(auto& f, auto& one) {
    using enum record::Presence;
    f.type("LogFindingFact")("kind", one.kind)("joint", one.joint, "", kIfAny)("other", one.other, "",
                                                                               kIfAny);
    f("value", one.value, "", kIfAny)("time", one.time, "s", kIfAny)("text", one.text);
  }
};

/// A likely cause of the difference between measured and predicted torques.
struct MisfitCauseFact {
  std::string kind;    ///< such as "coulomb_friction"
  std::string joint;   ///< empty: the whole arm
  double value = 0.0;  ///< what the model lacks, in the unit of the kind
  double share = 0.0;  ///< largest share of a joint's mean square residual that it explains alone
  bool operator==(const MisfitCauseFact&) const = default;

  static void declare(auto& f, auto& one) {
    f.type("MisfitCauseFact")("kind", one.kind)("joint", one.joint, "", record::Presence::kIfAny);
    f("value", one.value)("share", one.share);
  }
};

/// The result of `validate`.
struct ValidationFacts {
  bool matches = false;  ///< true if the robot file predicts the log
  std::string headline;  ///< the verdict as a sentence, for people
  std::string robot;     ///< name
  long samples = 0;
  double duration = 0.0;  ///< [s]
  std::string commands;   ///< kind of the commands that the motion was simulated with; empty: none
  std::vector<JointMatchFact> joints;
  std::vector<std::string> causes;       ///< sentences on the joints, each with its likely causes
  std::vector<MisfitCauseFact> misfit;   ///< the causes of the torques' misfit, the most important ones first
  std::vector<LogFindingFact> findings;  ///< what is wrong with the log itself
  std::vector<std::string> not_compared;  ///< what could not be compared, and why
  std::vector<std::string> notes;         ///< how the log was read
  std::vector<ThresholdFact> thresholds;
  bool operator==(const ValidationFacts&) const = default;

  static void declare(auto& f, auto& found) {
    using enum record::Presence;
    f.type("ValidationFacts")("matches", found.matches)("headline", found.headline)("robot", found.robot);
    f("samples", found.samples)("duration", found.duration, "s");
    f("commands", found.commands, "Kind of the commands that the motion was simulated with.", kIfAny);
    f("joints", found.joints)("causes", found.causes, "", kIfAny)("misfit", found.misfit, "", kIfAny);
    f("findings", found.findings, "", kIfAny);
    f("not_compared", found.not_compared, "", kIfAny)("notes", found.notes, "", kIfAny);
    f("thresholds", found.thresholds);
  }
};

/// The motion of `excite`.
struct ExcitationFacts {
  bool designed = false;                   ///< true: designed by the run; false: read from a file
  std::optional<double> condition_number;  ///< of the base regressor with columns of unit length
  bool operator==(const ExcitationFacts&) const = default;

  static void declare(auto& f, auto& motion) {
    f.type("ExcitationFacts")("designed", motion.designed);
    f("condition_number", motion.condition_number, "", record::Presence::kIfAny);
  }
};

/// The comparison of `yardstick`.
struct YardstickFacts {
  long events = 0;
  double velocity = 1.0;  ///< share of the velocity limits that the best motions may use
  double effort = 1.0;    ///< share of the torque limits
  long knots = 0;
  bool operator==(const YardstickFacts&) const = default;

  static void declare(auto& f, auto& all) {
    f.type("YardstickFacts")("events", all.events)("velocity", all.velocity)("effort", all.effort);
    f("knots", all.knots);
  }
};

}  // namespace armtune::internal
