#include "tuner/session/live_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "armtune/error.hpp"
#include "tuner/report/report.hpp"

namespace armtune::internal {
namespace {

constexpr double kLeastSeconds = 3.0;  ///< shortest time between two pages [s]
constexpr double kShare = 20.0;        ///< writing takes at most 1 / kShare of the time

}  // namespace

LiveReport::LiveReport(std::string folder, SessionObserver& observer)
    : folder_(std::move(folder)), observer_(observer), every_(kLeastSeconds) {
  if (!report::available())
    throw InputError(
        "--live: this armtune was built without the report page; install node and npm with scripts/setup, "
        "and rebuild");
}

void LiveReport::update(long evaluations, long most_evaluations, double seconds_left) {
  const auto now = Clock::now();
  if (failed_ || now < next_) return;
  report::Live live;
  live.evaluations = evaluations;
  live.most_evaluations = most_evaluations;
  live.seconds_left = seconds_left;
  live.every = every_;
  live.written = static_cast<long>(std::time(nullptr));
  try {
    report::write_report(folder_, folder_ + "/report.html", report::Existing::kReplace, live);
  } catch (const std::exception& error) {
    failed_ = true;
    observer_.warned(fmt::format("the live report is no longer updated: {}", error.what()));
    return;
  }
  const double took = std::chrono::duration<double>(Clock::now() - now).count();
  every_ = std::ceil(std::max(kLeastSeconds, kShare * took));
  next_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(every_));
}

}  // namespace armtune::internal
