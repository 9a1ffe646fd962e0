// Commands as ranks of mpirun give the same files as with threads.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/cli/support/program.hpp"
#include "tests/cli/support/ranks.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace ranks_test {

using test::Finished;
using test::Ranks;
using test::rows;
using test::ShortStudy;
using test::without_time;
using testing::HasSubstr;
using Strings = std::vector<std::string>;

TEST_F(Ranks, TuneTheSameByteForByteAsThreads) {
  const ShortStudy files;
  for (const char* workers : {"1", "2", "4"}) {
    const Finished done =
        alone(tune(files.path(), files / (std::string("threads") + workers), {"--workers", workers}));
    ASSERT_EQ(done.exit_code, 0) << done.err;
  }
  for (const int ranks : {1, 2, 4}) {
    const Finished done = run(ranks, tune(files.path(), files / ("ranks" + std::to_string(ranks)), {}));
    ASSERT_EQ(done.exit_code, 0) << done.err << done.out;
    EXPECT_EQ(done.out.find("study study:"), done.out.rfind("study study:")) << "only one rank speaks";
    if (ranks == 1) continue;  // alone it is one process with threads
    EXPECT_EQ(find_run_record(files / ("ranks" + std::to_string(ranks)))->workers, ranks);
  }
  const std::string expected = without_time(files / "threads1/evaluations.csv");
  ASSERT_FALSE(expected.empty());
  for (const char* folder : {"threads2", "threads4", "ranks1", "ranks2", "ranks4"}) {
    EXPECT_EQ(without_time(files / folder + "/evaluations.csv"), expected) << folder;
    for (const char* file : {"/gains.yaml", "/errors.csv", "/start/errors.csv"}) {
      EXPECT_EQ(test::read_text(files / folder + file), test::read_text(files / "threads1" + file))
          << folder << file;
    }
  }
}

// Ranks are told per job which engine simulates it: a search has both.
TEST_F(Ranks, SearchInTheNativeEngineAsOneProcessDoes) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         test::kShortNativeSearch);
  const Finished done = alone(tune(files.path(), files / "one", {"--workers", "1"}, "24"));
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const std::string expected = without_time(files / "one/evaluations.csv");
  for (const char* rows :
       {"start,simbody,", "start,native,", "sweep,native,", "search,native,", "verify,simbody,"}) {
    EXPECT_THAT(expected, HasSubstr(rows));
  }
  for (const int ranks : {2, 4}) {
    const std::string folder = "ranks" + std::to_string(ranks);
    const Finished parallel = run(ranks, tune(files.path(), files / folder, {}, "24"));
    ASSERT_EQ(parallel.exit_code, 0) << parallel.err;
    EXPECT_EQ(without_time(files / folder + "/evaluations.csv"), expected) << folder;
    for (const char* file :
         {"/gains.yaml", "/errors.csv", "/start/errors.csv", "/study.yaml", "/rollout_short.csv"}) {
      EXPECT_EQ(test::read_text(files / folder + file), test::read_text(files / "one" + file))
          << folder << file;
    }
  }
}

TEST_F(Ranks, FindTheSameFrontAndSensitivitiesAsThreads) {
  const ShortStudy files;
  ASSERT_EQ(alone(tune(files.path(), files / "run", {})).exit_code, 0);
  const auto sensitivity = [&](const std::string& out) {
    return Strings{"sensitivity", files / "run", "--out", files / out};
  };
  const auto pareto = [&](const std::string& out) {
    return Strings{"pareto", files.path(), "--levels", "2", "--max-evaluations", "18", "--out", files / out};
  };
  ASSERT_EQ(alone(sensitivity("s1")).exit_code, 0);
  ASSERT_EQ(run(2, sensitivity("s2")).exit_code, 0);
  EXPECT_EQ(test::read_text(files / "s2/sensitivity.csv"), test::read_text(files / "s1/sensitivity.csv"));
  const Finished threads = alone(pareto("p1"));
  const Finished ranks = run(2, pareto("p2"));
  EXPECT_EQ(ranks.exit_code, threads.exit_code) << ranks.err;
  EXPECT_FALSE(test::read_text(files / "p1/pareto.csv").empty());
  EXPECT_EQ(test::read_text(files / "p2/pareto.csv"), test::read_text(files / "p1/pareto.csv"));
  EXPECT_EQ(without_time(files / "p2/evaluations.csv"), without_time(files / "p1/evaluations.csv"));
}

TEST_F(Ranks, DrawTheSameArmsAsThreads) {
  const std::string scenario = folder_.write("short.yaml", "base: realistic_moving_target\nduration: 4\n");
  const auto robustness = [&](const std::string& out, const Strings& more) {
    Strings all = {"robustness", "extended_tuned", "--scenarios", scenario, "--samples",
                   "7",          "--out",          folder_ / out};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const Finished threads = alone(robustness("threads", {"--workers", "2"}));
  ASSERT_EQ(threads.exit_code, 3) << threads.err << "in 4 s nothing is tracked yet, so no arm passes";
  for (const int ranks : {2, 4}) {
    const std::string out = "ranks" + std::to_string(ranks);
    const Finished done = run(ranks, robustness(out, {}));
    ASSERT_EQ(done.exit_code, 3) << done.err;
    for (const char* file : {"/samples.csv", "/summary.csv"}) {
      EXPECT_EQ(test::read_text(folder_ / out + file), test::read_text(folder_ / "threads" + file))
          << out << file;
    }
  }
}

}  // namespace ranks_test
}  // namespace armtune::internal
