#include "sim/scenario/random_targets.hpp"

#include <fmt/format.h>

#include "sim/scenario/uniform.hpp"

namespace armtune::internal {

std::vector<NamedPath> random_targets(int count, const Vec3& low, const Vec3& high, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<NamedPath> targets(static_cast<std::size_t>(count));
  int number = 0;
  for (NamedPath& target : targets) {
    target.name = fmt::format("random_{}", ++number);
    for (int axis = 0; axis < 3; ++axis) target.path.center[axis] = uniform(generator, low[axis], high[axis]);
  }
  return targets;
}

}  // namespace armtune::internal
