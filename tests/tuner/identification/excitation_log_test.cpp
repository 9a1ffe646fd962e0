#include "tuner/identification/excitation_log.hpp"

#include <gtest/gtest.h>

#include "tests/core/support/arms.hpp"
#include "tests/sim/support/read_back.hpp"

namespace armtune::internal {
namespace excitation_log_test {

TEST(LogCsv, ReadsBackToTheBitAndIsEmptyWhereThereIsNoFigure) {
  for (const RobotModel& arm : test::all_arms()) {
    const int n = arm.n();
    ExcitationLog log;
    std::size_t i = 0;
    const auto next = [&i] {
      ++i;
      return i % 7 == 0 ? test::no_figures()[(i / 7) % test::no_figures().size()] : test::awkward(i);
    };
    for (int k = 0; k < 20; ++k) {
      LogSample& sample = log.samples.emplace_back();
      sample.time = next();
      for (JointVector* values : {&sample.q, &sample.qd, &sample.torque}) {
        values->resize(n);
        for (double& x : *values) x = next();
      }
    }
    test::ReadBack read(log_csv(arm, log));
    for (std::size_t row = 0; row < log.samples.size(); ++row) {
      const LogSample& sample = log.samples[row];
      read.number(row, "time", sample.time);
      for (int j = 0; j < n; ++j) {
        const std::string joint = "joint/" + arm.joints[static_cast<std::size_t>(j)].name;
        read.number(row, joint + "/position", sample.q[j]);
        read.number(row, joint + "/velocity", sample.qd[j]);
        read.number(row, joint + "/torque", sample.torque[j]);
      }
    }
    read.expect_all_seen(log.samples.size());
  }
}

}  // namespace excitation_log_test
}  // namespace armtune::internal
