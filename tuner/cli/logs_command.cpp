// The command `armtune logs`, which lists what recordings hold.

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "armtune/error.hpp"
#include "sim/logs/log_reader.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/log_options.hpp"
#include "tuner/cli/logs_printer.hpp"
#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {
namespace {

struct LogsArguments {
  std::vector<std::string> files;
  LogArguments log;
  bool join = false;
  bool all = false;
};

void list(const std::vector<std::string>& files, const LogsArguments& args) {
  const LogSummary summary = summarize_log(files, selection_of(args.log));
  say(log_text(summary, args.all) + "\n" + next_step(summary));
}

void run_logs(const LogsArguments& args) {
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
      "logs",
      "List the channels, rates, gaps and ranges of recordings, and guess what each channel measures");
  command
      ->add_option("FILE", args->files,
                   "CSV files in any common layout, .mcap files, .db3 files, or folders of rosbag2")
      ->required();
  command->add_flag("--join", args->join,
                    "read several text files side by side as one log, if the recorder wrote one file for "
                    "each signal");
  add_log_options(*command, args->log);
  command->add_flag("--all", args->all, "list all topics, and each channel in its own row");
  command->footer(
      "What each channel measures is guessed from its name, unit and values: velocities, for example, are\n"
      "the derivative of positions. A guess is 'certain' if name and values agree, 'likely' if only one of\n"
      "them supports it, 'possible' if only the range of the values does, and 'doubtful' if name and values\n"
      "contradict each other. docs/logs.md lists the layouts, and which faults of a log are repaired.\n\n"
      "Examples:\n"
      "  armtune logs run.csv\n"
      "  armtune logs recording.mcap --topic '/joint_states' --all\n"
      "  armtune logs time.txt positions.txt torques.txt --join\n");
  command->callback([args] { run_logs(*args); });
}

}  // namespace armtune::internal::cli
