#include "tuner/cli/yardstick_files.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/common/path_state.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/rollout/error_report.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/rollout_scenarios.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/planning/yardstick/yardstick_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/session/report_files.hpp"

namespace armtune::internal::cli {
namespace {

/// Returns the path of the provenance file of a yardstick CSV file: the same path with the ending .yaml.
std::string provenance_path(const std::string& csv) {
  return std::filesystem::path(csv).replace_extension(".yaml").string();
}

/// Writes the report of the run again, with the new comparison. Returns ", PATH", or an empty text if no
/// report was written. An error is only a warning, because the comparison is written already.
std::string report_again(const std::string& run) {
  std::error_code ignored;
  if (!std::filesystem::exists(run + "/report.html", ignored) || !report::available()) return {};
  try {
    SessionPrinter<> printer;
    warn_of_left_out(report::write_report(run, run + "/report.html"), printer);
    return fmt::format(", {}/report.html", run);
  } catch (const std::exception& error) {
    print_warning(fmt::format("the report was not updated: {}", error.what()));
    return {};
  }
}

std::string provenance_text(const YardstickRequest& request, const std::vector<Scenario>& scenarios,
                            const RolloutMeasures& found, double seconds) {
  Provenance p;
  p.command = command_line();
  p.inputs = {request.folder + "/gains.yaml"};
  p.streamed = found.recordings;
  add_inputs(scenarios, p.inputs);
  p.wall_seconds = seconds;
  p.extra = {{"events", std::to_string(found.measures.size())},
             {"velocity", fmt::format("{}", request.options.velocity)},
             {"effort", fmt::format("{}", request.options.effort)},
             {"knots", std::to_string(request.options.knots)}};
  return run_yaml(p);
}

}  // namespace

void refuse_used_output(const YardstickRequest& request) {
  if (request.out.empty()) return;
  refuse_existing(request.out);
  refuse_existing(provenance_path(request.out));
}

std::string write_yardstick(const YardstickRequest& request, const std::vector<Scenario>& scenarios,
                            const RolloutMeasures& found, double seconds) {
  const bool own = request.out.empty();
  const std::string csv = own ? request.folder + "/yardstick.csv" : request.out;
  const std::string table = yardstick_csv(found.measures);
  const std::string origin = provenance_text(request, scenarios, found, seconds);
  own ? write_text_file(csv, table) : write_new_text_file(csv, table);
  own ? write_text_file(provenance_path(csv), origin) : write_new_text_file(provenance_path(csv), origin);
  std::string names = fmt::format("{}, {}", csv, provenance_path(csv));
  if (own) {
    const std::string run = run_of(request.folder);
    names += add_columns(run, {"yardstick.csv", yardstick_columns()}) + report_again(run);
  }
  return names;
}

}  // namespace armtune::internal::cli
