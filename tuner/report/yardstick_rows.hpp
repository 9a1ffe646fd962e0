#pragma once
// Reads yardstick.csv for the report page. Each row is about one event, that is, a part of a rollout such as
// a switch of the target. The row compares the result of the rollout in this part with the best result that
// the arm's limits allow.

#include <optional>
#include <string>
#include <vector>

#include "sim/csv/csv_table.hpp"
#include "tuner/record/declaration.hpp"

namespace armtune::internal::report {

struct YardstickRow {
  std::size_t set = 0;
  std::string scenario, event;
  double time = 0.0, reached = 0.0, limit = 0.0, ratio = 0.0;
  std::string unit, outcome, held_back_by, status, words;

  static void declare(auto& f, auto& row) {
    using enum record::Presence;
    f.type("YardstickEvent",
           "A part of a rollout, and the best that the arm's limits allow from the same state.");
    f("set", row.set, "Index into `sets`.")("scenario", row.scenario)("event", row.event,
                                                                      {"switch", "return", "lap"});
    f("time", row.time, "Time at which it begins, s.");
    f("reached", row.reached, "Result of the rollout in `unit`; null if the goal was not reached.", kOrNull);
    f("limit", row.limit, "Best possible result in `unit`; null if none was found.", kOrNull);
    f("ratio", row.ratio, "`reached` divided by `limit`; null if `limit` is missing or zero.", kOrNull)(
        "unit", row.unit, {"s", "rad"});
    f("held_back_by", row.held_back_by, "The limit of the arm that restricts the best possible motion most.");
    f("words", row.words,
      "Such as \"reacquired in 1.48 s; the joint limits allow 1.21 s (velocity of elbow_joint)\".");
  }
};

/// Returns the rows of all gain sets. sets: the table yardstick.csv of each set, empty if there is no file.
/// Throws InputError naming file and column.
std::vector<YardstickRow> yardstick_of(const std::vector<std::optional<CsvTable>>& sets);

/// Returns a sentence about one gain set. For each kind of event (switch, return, lap) it compares the worst
/// event with the best possible result. The text is empty if no event has a ratio.
std::string yardstick_sentence(const std::vector<YardstickRow>& rows, std::size_t set);

}  // namespace armtune::internal::report
