#pragma once
// Reads a log of joint positions, velocities and torques sample by sample. A log is a text table that was
// recorded on a real robot or in simulation.

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tuner/identification/log_columns.hpp"
#include "tuner/identification/log_lines.hpp"

namespace armtune::internal {

struct LogSample {
  double time = 0.0;  ///< since the log's first sample [s]
  JointVector q;
  JointVector qd;  ///< empty if the log has no velocities
  JointVector torque;
};

/// A log that is read from its start. Blank lines at the start of the file are skipped. If the first line
/// after them holds numbers only, the log has no column names, and its columns are called 1, 2, 3 and so on.
/// Throws InputError with file, line and column if the log is malformed. Examples are missing or repeated
/// columns, lines of more than 1 MB, rows with too few or too many cells, text that is not a finite number,
/// and times that do not increase evenly.
class LogFile {
 public:
  LogFile(const std::string& path, const LogColumns& columns);

  /// Returns the next sample, or nothing at the end.
  std::optional<LogSample> next();
  /// Returns the time between samples [s]: the mean over the samples that are read ahead at the start.
  double period() const { return period_; }
  const std::string& path() const { return path_; }
  /// Returns the hash of the file; valid after next() has returned nothing.
  std::string hash() const { return lines_.hash(); }
  bool has_velocities() const { return !columns_.velocity.empty(); }

 private:
  void read_header();
  std::size_t place_of(const LogColumn& column) const;
  std::vector<std::size_t> places_of(const std::vector<LogColumn>& columns) const;
  bool read_row();
  double read_number(std::size_t column, const LogColumn& what) const;
  double read_value(std::size_t column, const LogColumn& what) const;
  double read_time();
  JointVector read_values(const std::vector<std::size_t>& places,
                          const std::vector<LogColumn>& columns) const;
  std::optional<LogSample> read_sample();
  void check_time(double time);
  void read_ahead();
  void check_step(double step, long line) const;
  void check_rate(double duration, long steps) const;

  std::string path_;
  LogColumns columns_;
  LogLines lines_;
  char separator_ = ',';
  std::vector<std::string> header_;
  long header_line_ = 1;   ///< the first line that is not blank
  bool has_names_ = true;  ///< true if that line holds the names of the columns
  std::vector<std::string_view> cells_;
  std::size_t time_place_ = 0;
  std::vector<std::size_t> position_places_, velocity_places_, torque_places_;
  double period_ = 0.0;
  double first_time_ = 0.0;  ///< time of the first sample, in the file's unit
  double last_time_ = 0.0;
  long stretch_steps_ = 0;      ///< number of steps in the stretch whose mean step is checked next
  double stretch_begin_ = 0.0;  ///< time at which this stretch begins [s]
  long samples_ = 0;
  std::deque<LogSample> ahead_;  ///< samples that were read ahead to find the period
};

}  // namespace armtune::internal
