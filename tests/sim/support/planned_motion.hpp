#pragma once
// Files of planned motions, and the motions that are read from them.

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "sim/scenario/planned_motion.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/scenario.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/planned.hpp"

namespace armtune::internal::test {

/// Reads planned motions of the UR10 from files.
class PlannedMotion : public testing::Test {
 protected:
  PlannedMotion() {
    plan_.start = JointVector::Constant(6, -0.5);
    plan_.goal = JointVector::Constant(6, 0.7);
  }
  std::string csv() const { return plan_csv(*robot_, plan_); }
  std::string write(const std::string& text) const { return folder_.write("plan.csv", text); }

  /// Three rows at rest, one joint's cell replaced.
  InputError refused(int row, int column, const std::string& value) const {
    std::string text = plan_header(*robot_);
    const JointVector zero = JointVector::Zero(6);
    for (int r = 0; r < 3; ++r) {
      std::string line = plan_row(8.0 + 0.01 * r, {zero, zero, zero});
      if (r == row) {
        std::size_t begin = 0;
        for (int c = 0; c < column; ++c) begin = line.find(',', begin) + 1;
        line.replace(begin, line.find_first_of(",\n", begin) - begin, value);
      }
      text += line;
    }
    const std::string path = write(text);
    return input_error([&] { load(path); });
  }
  JointSpline load(const std::string& path) const { return load_planned_motion({{path}}, *robot_); }
  Scenario scenario(const std::string& keys) const {
    return load_scenario(folder_.write("own.yaml", "base: moving_target\n" + keys));
  }

  TemporaryFolder folder_;
  std::shared_ptr<const RobotModel> robot_ = load_robot("ur10");
  QuinticPlan plan_;
};

}  // namespace armtune::internal::test
