// armtune logs: what a recording holds.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tests/cli/support/program.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace logs_test {

using test::Finished;
using test::run_program;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

/// A log of two joints at 100 Hz, in the columns of an RTDE recorder.
std::string log_text() {
  std::string text =
      "timestamp,actual_q_0,actual_q_1,actual_qd_0,actual_qd_1,actual_current_0,actual_current_1\n";
  for (int k = 0; k < 400; ++k) {
    const double t = 0.01 * k;
    std::ostringstream row;
    row.precision(12);
    row << t << ',' << std::sin(t) << ',' << std::sin(2 * t) << ',' << std::cos(t) << ','
        << 2 * std::cos(2 * t) << ",1.5," << t << '\n';
    text += row.str();
  }
  return text;
}

TEST(Logs, SaysWhatChannelsLookLike) {
  const test::TemporaryFolder files;
  const Finished done = run_program({"logs", files.write("run.csv", log_text())});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.err, "");
  EXPECT_THAT(done.out, ContainsRegex("run.csv +400 +100 "));
  EXPECT_THAT(done.out, ContainsRegex("actual_q_0..1 .* rad +positions .certain.\n"));
  EXPECT_THAT(done.out, ContainsRegex("actual_qd_0..1 .* rad/s +velocities .certain.\n"));
  EXPECT_THAT(done.out, ContainsRegex("actual_current_0..1 .* A +currents"));
  EXPECT_THAT(done.out, ContainsRegex("\nnext: armtune [^\n]*\n$"));
}

TEST(Logs, ListsTheMcapFileThatSimulateWrites) {
  const test::ShortStudy files;
  const std::vector<std::string> simulate = {"simulate", files / "short.yaml", "--gains",
                                             files / "gains.yaml", "--mcap"};
  const Finished refused = run_program(simulate);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("--mcap"), HasSubstr("--out")));
  std::vector<std::string> with_folder = simulate;
  with_folder.insert(with_folder.end(), {"--out", files / "run"});
  const Finished simulated = run_program(with_folder);
  EXPECT_EQ(simulated.exit_code, 0) << simulated.err;
  EXPECT_THAT(simulated.out, HasSubstr("rollout_<scenario>.mcap"));
  const Finished listed = run_program({"logs", files / "run/rollout_short.mcap", "--topic", "/joint_states"});
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  EXPECT_EQ(listed.err, "");
  EXPECT_THAT(listed.out, ContainsRegex("/joint_states +800 +100 ")) << "8 s at 100 Hz";
  EXPECT_THAT(listed.out, ContainsRegex("rad +positions .(certain|likely)."));
}

TEST(Logs, FitsEightyColumnsAndListsEveryChannelIfAsked) {
  const test::TemporaryFolder files;
  const std::string path = files.write("run.csv", log_text());
  const std::string out = run_program({"logs", path, "--all"}).out;
  for (const char* channel : {"actual_q_1", "actual_qd_0", "actual_current_1"})
    EXPECT_THAT(out, HasSubstr(channel));
  std::istringstream lines(out);
  for (std::string line; std::getline(lines, line);) {
    const bool table = line.find("  ") != std::string::npos;
    const std::size_t most = line.find(files.path()) != std::string::npos ? line.size() : table ? 80 : 100;
    EXPECT_LE(line.size(), most) << line;
  }
}

TEST(Logs, AsksForARateAndTakesIt) {
  const test::TemporaryFolder files;
  const std::string path = files.write("run.csv", "q1,q2\n1,2\n1.5,2.5\n1,2\n1.25,3\n");
  const Finished refused = run_program({"logs", path});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr(path), HasSubstr("--rate")));
  const Finished done = run_program({"logs", path, "--rate", "250"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.out, ContainsRegex("run.csv +4 +250 "));
}

TEST(Logs, JoinsFiles) {
  const test::TemporaryFolder files;
  const std::string time = files.write("time.txt", "0\n0.01\n0.02\n0.03\n");
  const std::string q = files.write("q.txt", "1\n5\n2\n6\n3\n7\n4\n8\n");
  const Finished done = run_program({"logs", time, q, "--join"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("q[0..1]"));
}

TEST(Logs, RefusesBadFilesWithOneLine) {
  const test::TemporaryFolder files;
  for (const std::string& path :
       {files.write("a.csv", "t,q\n0,1\n0.1,x\n0.2,1\n"), files.write("b.mcap", "no bag"),
        files.write("c.db3", "no bag"), files / "nowhere.csv", files.path()}) {
    const Finished done = run_program({"logs", path});
    EXPECT_EQ(done.exit_code, 2) << path;
    EXPECT_EQ(done.err.find('\n'), done.err.size() - 1) << done.err;
    EXPECT_THAT(done.err, HasSubstr(path));
  }
}

}  // namespace logs_test
}  // namespace armtune::internal
