// A study whose goal is a metric of which more is better: the search raises it.

#include <gtest/gtest.h>

#include <atomic>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/search/tune.hpp"

namespace armtune::internal {
namespace more_is_better_test {

/// The tool at rest, its set point on eight sines up to 10 Hz.
const std::string kSines =
    "base: sines_position\n"
    "duration: 16\n"
    "stimulus:\n"
    "  on: path\n"
    "  sines: {direction: [0, 0, 1], amplitude: 0.0005, base_period: 2, orders: [1, 2, 3, 5, 8, 12, 16, "
    "20],\n"
    "          from: 12, periods: 1}\n";

TEST(MoreIsBetter, TheSearchRaisesTheBandwidth) {
  const test::TemporaryFolder folder;
  folder.write("sines.yaml", kSines);
  const Study study =
      load_study(folder.write("study.yaml",
                              "gains: published\n"
                              "scenarios: [sines.yaml]\n"
                              "parameters:\n"
                              "  - {name: task_space_gains_p}\n"
                              "  - {name: task_space_gains_d}\n"
                              "objective:\n"
                              "  - {metric: response/bandwidth}\n"
                              "search: {algorithm: COBYLA, max_evaluations: 16, engine: native}\n"));
  CandidateRunner workers(study.scenarios, study.stepper, 2);
  const std::atomic<bool> never{false};
  const TuneResult result = tune(study, workers, never, {});
  const double start = result.start.results[0].metrics[Metric::kResponseBandwidth];
  const double tuned = result.best.results[0].metrics[Metric::kResponseBandwidth];
  EXPECT_GT(tuned, 1.1 * start) << "Hz";
  EXPECT_NEAR(result.best.objective, start / tuned, 1e-12) << "what is reported is what was gained";
}

}  // namespace more_is_better_test
}  // namespace armtune::internal
