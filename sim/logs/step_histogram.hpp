#pragma once
// The distribution of the time between rows, in bounded memory.

#include <map>

namespace armtune::internal {

struct StepSummary {
  double median = 0.0;   ///< [s]; 0 if there are fewer than two rows
  double jitter = 0.0;   ///< half the width of the central 90 % of the steps, relative to the median
  double longest = 0.0;  ///< [s]
  long gaps = 0;         ///< number of steps longer than kGap times the median
};

/// Counts steps in classes that are 0.1 % wide. A class keeps the sum of its steps, so that equal steps have
/// an exact median. There are at most 40,000 classes, between 1 ps and 2e5 s.
class StepHistogram {
 public:
  static constexpr double kGap = 1.5;  ///< a step that is longer than this many median steps is a gap

  /// Adds a step [s]. A step that is zero, negative or not finite is ignored.
  void add(double step);
  StepSummary summary() const;

 private:
  struct Class {
    long count = 0;
    double sum = 0.0;
  };
  double quantile(double share) const;

  std::map<int, Class> classes_;
  long count_ = 0;
  double longest_ = 0.0;
};

}  // namespace armtune::internal
