// Writes random arms as robot files for scripts/check-arms: FOLDER/random_K.urdf, and FOLDER/random_K.yaml
// with the data that a URDF cannot contain. Usage: benchmark_random_arms COUNT FOLDER

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/robot_writer.hpp"
#include "tests/core/support/arms.hpp"

namespace {

using armtune::internal::RobotModel;

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  if (!(file << text)) {
    fmt::print(stderr, "{}: cannot be written\n", path);
    std::exit(1);
  }
}

/// Returns arm number k, with five to seven joints. Every other arm has prismatic joints.
RobotModel arm_of(unsigned k) {
  return armtune::internal::test::random_arm(5 + static_cast<int>(k % 3), 1000 + k, k % 2 == 1);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: benchmark_random_arms COUNT FOLDER\n");
    return 2;
  }
  const std::string folder = argv[2];
  for (unsigned k = 0; k < static_cast<unsigned>(std::atoi(argv[1])); ++k) {
    const RobotModel arm = arm_of(k);
    const std::string name = fmt::format("{}/random_{:02}", folder, k);
    write(name + ".urdf", armtune::internal::urdf_text(arm));
    write(name + ".yaml", armtune::internal::robot_yaml(arm, fmt::format("random_{:02}.urdf", k)));
  }
  return 0;
}
