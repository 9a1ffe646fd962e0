// Whatever the bytes: an arm that keeps its own rules, or a line that refuses it. Nothing is accepted about
// which urdfdom has an error to log, and what is accepted is written and read back as the same arm.

#include <urdf_parser/urdf_parser.h>

#include "core/robot/urdf_reader.hpp"
#include "core/robot/urdf_writer.hpp"
#include "tests/core/support/urdfdom_errors.hpp"
#include "tests/fuzz/support/input.hpp"

namespace armtune::internal::fuzz {
namespace {

void check(std::string_view bytes) {
  const InputFile file(bytes);
  read_or_refuse([&] {
    const RobotModel model = read_urdf(file.path());
    validate(model);
    const test::UrdfdomErrors errors;
    require(urdf::parseURDF(std::string(bytes)) != nullptr && errors.text().empty());
    const InputFile written(urdf_text(model));
    try {
      const RobotModel again = read_urdf(written.path());
      require(again.n() == model.n() && joint_names(again) == joint_names(model));
    } catch (const InputError&) {
      require(false);
    }
  });
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armtune::internal::fuzz::check(armtune::internal::fuzz::text(data, size));
  return 0;
}
