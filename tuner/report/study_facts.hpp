#pragma once
// What study.yaml says of a run, without the files that it names: they may have been moved.

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
  std::string scale;  ///< log, linear
};

struct StudyTerm {
  Metric metric = Metric::kPositionMax;
  std::vector<std::string> scenarios;
};

struct StudyLimit {
  Metric metric = Metric::kPositionMax;
  bool upper = true;            ///< at most, else at least
  std::optional<double> value;  ///< none: the start's
  std::vector<std::string> scenarios;
};

struct StudyFacts {
  std::string description;
  std::vector<StudyGain> gains;
  std::vector<StudyTerm> terms;
  std::vector<StudyLimit> limits;
  std::string measure;  ///< "worst of 5 arms each" of a study on many arms, else empty
};

/// What its terms and limits are of, twice or not.
std::vector<Metric> metrics_of(const StudyFacts& study);

/// Of a study.yaml in a run folder. Throws InputError naming file and key.
StudyFacts read_study_facts(const std::string& path);

}  // namespace armtune::internal::report
