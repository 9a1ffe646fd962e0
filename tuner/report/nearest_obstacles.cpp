#include "tuner/report/nearest_obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace armtune::internal::report {

void keep_nearest(const NumberTable& recording, std::size_t most, SceneScenario& scenario) {
  constexpr std::size_t kLooks = 200;  // rows, evenly over the recording
  const std::size_t count = scenario.obstacles.size();
  if (count <= most) return;
  const auto time = recording.find("time");
  const auto x = recording.find("tool/position/x");
  const auto y = recording.find("tool/position/y");
  const auto z = recording.find("tool/position/z");
  std::vector<double> distance(count, INFINITY);
  if (time && x && y && z) {
    const std::size_t looks = std::min(kLooks, recording.rows());
    for (std::size_t k = 0; k < looks; ++k) {
      const std::size_t r = k * recording.rows() / looks;
      const Vec3 tool(recording.number(r, *x), recording.number(r, *y), recording.number(r, *z));
      for (std::size_t i = 0; i < count; ++i) {
        const SceneObstacle& obstacle = scenario.obstacles[i];
        const double now =
            (obstacle.path.at(recording.number(r, *time)).position - tool).norm() - obstacle.radius;
        if (now < distance[i]) distance[i] = now;
      }
    }
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&distance](std::size_t a, std::size_t b) { return distance[a] < distance[b]; });
  order.resize(most);
  std::sort(order.begin(), order.end());
  std::vector<SceneObstacle> kept;
  kept.reserve(most);
  for (const std::size_t i : order) kept.push_back(scenario.obstacles[i]);
  scenario.obstacles = std::move(kept);
}

}  // namespace armtune::internal::report
