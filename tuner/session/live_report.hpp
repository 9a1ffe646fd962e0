#pragma once
// A report that is kept fresh while its run lasts.

#include <chrono>
#include <string>

#include "tuner/report/report_data.hpp"
#include "tuner/session/observer.hpp"

namespace armtune::internal {

class LiveReport {
 public:
  /// Of a run folder. Throws InputError where armtune is built without the report's page.
  LiveReport(std::string folder, SessionObserver& observer);

  /// To be called after every evaluation. Writes FOLDER/report.html, whole or not at all, where the last one
  /// is some seconds old: never more than a twentieth of the time goes into it. Never throws: a report that
  /// cannot be written is warned of once, and the search continues.
  void update(long evaluations, long most_evaluations, double seconds_left);

 private:
  using Clock = std::chrono::steady_clock;

  std::string folder_;
  SessionObserver& observer_;
  Clock::time_point next_ = Clock::now();
  double every_ = 0.0;  ///< [s]
  bool failed_ = false;
};

}  // namespace armtune::internal
