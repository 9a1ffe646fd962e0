#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/support/program.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace pareto_test {

using test::Finished;
using test::run_program;
using testing::HasSubstr;

const test::ShortStudy& files() {
  static const test::ShortStudy study(test::kShortParameters, test::kShortObjective,
                                      "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: 2}\n");
  return study;
}

const test::ShortStudy& study_short_of_time() {
  static const test::ShortStudy study(
      test::kShortParameters, test::kShortObjective,
      "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: 2}\n",
      "search: {algorithm: COBYLA, max_evaluations: 12, max_minutes: 1e-6}\n");
  return study;
}

TEST(ParetoCommand, LeavesAFrontWhosePointsTheOtherCommandsTake) {
  const std::string folder = files() / "front";
  const Finished done =
      run_program({"pareto", files().path(), "--criteria", "objective", "effort_rate/rms", "--levels", "3",
                   "--max-evaluations", "24", "--out", folder, "--workers", "2"});
  ASSERT_EQ(done.exit_code, 0) << done.err << done.out;
  EXPECT_THAT(done.err, HasSubstr("warning: 24 evaluations")) << "and nothing else";
  EXPECT_THAT(done.out, testing::AllOf(HasSubstr("start (gains)"), HasSubstr("hypervolume 0."),
                                       HasSubstr("simulated again and gave the same values")));
  const auto csv = test::read_csv(folder + "/pareto.csv");
  const auto journal = test::read_csv(folder + "/evaluations.csv");
  EXPECT_EQ(journal.rows.size(), 24U);
  ASSERT_GE(csv.rows.size(), 3U);
  const std::string number = csv.at(0, "evaluation");
  EXPECT_EQ(journal.at(std::stoul(number), "objective"), csv.at(0, "objective"));
  EXPECT_EQ(journal.at(std::stoul(number), "criterion/effort_rate/rms"), csv.at(0, "effort_rate/rms"));
  EXPECT_THAT(test::read_text(folder + "/columns.csv"), HasSubstr("pareto.csv,dominates_start,"));
  const RunRecord run = find_run_record(folder).value();
  ASSERT_TRUE(run.front && run.search);
  EXPECT_TRUE(run.front->verified);
  EXPECT_EQ(run.front->points + 1, static_cast<long>(csv.rows.size())) << "and the start";
  EXPECT_EQ(run.search->evaluations, 24);

  const Finished again = run_program({"simulate", files() / "short.yaml", files() / "short_realistic.yaml",
                                      "--gains", folder + "/points/01.yaml", "--out", files() / "again"});
  // The end of a front that is best in accuracy may command more than a drive gives: 3 says so.
  ASSERT_TRUE(again.exit_code == 0 || again.exit_code == 3) << again.err;
  const auto errors = test::read_csv(files() / "again/errors.csv");
  const double worst =
      std::max(std::stod(errors.at(0, "effort_rate/rms")), std::stod(errors.at(1, "effort_rate/rms")));
  EXPECT_EQ(worst, std::stod(csv.at(0, "effort_rate/rms"))) << "the point's gains give the point's figures";
}

TEST(ParetoCommand, SaysThatItsTimeWasUsedUp) {
  const auto& short_of_time = study_short_of_time();
  const std::string folder = short_of_time / "front";
  const Finished done = run_program(
      {"pareto", short_of_time.path(), "--levels", "2", "--max-evaluations", "18", "--out", folder});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.out, testing::AllOf(HasSubstr("budget: 18 evaluations or 1e-06 minutes"),
                                       HasSubstr("max_minutes was reached after 1 evaluations")));
  EXPECT_EQ(find_run_record(folder).value().search.value().ended, SearchEnd::kTime);
}

TEST(ParetoCommand, TradesOffWithAnotherController) {
  const auto& short_of_time = study_short_of_time();
  const std::string folder = short_of_time / "joint_pd";
  const Finished done = run_program({"pareto", short_of_time.path(), "--controller", "joint_pd", "--levels",
                                     "2", "--max-evaluations", "40", "--out", folder});
  EXPECT_THAT(done.exit_code, testing::AnyOf(0, 3)) << done.err;
  EXPECT_THAT(test::read_text(folder + "/study.yaml"), HasSubstr("joint_pd_p/elbow_joint"));
  EXPECT_THAT(test::read_text(folder + "/start/gains.yaml"), HasSubstr("controller: joint_pd"));
}

TEST(ParetoCommand, RefusesWhatItCannotTradeOff) {
  const auto refused = [](const char* criterion) {
    const Finished finished =
        run_program({"pareto", files().path(), "--criteria", "gaze/rms", criterion, "--out", files() / "x"});
    EXPECT_EQ(finished.exit_code, 2);
    return finished.err;
  };
  EXPECT_THAT(refused("gaze/rms"), HasSubstr("gaze/rms is given twice"));
  EXPECT_THAT(refused("speed"), HasSubstr("'speed' is neither 'objective' nor a metric"));
  const Finished one = run_program({"pareto", files().path(), "--criteria", "gaze/rms"});
  EXPECT_EQ(one.exit_code, 2);
}

}  // namespace pareto_test
}  // namespace armtune::internal
