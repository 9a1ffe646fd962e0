#include "sim/scenario/named_paths_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "core/common/message_text.hpp"
#include "core/common/nearest.hpp"
#include "sim/scenario/name_key.hpp"
#include "sim/scenario/path_file.hpp"
#include "sim/scenario/random_targets.hpp"

namespace armtune::internal {
namespace {

constexpr long kMostRandomTargets = 1000;
constexpr double kLargestBody = 100.0;  // m

/// Throws InputError at the name's node if the last element has the name of another one. Names must be unique
/// because schedules and results refer to them.
template <typename Named>
void refuse_second_of_name(const std::vector<Named>& all, const yaml::Node& node) {
  const auto is_so_named = [&all](const Named& other) { return other.name == all.back().name; };
  if (std::any_of(all.begin(), all.end() - 1, is_so_named))
    node.fail(
        fmt::format("two entries of this list are named {}; rename one of them", shown(all.back().name)),
        "another name");
}

/// Reads the name and the path of an item, which may have further keys.
NamedPath read_named_path(yaml::MapReader& map, std::vector<std::string>& inputs) {
  const std::string name = read_name(map);
  return {name, read_path(map, inputs)};
}

}  // namespace

std::vector<MovingObstacle> read_obstacles(const yaml::Node& node, std::vector<std::string>& inputs) {
  std::vector<MovingObstacle> obstacles;
  for (const yaml::Node& item : node.items()) {
    yaml::MapReader map(item);
    for (const char* shape : {"box", "cylinder", "capsule", "sphere"}) {
      if (const yaml::Node* other = item.find(shape)) {
        other->fail(
            "obstacles are spheres that the controller avoids: give 'radius'. Give other shapes under "
            "'parts' of the scenario's 'cell'");
      }
    }
    NamedPath center = read_named_path(map, inputs);
    obstacles.push_back(
        {std::move(center.name), std::move(center.path), map.number_in("radius", 0.0, 0.0, kLargestBody)});
    refuse_second_of_name(obstacles, map.required("name"));
    map.finish();
  }
  return obstacles;
}

std::vector<NamedPath> read_targets(const yaml::Node& node, std::vector<std::string>& inputs) {
  if (node.kind() != yaml::Node::Kind::kMap) {
    std::vector<NamedPath> targets;
    for (const yaml::Node& item : node.items()) {
      yaml::MapReader map(item);
      targets.push_back(read_named_path(map, inputs));
      refuse_second_of_name(targets, map.required("name"));
      map.finish();
    }
    return targets;
  }
  yaml::MapReader outer(node);
  const yaml::Node& random = outer.required("random");
  outer.finish();
  yaml::MapReader map(random);
  const yaml::Node& count_node = map.required("count");
  const long count = count_node.as_integer();
  if (count < 1 || count > kMostRandomTargets) {
    count_node.fail(InputFault{.problem = fmt::format("the number of targets is {}", count),
                               .limit = fmt::format("1 to {}", kMostRandomTargets)});
  }
  const Vec3 low(map.required("low").as_numbers(3).data());
  const yaml::Node& high_node = map.required("high");
  const Vec3 high(high_node.as_numbers(3).data());
  if (!(high.array() >= low.array()).all())
    high_node.fail("a coordinate is less than in 'low'; it must be at least as large",
                   "at least as large as in 'low'");
  const long seed = map.integer("seed", 1);
  if (seed < 0) map.required("seed").fail("must not be negative", "not negative");
  map.finish();
  return random_targets(static_cast<int>(count), low, high, static_cast<std::uint64_t>(seed));
}

std::vector<TargetTurn> read_schedule(const yaml::Node& node, const std::vector<NamedPath>& targets) {
  std::vector<TargetTurn> schedule;
  std::size_t before = 0;
  for (const yaml::Node& item : node.items()) {
    yaml::MapReader map(item);
    const yaml::Node& at = map.required("at");
    const yaml::Node& target = map.required("target");
    map.finish();
    const std::string name = target.as_string();
    std::vector<std::string> names;
    TargetTurn turn{at.as_number(), targets.size()};
    for (std::size_t i = 0; i < targets.size(); ++i) {
      names.push_back(targets[i].name);
      if (targets[i].name == name && turn.target == targets.size()) turn.target = i;
    }
    if (turn.target == targets.size())
      target.fail("'" + name + "' is not a target" + suggestion(name, names),
                  fmt::format("one of: {}", fmt::join(names, ", ")));
    if (!(turn.at > (schedule.empty() ? 0.0 : schedule.back().at)))
      at.fail(fmt::format("the time {} s is not allowed here; the times of a schedule must be above zero and "
                          "increase",
                          turn.at),
              fmt::format("above {}", schedule.empty() ? 0.0 : schedule.back().at));
    if (turn.target == before)
      target.fail(fmt::format("the gaze is already at {}; give another target", name), "another target");
    before = turn.target;
    schedule.push_back(turn);
  }
  return schedule;
}

}  // namespace armtune::internal
