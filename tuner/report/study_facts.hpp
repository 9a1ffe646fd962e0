#pragma once
// Reads study.yaml of a run folder for the report. A study defines a tuning task: the gains to tune, the
// terms of the objective, and the limits (constraints). Other files that study.yaml names are not read,
// because they may have been moved.

#include <optional>
#include <string>
#include <vector>

#include "sim/metrics/metric.hpp"

namespace armtune::internal::report {

struct StudyGain {
  std::string name;
  double start = 0.0;
  double lower = 0.0;
  double upper = 0.0;
  std::string scale;  ///< "log" or "linear"
};

struct StudyTerm {
  Metric metric = Metric::kPositionMax;
  std::vector<std::string> scenarios;
};

struct StudyLimit {
  Metric metric = Metric::kPositionMax;
  bool upper = true;            ///< true: the metric must be at most `value`; false: at least
  std::optional<double> value;  ///< empty: the metric's value with the start gains
  std::vector<std::string> scenarios;
};

struct StudyFacts {
  std::string description;
  std::vector<StudyGain> gains;
  std::vector<StudyTerm> terms;
  std::vector<StudyLimit> limits;
  std::string measure;  ///< such as "worst of 5 arms in each scenario"; empty for a study on one arm
};

/// Returns the metrics of the terms and limits; a metric may occur twice.
std::vector<Metric> metrics_of(const StudyFacts& study);

/// Reads study.yaml of a run folder. Throws InputError naming file and key.
StudyFacts read_study_facts(const std::string& path);

}  // namespace armtune::internal::report
