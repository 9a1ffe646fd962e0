#include "sim/rollout/world.hpp"

namespace armtune {

void world_at(const Scenario& scenario, int k, World& world) {
  world.time = scenario.start_time + k * scenario.control_period;
  world.target = scenario.active_target(world.time);
  world.target_motion = scenario.targets[world.target].path.at(world.time);
  world.on_path = scenario.path.at(world.time);
  if (const std::optional<Stimulus>& stimulus = scenario.stimulus) {
    const Vec3 offset = stimulus->at(world.time);
    if (stimulus->on == Stimulus::On::kPath) world.path_shift = offset;
    if (stimulus->on == Stimulus::On::kTarget) world.target_motion.position += offset;
    world.on_path.position += world.path_shift;
  }
  world.obstacles.resize(scenario.obstacles.size());
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    world.obstacles[i] = scenario.obstacles[i].path.at(world.time).position;
  }
}

}  // namespace armtune
