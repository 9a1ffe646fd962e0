#include "sim/rollout/world.hpp"

#include <limits>

namespace armtune::internal {

void world_at(const Scenario& scenario, int k, World& world) {
  world.time = scenario.start_time + k * scenario.control_period;
  world.target = scenario.active_target(world.time);
  if (scenario.orientation) {
    const Vec3 nowhere = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    world.target_motion = {nowhere, nowhere, nowhere};
    world.orientation = scenario.orientation->at(world.time, scenario.path);
  } else {
    world.target_motion = scenario.targets[world.target].path.at(world.time);
  }
  world.on_path = scenario.path.at(world.time);
  if (const std::optional<Stimulus>& stimulus = scenario.stimulus) {
    const Vec3 offset = stimulus->at(world.time);
    if (stimulus->on == Stimulus::On::kPath) world.path_shift = offset;
    if (stimulus->on == Stimulus::On::kTarget) world.target_motion.position += offset;
    world.on_path.position += world.path_shift;
  }
  world.obstacles.resize(scenario.obstacles.size());
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    world.obstacles[i] = scenario.obstacles[i].at(world.time);
  }
}

}  // namespace armtune::internal
