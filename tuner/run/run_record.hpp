#pragma once
// The record of a run, run.json: how the results of a run folder were made, and what the run found. It is
// declared once, here and in the files *_facts.hpp beside this one. Commands fill it in, and the report, the
// verdict and `export` read it.
//
//   if (const auto record = find_run_record("runs/first"); record && record->search)
//     fmt::print("{} evaluations\n", record->search->evaluations);

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tuner/run/calibration_facts.hpp"
#include "tuner/run/distribution_facts.hpp"
#include "tuner/run/run_facts.hpp"
#include "tuner/run/run_kind.hpp"

namespace armtune::internal {

/// Name of the file in a run folder.
constexpr const char* kRunRecord = "run.json";
/// Name of the file with which older versions of armtune recorded a run. It is not read.
constexpr const char* kOldRunRecord = "run.yaml";

struct RunRecord {
  static constexpr long kFormat = 1;  ///< format that this version reads and writes

  long format = kFormat;
  RunKind kind = RunKind::kSimulate;
  std::string command;        ///< command that repeats the run, quoted for a shell
  std::string date;           ///< time at which the record was written, UTC, such as 2026-11-26T05:27:03Z
  double wall_seconds = 0.0;  ///< wall time of the run, including earlier parts [s]
  std::uint64_t seed = 0;
  int workers = 1;
  std::optional<SimulationFacts> simulation;  ///< of `simulate` and `compare`
  std::optional<CompareFacts> compare;        ///< missing in records of older versions
  std::optional<SearchFacts> search;          ///< of `tune` and `pareto`
  std::optional<TunedFacts> tuned;            ///< of `tune`
  std::optional<FrontFacts> front;            ///< of `pareto`
  std::optional<RobustnessFacts> robustness;
  std::optional<DistributionFacts> distribution;  ///< of random arms, also those of a search
  std::optional<MarginsFacts> margins;
  std::optional<PlanFacts> plan;
  std::optional<IdentificationFacts> identification;
  std::optional<ValidationFacts> validation;
  std::optional<CalibrationFacts> calibration;
  std::optional<ExcitationFacts> excitation;
  std::optional<YardstickFacts> yardstick;
  std::vector<ComponentVersion> versions;
  MachineFacts machine;
  ArithmeticFacts arithmetic;
  std::vector<InputFact> inputs;
  bool operator==(const RunRecord&) const = default;

  static void declare(auto& f, auto& run) {
    using enum record::Presence;
    f.type("RunRecord", "How a run was made, and what it found.")("format", run.format)("kind", run.kind);
    f("command", run.command, "Repeats the run in a shell.")("date", run.date, "UTC.");
    f("wall_seconds", run.wall_seconds)("seed", run.seed)("workers", run.workers);
    f("simulation", run.simulation, "", kIfAny)("compare", run.compare, "", kIfAny);
    f("search", run.search, "", kIfAny);
    f("tuned", run.tuned, "", kIfAny)("front", run.front, "", kIfAny);
    f("robustness", run.robustness, "", kIfAny)("distribution", run.distribution, "", kIfAny);
    f("margins", run.margins, "", kIfAny);
    f("plan", run.plan, "", kIfAny)("identification", run.identification, "", kIfAny);
    f("validation", run.validation, "", kIfAny)("calibration", run.calibration, "", kIfAny);
    f("excitation", run.excitation, "", kIfAny)("yardstick", run.yardstick, "", kIfAny);
    f("versions", run.versions)("machine", run.machine)("arithmetic", run.arithmetic);
    f("inputs", run.inputs);
  }
};

/// Returns the text of run.json.
std::string run_record_json(const RunRecord& record);

/// Reads a text that run_record_json() wrote. file: name for messages. Throws InputError with file, line, key
/// and value if the text is not such a record, if it exceeds the limits of sim/yaml/document.hpp, or if its
/// format is not RunRecord::kFormat.
RunRecord parse_run_record(const std::string& text, const std::string& file);

/// Reads run.json of a run folder, or returns nothing if there is no such file, as in a run that has not
/// ended. Throws InputError as parse_run_record() and find_run_file() do.
std::optional<RunRecord> find_run_record(const std::string& folder);

/// Returns the version of armtune that made the run; empty if the record does not name it.
std::string armtune_version(const RunRecord& record);

}  // namespace armtune::internal
