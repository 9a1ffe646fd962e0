#include "sim/logs/row_order.hpp"

#include <fmt/format.h>

#include <utility>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"

namespace armtune::internal {

void RowOrder::push(LogRow& row) {
  ++rows_;
  if (any_ && row.time < last_) {
    throw InputError(
        at_line(file_, row.line, key_),
        fmt::format("the time jumps back by {:.6g} s; if the recording was restarted here, split "
                    "the log here and give both parts",
                    (window_.empty() ? last_ : window_.back().time) - row.time))
        .with_value(
            fmt::format("{:.6g}", row.time),
            fmt::format("rows that come at most {} rows after their place in time", RepairBounds::kWindow));
  }
  auto place = window_.end();
  while (place != window_.begin() && row.time < std::prev(place)->time) --place;
  if ((place != window_.begin() && std::prev(place)->time == row.time) || (any_ && row.time == last_)) {
    ++repairs_.repeated;
    return;
  }
  if (place != window_.end()) ++repairs_.moved;
  window_.insert(place, std::move(row));
  row = LogRow();
  if (free_.empty()) return;
  row.value = std::move(free_.back());
  free_.pop_back();
}

bool RowOrder::pop(LogRow& row, bool end) {
  if (window_.empty() || (!end && window_.size() <= RepairBounds::kWindow)) return false;
  std::swap(row, window_.front());
  free_.push_back(std::move(window_.front().value));
  window_.pop_front();
  last_ = row.time;
  any_ = true;
  return true;
}

void RowOrder::check_bounds() const {
  const long rows = rows_ + repairs_.no_time;
  const auto check = [&](long count, double share, const char* what) {
    if (count <= RepairBounds::kAllowed || static_cast<double>(count) <= share * static_cast<double>(rows))
      return;
    throw InputError(
        InputPlace{file_, 0, key_},
        fmt::format("{} of {} rows {}, which is more than {} %; export the log again with its own "
                    "time stamps, or give the rate of evenly spaced rows with --rate HZ",
                    count, rows, what, 100.0 * share))
        .with_value(std::to_string(count), fmt::format("at most {} % of the rows", 100.0 * share));
  };
  check(repairs_.repeated, RepairBounds::kRepeatedShare, "repeat the time stamp of another row");
  check(repairs_.moved, RepairBounds::kMovedShare, "come after a row with a larger time stamp");
  check(repairs_.no_time, RepairBounds::kNoTimeShare, "have no time stamp");
}

}  // namespace armtune::internal
