#pragma once
// The files of examples/joint_trajectory as the inputs of a study.

#include <gtest/gtest.h>

#include <string>

#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/controller_study/controller_study.hpp"

namespace armtune::internal::test {

inline const std::string kExample = test::source_dir() + "/examples/joint_trajectory/";

inline ControllerStudyInputs example() {
  return {"ur5e", kExample + "ros2_controllers.yaml", "", {kExample + "moves.csv"}};
}

/// The example's parameters with one text in place of another.
inline std::string changed_example(const std::string& from, const std::string& to) {
  std::string text = read_text(kExample + "ros2_controllers.yaml");
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

}  // namespace armtune::internal::test
