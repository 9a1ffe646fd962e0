// Whatever the bytes: a motion whose times rise, if it has any, and whose numbers are finite, for the joints
// that were asked for, or a line that refuses it.

#include <cmath>

#include "sim/scenario/trajectory_message.hpp"
#include "tests/fuzz/support/input.hpp"

namespace armtune::internal::fuzz {
namespace {

RobotModel two_joints() {
  RobotModel arm;
  arm.chain.n = 2;
  for (const char* name : {"a", "b"})
    arm.joints.push_back({name, std::string("link_") + name, {true, -4.0, 4.0, 1.0, 1.0}});
  return arm;
}

void check(std::string_view bytes) {
  static const RobotModel arm = two_joints();
  const InputFile file(bytes);
  read_or_refuse([&] {
    const MotionPoints motion = load_trajectory_message(file.path(), arm);
    require(motion.points.size() >= 2 && motion.lines.size() == motion.points.size());
    require(motion.time.empty() || motion.time.size() == motion.points.size());
    for (std::size_t k = 0; k < motion.time.size(); ++k)
      require(std::isfinite(motion.time[k]) && motion.time[k] >= 0.0 &&
              (k == 0 || motion.time[k] > motion.time[k - 1]));
    for (std::size_t k = 0; k < motion.points.size(); ++k) {
      for (const JointVector* values :
           {&motion.points[k].position, &motion.points[k].velocity, &motion.points[k].acceleration})
        require(values->size() == 2 && values->allFinite());
    }
  });
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armtune::internal::fuzz::check(armtune::internal::fuzz::text(data, size));
  return 0;
}
