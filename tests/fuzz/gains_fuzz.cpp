// Whatever the bytes: gains that are written and read back to the same bits, or a line that refuses them.

#include "sim/scenario/gains_file.hpp"
#include "tests/fuzz/support/input.hpp"

namespace armtune::internal::fuzz {
namespace {

void check(std::string_view bytes) {
  const std::vector<std::string> joints = {"a", "b", "c", "d", "e", "f"};
  const InputFile file(bytes);
  read_or_refuse([&] {
    const Gains gains = load_gains(file.path(), joints);
    const std::string text = gains_yaml(gains, {"written"});
    const InputFile written(text);
    require(gains_yaml(load_gains(written.path(), joints), {"written"}) == text);
  });
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armtune::internal::fuzz::check(armtune::internal::fuzz::text(data, size));
  return 0;
}
