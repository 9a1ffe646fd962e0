#pragma once
// Rewrites the report page of a search every few seconds, so that a browser can show the progress of the
// search.

#include <chrono>
#include <string>

#include "tuner/report/report_data.hpp"
#include "tuner/session/observer.hpp"

namespace armtune::internal {

class LiveReport {
 public:
  /// folder: the run folder. Throws InputError if armtune is built without the report's page.
  LiveReport(std::string folder, SessionObserver& observer);

  /// Rewrites FOLDER/report.html if the last report is old enough. Call it after every evaluation. Reports
  /// are some seconds apart, and writing them takes at most a twentieth of the wall time. Never throws. If a
  /// report cannot be written, it warns once, and the search continues without further reports. evaluations:
  /// number of evaluations so far; most_evaluations: largest number; seconds_left: estimated time left [s].
  void update(long evaluations, long most_evaluations, double seconds_left);

 private:
  using Clock = std::chrono::steady_clock;

  std::string folder_;
  SessionObserver& observer_;
  Clock::time_point next_ = Clock::now();
  double every_ = 0.0;  ///< shortest time between two reports [s]
  bool failed_ = false;
};

}  // namespace armtune::internal
