// The command `armtune logs`, which lists what recordings hold.

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "armtune/error.hpp"
#include "sim/logs/log_reader.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/logs_printer.hpp"
#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {
namespace {

struct LogsArguments {
  std::vector<std::string> files;
  LogSelection selection;
  std::string msg_path;
  std::string time_unit;
  double rate = 0.0;
  bool join = false;
  bool all = false;
};

void list(const std::vector<std::string>& files, const LogsArguments& args) {
  const LogSummary summary = summarize_log(files, args.selection);
  say(log_text(summary, args.all) + "\n" + next_step(summary));
}

void run_logs(LogsArguments& args, bool has_rate) {
  args.selection.msg_path = args.msg_path;
  args.selection.time.unit = time_unit(args.time_unit);
  if (has_rate) args.selection.time.rate = args.rate;
  if (args.join) return list(args.files, args);
  bool first = true;
  for (const std::string& file : args.files) {
    if (!first) say("\n");
    first = false;
    list({file}, args);
  }
}

}  // namespace

void add_logs_command(CLI::App& app, int&) {
  auto args = std::make_shared<LogsArguments>();
  CLI::App* command = app.add_subcommand(
      "logs", "List the channels, rates, gaps and ranges of recordings, and what the channels look like");
  command
      ->add_option("FILE", args->files,
                   "CSV files in any common layout, .mcap files, .db3 files, or folders of rosbag2")
      ->required();
  command->add_flag("--join", args->join,
                    "read several text files side by side as one log, if the recorder wrote one file for "
                    "each signal");
  command
      ->add_option("--topic", args->selection.topics,
                   "topics of a bag to read. * stands for any text, as in '/arm/*'. Several can be given")
      ->default_str("all topics");
  command->add_option(
      "--msg-path", args->msg_path,
      "folder with message definitions PACKAGE/msg/TYPE.msg, such as the share folder of ROS, "
      "for bags that hold no definitions");
  command->add_flag("--all", args->all, "list every channel in a row of its own, and every topic");
  command->add_option("--time", args->selection.time.column, "name of the column with the time stamps")
      ->default_str("found from the names and values");
  command->add_option("--time-unit", args->time_unit, "unit of the time stamps of text files")
      ->check(CLI::IsMember({"s", "ms", "us", "ns"}))
      ->default_str("found from the names and values");
  CLI::Option* rate =
      command
          ->add_option("--rate", args->rate,
                       "rate of the rows of text files without time stamps [Hz]. Time stamps in the file are "
                       "ignored")
          ->check(CLI::PositiveNumber);
  command->footer(
      "Names, units and the values tell what channels look like: velocities, for example, are the derivative\n"
      "of positions. 'certain' means that name and values agree, 'likely' that one of them says so, 'possible'\n"
      "that only the range suggests it, and 'doubtful' that they contradict each other. docs/logs.md lists the\n"
      "layouts, and how far a log is repaired.\n\n"
      "Examples:\n"
      "  armtune logs run.csv\n"
      "  armtune logs recording.mcap --topic '/joint_states' --all\n"
      "  armtune logs time.txt positions.txt torques.txt --join\n");
  command->callback([args, rate] { run_logs(*args, rate->count() > 0); });
}

}  // namespace armtune::internal::cli
