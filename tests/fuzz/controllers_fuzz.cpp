// Whatever the bytes: parameter files that take other gains, with nothing but numbers changed, and read back
// to the same bits, or a line that refuses them.

#include <algorithm>

#include "core/control/laws/joint_impedance_law.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "sim/controller_files/changed_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "tests/fuzz/support/input.hpp"

namespace armtune::internal::fuzz {
namespace {

/// Without what a number may consist of.
std::string without_numbers(std::string text) {
  std::erase_if(text,
                [](char c) { return std::string_view("0123456789.+-eE").find(c) != std::string_view::npos; });
  return text;
}

void check(std::string_view bytes) {
  const std::vector<std::string> joints = {"a", "b"};
  const std::string text(bytes);
  read_or_refuse([&] {
    const RosController controller = chosen_controller(ros_controllers(text, "file"), "file");
    Gains gains = controller_gains(controller, "file", joints);
    require(with_gains(text, controller, "file", gains, joints) == text);
    const bool impedance = gains.controller == kJointImpedance;
    (impedance ? own(gains, "joint_impedance_k") : jtc_gain(gains, "p")) << 0.1, 1e-300;
    (impedance ? own(gains, "joint_impedance_d") : jtc_gain(gains, "d")) << 1e22, 3.0;
    const std::string changed = with_gains(text, controller, "file", gains, joints);
    require(without_numbers(changed) == without_numbers(text));
    const Gains back =
        controller_gains(chosen_controller(ros_controllers(changed, "file"), "file"), "file", joints);
    require(std::equal(back.own.begin(), back.own.end(), gains.own.begin(), gains.own.end()));
  });
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armtune::internal::fuzz::check(armtune::internal::fuzz::text(data, size));
  return 0;
}
