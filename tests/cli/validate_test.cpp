// armtune validate: whether a robot file predicts a log.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "tests/cli/support/program.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace validate_test {

using test::Finished;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;

void expect_narrow_tables(const std::string& out) {
  std::istringstream lines(out);
  std::string line;
  std::getline(lines, line);  // names the file
  while (std::getline(lines, line)) {
    const std::size_t most = line.starts_with("wrote ") ? line.size() : 80U;
    EXPECT_LE(line.size(), most) << line;
  }
}

TEST(Validate, PredictsTheLogThatExciteWritesAndNoLogOfAnotherArm) {
  const test::TemporaryFolder files;
  const std::string excite = files / "excite";
  ASSERT_EQ(run_program({"excite", "ur10", "--center", "0,-90,-60,-90,90,0", "--min-height", "0.1",
                         "--evaluations", "20", "--out", excite, "--scenario", "moving_target"})
                .exit_code,
            0);
  const std::string log = excite + "/log_moving_target.csv";
  const Finished done = run_program({"validate", log, "--robot", "ur10", "--out", files / "run"});
  EXPECT_EQ(done.exit_code, 0) << done.out << done.err;
  expect_narrow_tables(done.out);
  const RunRecord record = find_run_record(files / "run").value();
  EXPECT_EQ(record.kind, RunKind::kValidate);
  for (const JointMatchFact& joint : record.validation.value().joints)
    EXPECT_GT(joint.explained.value(), 0.99) << joint.joint;
  EXPECT_TRUE(std::filesystem::exists(files / "run/residuals.csv"));
  const std::string verdict = record.validation->headline;
  EXPECT_THAT(verdict, HasSubstr("ur10"));
  for (const ThresholdFact& threshold : record.validation->thresholds)
    EXPECT_THAT(done.out, HasSubstr(threshold.name + " = ")) << "thresholds are printed";

  // The UR5e has the same joints, and other links.
  const Finished other = run_program({"validate", log, "--robot", "ur5e"});
  EXPECT_EQ(other.exit_code, 3) << other.out << other.err;
  EXPECT_THAT(other.out, HasSubstr("  NO\n"));
  const Finished used = run_program({"validate", log, "--robot", "ur10", "--out", files / "run"});
  EXPECT_EQ(used.exit_code, 2);
  const Finished commands = run_program({"validate", log, "--robot", "ur10", "--commands", "velocity"});
  EXPECT_EQ(commands.exit_code, 2);
  EXPECT_THAT(commands.err, AllOf(HasSubstr(log), HasSubstr("velocity")));
}

TEST(Validate, IsTheNextStepOfALogWithJointsAndRefusesOneWithout) {
  const test::TemporaryFolder files;
  const std::string joints = files.write("run.csv", "time,q1,q2\n0,1,2\n0.1,1.1,2.1\n0.2,1.2,2.2\n");
  EXPECT_THAT(run_program({"logs", joints}).out, HasSubstr("\nnext: armtune validate "));
  const Finished few = run_program({"validate", joints, "--robot", "ur10"});
  EXPECT_EQ(few.exit_code, 2);
  EXPECT_EQ(few.err.find('\n'), few.err.size() - 1) << few.err;
  EXPECT_THAT(few.err, AllOf(HasSubstr(joints), HasSubstr("elbow_joint"), HasSubstr("--columns")));
  const std::string nothing = files.write("other.csv", "time,temperature\n0,1\n0.1,2\n0.2,3\n");
  EXPECT_EQ(run_program({"validate", nothing, "--robot", "ur10"}).exit_code, 2);
  EXPECT_THAT(run_program({"logs", nothing}).out, testing::Not(HasSubstr("validate")));
}

}  // namespace validate_test
}  // namespace armtune::internal
