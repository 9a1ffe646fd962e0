#pragma once
// A log: what a robot recorded, as numbers against time.

#include <string>
#include <vector>

namespace armtune::internal {

/**
 * A log is what a robot recorded, as numbers against time: the rows of a CSV file, or the topics of a bag.
 * All numbers of one topic were recorded at the same instants.
 */
struct LogChannel {
  std::string name;           ///< for example "/joint_states/position[0]", or the name of a column
  std::string unit;           ///< as the file or its type states it, for example "rad"; empty: not stated
  std::vector<double> value;  ///< as many as LogTopic::time; NaN where a row has no number
};

struct LogTopic {
  std::string name;          ///< for example "/joint_states"; of a CSV file, the name of the file
  std::string type;          ///< for example "sensor_msgs/msg/JointState"; "csv"
  std::vector<double> time;  ///< s, from Log::start on: the stamp of a message where it has one, otherwise
                             ///< when it was recorded
  std::vector<LogChannel> channels;
  std::vector<std::string>
      labels;  ///< names that the messages give their elements, such as joints; empty: none
};

struct Log {
  std::string file;
  double start = 0;  ///< s on the recorder's clock: the smallest time of all topics
  std::vector<LogTopic> topics;
};

}  // namespace armtune::internal
