#include "tuner/report/yardstick_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "tuner/record/words.hpp"

namespace armtune::internal::report {
namespace {

/// The words for events of one kind.
struct KindWords {
  const char* event;
  const char* reached;   ///< words before the figure
  const char* missed;    ///< words if there is no figure
  const char* at_worst;  ///< words for the worst event
};

constexpr KindWords kKindWords[] = {
    {"switch", "reacquired in ", "not reacquired", "a target switch takes up to"},
    {"return", "back on the path in ", "not back on the path", "a return to the path takes up to"},
    {"lap", "a gaze error of ", "gaze error not measured", "the gaze error of a lap is up to"},
};

const KindWords& words_of(const std::string& event) {
  for (const KindWords& kind : kKindWords) {
    if (event == kind.event) return kind;
  }
  static constexpr KindWords kOther = {"", "", "not reached", ""};
  return kOther;
}

/// Returns, for example, "1.48 s". Radians are shown as mrad, because they are small.
std::string figure(double value, const std::string& unit) {
  constexpr double kMilli = 1e3;
  return unit == "rad" ? fmt::format("{:.3g} mrad", kMilli * value) : fmt::format("{:.3g} {}", value, unit);
}

std::string reached_words(const YardstickRow& row) {
  const KindWords& kind = words_of(row.event);
  if (row.outcome == kept_words::kAlreadyThere) return "the next target is in view already";
  if (!std::isnan(row.reached)) {
    return kind.reached + figure(row.reached, row.unit) + (row.unit == "rad" ? " rms" : "");
  }
  return fmt::format("{}: {}", kind.missed, row.outcome);
}

std::string limit_words(const YardstickRow& row) {
  if (row.outcome == kept_words::kAlreadyThere) return {};
  const std::string by = row.held_back_by.empty() ? std::string() : fmt::format(" ({})", row.held_back_by);
  if (row.status == kept_words::kThereAtOnce)
    return row.event == "return" ? "; the tool is on the path from the beginning"
                                 : "; the gaze is on target from the beginning";
  if (std::isnan(row.limit)) {
    return row.status == kept_words::kInfeasible
               ? "; no motion within the limits achieves this" + by
               : fmt::format("; the best possible value is unknown: {}", row.status);
  }
  return fmt::format("; the joint limits allow {}{}{}", figure(row.limit, row.unit),
                     row.status == kept_words::kSolved ? "" : ", " + row.status, by);
}

const YardstickRow* worst_of(const std::vector<YardstickRow>& rows, std::size_t set, const char* event) {
  const YardstickRow* worst = nullptr;
  for (const YardstickRow& row : rows) {
    if (row.set != set || row.event != event || std::isnan(row.ratio)) continue;
    if (worst == nullptr || row.ratio > worst->ratio) worst = &row;
  }
  return worst;
}

}  // namespace

std::vector<YardstickRow> yardstick_of(const std::vector<std::optional<CsvTable>>& sets) {
  std::vector<YardstickRow> rows;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    if (!sets[set]) continue;
    const CsvTable& table = *sets[set];
    const auto text = [&table](std::size_t r, const char* column) {
      return table.text(r, table.column(column));
    };
    const auto number = [&table](std::size_t r, const char* column) {
      return table.number(r, table.column(column));
    };
    for (std::size_t r = 0; r < table.rows(); ++r) {
      YardstickRow row;
      row.set = set;
      row.scenario = text(r, "scenario");
      row.event = text(r, "event");
      row.time = number(r, "time");
      row.reached = number(r, "reached");
      row.limit = number(r, "limit");
      row.ratio = number(r, "ratio");
      row.unit = text(r, "unit");
      row.outcome = text(r, "outcome");
      row.held_back_by = text(r, "held_back_by");
      row.status = text(r, "status");
      row.words = reached_words(row) + limit_words(row);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::string yardstick_sentence(const std::vector<YardstickRow>& rows, std::size_t set) {
  std::vector<std::string> told;
  for (const KindWords& kind : kKindWords) {
    const YardstickRow* worst = worst_of(rows, set, kind.event);
    if (worst == nullptr) continue;
    told.push_back(fmt::format("{} {:.3g} times the best ({} instead of {}, in {} at {:.4g} s)",
                               kind.at_worst, worst->ratio, figure(worst->reached, worst->unit),
                               figure(worst->limit, worst->unit), worst->scenario, worst->time));
  }
  if (told.empty()) return {};
  return fmt::format("Compared with the best that the joint limits allow from the same state: {}",
                     fmt::join(told, ", "));
}

}  // namespace armtune::internal::report
