// The command `armtune report`, which writes the report page of a run folder again.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "core/common/path_state.hpp"
#include "sim/csv/text_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/session/report_files.hpp"

namespace armtune::internal::cli {
namespace {

struct ReportArguments {
  std::string folder;
  std::string path;
};

int run_report(const ReportArguments& args) {
  const bool own = args.path.empty();
  const std::string path = own ? args.folder + "/report.html" : args.path;
  if (!own) refuse_existing(path);  // before the work, not after it
  const report::Written written =
      report::write_report(args.folder, path, own ? report::Existing::kReplace : report::Existing::kRefuse);
  SessionPrinter<> printer;
  warn_of_left_out(written, printer);
  constexpr double kMegabyte = 1e6;
  say(fmt::format("wrote {} ({:.2f} MB)\n", path, static_cast<double>(written.bytes) / kMegabyte));
  return kDone;
}

}  // namespace

void add_report_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<ReportArguments>();
  CLI::App* command =
      app.add_subcommand("report", "Write the report of a run again: one HTML page with replay and plots");
  command
      ->add_option("DIR", args->folder, "run folder of simulate, tune, pareto, robustness, compare or plan")
      ->required();
  command->add_option("--out", args->path, "file for the page, which must not exist yet")
      ->default_str("DIR/report.html, which is overwritten");
  command->footer(
      "The page needs neither a server nor a network. Sections for which the folder has no data are left\n"
      "out. Meshes of the arm are drawn if they are STL or OBJ files in the robot's folder. The robot's\n"
      "folder is the nearest one with a package.xml, from the folder of the URDF upwards. Without a\n"
      "package.xml, it is the folder of the URDF, or the folder above if the URDF lies in a folder 'urdf'.\n"
      "To allow further folders, list them in the environment variable ARMTUNE_MESHES, as FOLDER:FOLDER, or\n"
      "as PACKAGE=FOLDER for a ROS package.\n\n"
      "Example:\n  armtune report runs/ur10_gaze_20261121-103000\n");
  command->callback([args, &exit_code] { exit_code = run_report(*args); });
}

}  // namespace armtune::internal::cli
