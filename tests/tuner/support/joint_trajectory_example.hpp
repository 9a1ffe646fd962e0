#pragma once
// The files of examples/joint_trajectory as the inputs of a study.

#include <string>

#include "tests/core/support/source_dir.hpp"
#include "tuner/controller_study/controller_study.hpp"

namespace armtune::internal::test {

inline const std::string kExample = test::source_dir() + "/examples/joint_trajectory/";

inline ControllerStudyInputs example() {
  return {"ur5e", kExample + "ros2_controllers.yaml", "", {kExample + "moves.csv"}};
}

}  // namespace armtune::internal::test
