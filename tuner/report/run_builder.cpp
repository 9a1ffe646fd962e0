#include "tuner/report/run_builder.hpp"

#include "tuner/report/replay.hpp"

namespace armtune::report {
namespace {

struct GroupOf {
  const char* prefix;
  const char* group;
  const char* unit;
};

/// Of columns whose names begin so.
constexpr GroupOf kGroups[] = {{"tool/position/", "position", "m"},
                               {"desired/position/", "position", "m"},
                               {"error/position/", "position_error", "m"},
                               {"error/orientation/", "orientation_error", "rad"},
                               {"error/linear_velocity/", "linear_velocity_error", "m/s"},
                               {"error/angular_velocity/", "angular_velocity_error", "rad/s"},
                               {"gaze/angle", "gaze", "rad"},
                               {"compensation_error", "theta", "N m"},
                               {"obstacle/distance", "clearance", "m"},
                               {"manipulability", "manipulability", "m^3"}};

}  // namespace

RunBuilder::RunBuilder(const CsvTable& table, const Resolution& resolution)
    : table_(table),
      time_(table.numbers(table.column("time"))),
      since_(time_),
      buckets_(time_.size(), resolution.buckets),
      replay_rate_(resolution.replay_rate) {
  for (double& t : since_) t -= began();
  if (!since_.empty()) run.end = since_.back();
  run.time = quantize(buckets_.times(since_));
}

void RunBuilder::add(const std::string& name, const std::string& group, const char* unit,
                     const std::vector<double>& values) {
  run.columns.push_back({name, group, unit, quantize(buckets_.extremes(values))});
}

void RunBuilder::add_task_columns() {
  for (const GroupOf& g : kGroups) {
    for (std::size_t c = 0; c < table_.header().size(); ++c) {
      const std::string& name = table_.header()[c];
      if (!name.starts_with(g.prefix)) continue;
      const bool error = name.starts_with("error/");
      add(name, g.group, g.unit,
          error ? tracked(table_, c, name.starts_with("error/position/")) : table_.numbers(c));
    }
  }
}

void RunBuilder::add_replay(const SceneScenario* scenario, const Arm* arm) {
  if (scenario != nullptr && arm != nullptr && !time_.empty())
    run.replay = replay_of(table_, *scenario, *arm, time_, replay_rate_);
}

}  // namespace armtune::report
