#pragma once
// How good could any controller be? Each event of a rollout beside the best that the arm's limits allow from
// the same state on.

#include "sim/rollout/columns.hpp"
#include "tuner/planning/output/binding_limits.hpp"
#include "tuner/planning/refining_solver.hpp"
#include "tuner/planning/tasks/plan_task.hpp"
#include "tuner/planning/yardstick/events.hpp"

namespace armtune {

struct YardstickOptions {
  double velocity = 1.0;  ///< shares of the arm's limits
  double effort = 1.0;
  double gaze_threshold = 0.15;  ///< [rad]
  double path_tolerance =
      1e-3;  ///< [m]; wider where the rollout itself is farther from the path during the event
  int knots = 120;
};

struct Measure {
  std::string scenario;
  Event event;
  PlanStatus status = PlanStatus::kStalled;
  double limit = 0.0;        ///< least possible of what `reached` counts; NaN unless solved
  std::string held_back_by;  ///< "velocity of wrist_2_joint"; empty where nothing is
};

/// The plan that an event is held against.
PlanTask task_of(const Event& event, const Scenario& scenario, const YardstickOptions& options);

Measure measure(const Event& event, const Scenario& scenario, const YardstickOptions& options,
                const PlanObserver& observer);

/// Text of yardstick.csv, a row an event; and its columns.
std::string yardstick_csv(const std::vector<Measure>& measures);
std::vector<Column> yardstick_columns();

}  // namespace armtune
