#include "tuner/cli/log_options.hpp"

#include <CLI/CLI.hpp>

namespace armtune::internal::cli {

void add_log_options(CLI::App& command, LogArguments& args) {
  command
      .add_option("--topic", args.selection.topics,
                  "topics of a bag to read. * stands for any text, as in '/arm/*'. Several can be given")
      ->default_str("all topics");
  command.add_option("--msg-path", args.msg_path,
                     "folder with message definitions PACKAGE/msg/TYPE.msg, such as the share folder of ROS, "
                     "for bags that hold no definitions");
  command.add_option("--time", args.selection.time.column, "name of the column with the time stamps")
      ->default_str("found from the names and values");
  command.add_option("--time-unit", args.time_unit, "unit of the time stamps of text files")
      ->check(CLI::IsMember({"s", "ms", "us", "ns"}))
      ->default_str("found from the names and values");
  command
      .add_option("--rate", args.rate,
                  "rate of the rows of text files [Hz], for files that have no time stamps or wrong ones. "
                  "Time stamps in the file are then ignored")
      ->check(CLI::PositiveNumber);
}

LogSelection selection_of(const LogArguments& args) {
  LogSelection selection = args.selection;
  selection.msg_path = args.msg_path;
  selection.time.unit = time_unit(args.time_unit);
  if (args.rate > 0.0) selection.time.rate = args.rate;
  return selection;
}

}  // namespace armtune::internal::cli
