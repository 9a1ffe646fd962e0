// The bundled planning tasks, cut off anywhere. YAML itself takes what is left of a block mapping for a whole
// one.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/scenario/data_files.hpp"
#include "tests/sim/support/cut_off.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/planning/tasks/plan_task.hpp"

namespace armtune::internal {
namespace planning_cut_off_test {

void expect_valid(const PlanTask& task) {
  ASSERT_NE(task.scenario.robot, nullptr);
  const int n = task.scenario.robot->n();
  EXPECT_TRUE(std::isfinite(task.at) && task.at >= 0.0) << task.at;
  EXPECT_GE(task.knots, 12);
  EXPECT_EQ(task.goal.size(), task.kind == PlanKind::kMove ? n : 0);
  EXPECT_TRUE(task.goal.allFinite());
  EXPECT_TRUE(task.start.position.size() == 0 || task.start.position.size() == n);
  EXPECT_TRUE(task.start.position.allFinite());
  if (task.kind == PlanKind::kReturn) {
    EXPECT_EQ(task.start.position.size(), n);
  }
  if (task.kind == PlanKind::kTrack || task.least_error) {
    ASSERT_TRUE(task.duration);
    EXPECT_TRUE(std::isfinite(*task.duration) && *task.duration > 0.0);
  }
  if (task.clearance > 0.0) {
    EXPECT_FALSE(task.scenario.obstacles.empty());
  }
}

/// The key that a task cannot do without and that stands last in its file.
std::size_t last_required(const std::string& name, const std::string& text) {
  std::vector<std::string> keys = {"task", "scenario"};
  static const std::map<std::string, std::string> special = {{"ur10_clear_of_obstacles", "goal"},
                                                             {"ur10_lap", "duration"},
                                                             {"ur10_least_gaze_error", "at"},
                                                             {"ur10_move", "goal"},
                                                             {"ur10_return", "start"},
                                                             {"ur10_switch", "at"}};
  if (const auto found = special.find(name); found != special.end()) keys.push_back(found->second);
  std::size_t last = 0;
  for (const std::string& key : keys) last = std::max(last, test::up_to_key(text, key));
  return last;
}

TEST(CutOff, APlanningTaskIsRefusedOrWhole) {
  const std::vector<std::string> names = bundled_names("tasks");
  ASSERT_GE(names.size(), 7U);
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const test::TemporaryFolder folder;
    const std::string text = test::read_text(find_data_file("tasks", name));
    const std::size_t required = last_required(name, text);
    const test::Cuts cuts = test::cut_off(text, required, 1, [&](const std::string& beginning) {
      expect_valid(load_plan_task(folder.write("cut.yaml", beginning)));
    });
    EXPECT_EQ(cuts.refused_before, required + 1);
    EXPECT_GT(cuts.loaded + cuts.refused_after, 0U);
  }
}

}  // namespace planning_cut_off_test
}  // namespace armtune::internal
