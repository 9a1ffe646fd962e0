#pragma once
// A report that is kept fresh while its run goes on.

#include <chrono>
#include <string>

#include "tuner/report/report_data.hpp"

namespace armtune::cli {

class LiveReport {
 public:
  /// Of a run folder. Throws InputError where armtune is built without the report's page.
  explicit LiveReport(std::string folder);

  /// To be called after every evaluation. Writes FOLDER/report.html, whole or not at all, where the last one
  /// is some seconds old: never more than a twentieth of the time goes into it. Never throws: a report that
  /// cannot be written is said once, and the search goes on.
  void update(long evaluations, long most_evaluations, double seconds_left);

 private:
  using Clock = std::chrono::steady_clock;

  std::string folder_;
  Clock::time_point next_ = Clock::now();
  double every_ = 0.0;  ///< [s]
  bool failed_ = false;
};

}  // namespace armtune::cli
