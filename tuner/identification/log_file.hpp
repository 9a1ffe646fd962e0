#pragma once
// Logs of joint positions, velocities and torques in CSV, read line by line: a rollout's or a real robot's.

#include <deque>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune {

/// Where a joint's numbers stand and what they are multiplied with to become SI.
struct LogColumn {
  std::string name;
  double scale = 1.0;
};

/// Columns of a log, joints in the model's order.
struct LogColumns {
  LogColumn time;
  std::vector<LogColumn> position;
  std::vector<LogColumn> velocity;  ///< n, or empty: the log has none, nor needs any
  std::vector<LogColumn> torque;
  bool velocity_optional = false;  ///< a log without any of their columns has no velocities
};

/// As armtune writes them: `time`, `joint/NAME/position`, `joint/NAME/torque`; `joint/NAME/velocity` if
/// there.
LogColumns default_log_columns(const RobotModel& model);

/// From a YAML file: time, position, velocity (may be missing), torque; each of the last three is a list of n
/// column names, or a map from joint names to column names, with `scale` factors beside them. Throws
/// InputError.
LogColumns load_log_columns(const std::string& path, const RobotModel& model);

struct LogSample {
  double time = 0.0;
  JointVector q;
  JointVector qd;  ///< empty if the log has no velocities
  JointVector torque;
};

/// Reads a log from its start. Throws InputError with file, line and column for whatever is not a whole log:
/// missing or doubled columns, lines of more than 1 MB, rows of another length, text that is no finite
/// number, times that do not grow evenly.
class LogFile {
 public:
  LogFile(const std::string& path, const LogColumns& columns);

  /// The next sample, or none at the end.
  std::optional<LogSample> next();
  /// Time between samples [s]: the mean of the first steps, as many as are read ahead.
  double period() const { return period_; }
  const std::string& path() const { return path_; }
  bool has_velocities() const { return !columns_.velocity.empty(); }

 private:
  bool read_line();
  bool read_row();
  double number(std::size_t column, const LogColumn& what) const;
  JointVector numbers(const std::vector<std::size_t>& places, const std::vector<LogColumn>& columns) const;
  std::optional<LogSample> read_sample();
  void check_time(double time);
  void read_ahead();
  void check_step(double step, long line) const;
  void check_rate(double duration, long steps) const;

  std::string path_;
  LogColumns columns_;
  std::ifstream file_;
  std::vector<char> buffer_;
  std::string_view line_;  ///< in the buffer
  long line_number_ = 0;
  std::vector<std::string_view> cells_;
  std::size_t width_ = 0;
  std::size_t time_place_ = 0;
  std::vector<std::size_t> position_places_, velocity_places_, torque_places_;
  double period_ = 0.0;
  double last_time_ = 0.0;
  long stretch_steps_ = 0;      ///< since then
  double stretch_begin_ = 0.0;  ///< time at which the present stretch of steps begins [s]
  long samples_ = 0;
  std::deque<LogSample> ahead_;  ///< read ahead for the period
};

}  // namespace armtune
