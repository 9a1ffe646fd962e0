// armtune tune --live: a page that is fresh while the run goes on.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <regex>
#include <thread>

#include "tests/cli/support/program.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/report/report.hpp"

namespace armtune::internal {
namespace live_test {

using test::Program;
using testing::HasSubstr;
using testing::Not;

/// Evaluations that the page shows of a run that goes on; -1: it does not show one.
long live_evaluations(const std::string& page) {
  const std::string html = test::read_text(page);
  std::smatch found;
  const std::regex live(R"re("live": ?\{"evaluations": ?([0-9]+),[^}]*"most_evaluations": ?4000\b)re");
  return std::regex_search(html, found, live) ? std::stol(found[1]) : -1;
}

/// Waits until the page shows more than `seen`; -1 if the run ends before, or after a minute.
long more_than(long seen, const std::string& page, Program& run) {
  for (int tries = 0; tries < 600 && run.running(); ++tries) {
    if (const long now = live_evaluations(page); now > seen) return now;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return -1;
}

TEST(LiveReport, ShowsMoreEvaluationsWhileTheRunGoesOnAndInTheEndTheRunItself) {
  if (!report::available()) GTEST_SKIP() << "the page is not built in";
  const test::ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                               "search: {algorithm: CRS2, max_evaluations: 4000, seed: 1}\n");
  const std::string page = files / "run/report.html";
  Program run({"tune", files.path(), "--out", files / "run", "--live", "--no-analysis"}, files / "");
  const long first = more_than(0, page, run);
  ASSERT_GT(first, 0) << "no page: " << (run.running() ? "it runs" : run.wait().err);
  const long later = more_than(first, page, run);
  EXPECT_GT(later, first);
  EXPECT_THAT(test::read_text(page), HasSubstr("This run is still running"));
  run.interrupt();
  const auto done = run.wait();
  EXPECT_EQ(done.exit_code, 130) << done.err;
  EXPECT_THAT(done.out, HasSubstr("to watch the search, open "));
  EXPECT_EQ(live_evaluations(page), -1) << "the last page is that of the run";
  EXPECT_THAT(test::read_text(page), Not(HasSubstr("This run is still running")));
}

TEST(LiveReport, ChangesNothingInTheResult) {
  const test::ShortStudy files;
  for (const std::string run : {"live", "not"}) {
    std::vector<std::string> arguments = {"tune", files.path(), "--out", files / run, "--no-analysis"};
    if (run == "live") arguments.emplace_back("--live");
    if (run == "live" && !report::available()) GTEST_SKIP() << "the page is not built in";
    EXPECT_EQ(test::run_program(arguments).exit_code, 0);
  }
  for (const char* file : {"gains.yaml", "errors.csv", "rollout_short.csv", "study.yaml"})
    EXPECT_EQ(test::read_text(files / ("live/" + std::string(file))),
              test::read_text(files / ("not/" + std::string(file))));
}

}  // namespace live_test
}  // namespace armtune::internal
