#include "tuner/cli/export_origin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "armtune/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/gains/gains_origin.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::cli {
namespace {

namespace fs = std::filesystem;

bool names_folder(const std::string& set) {
  std::error_code ignored;
  return fs::is_directory(set, ignored);
}

/// Returns those of the files that the run did not read as they are now.
std::vector<std::string> not_read_by(const std::optional<RunRecord>& run, std::vector<std::string> files) {
  if (!run) return files;
  std::erase_if(files, [&run](const std::string& file) {
    return std::any_of(run->inputs.begin(), run->inputs.end(), [&file](const InputFact& input) {
      return input.path == shown_path(file) && input.hash == hash_of_input(file);
    });
  });
  return files;
}

}  // namespace

std::shared_ptr<const RobotModel> robot_of(const GainsToExport& what, const std::string& run) {
  if (!what.robot.empty()) return load_robot(what.robot);
  if (!run.empty()) return scenarios_of(run, {}, {}).front().robot;
  if (!names_folder(what.set)) return load_robot("ur10");
  throw InputError(fmt::format(
      "{}: has no study.yaml, so the arm of the gains is unknown; name the arm with --robot", what.set));
}

std::vector<std::pair<std::string, std::string>> origin_of(const GainsToExport& what, const std::string& path,
                                                           const std::string& run, const std::string& robot) {
  std::vector<std::string> files = {robot};
  if (!what.robot.empty()) files.push_back(read_robot_file(what.robot).path);
  if (run.empty() && !names_folder(what.set)) {
    files.push_back(path);
    return origin_of_files(files);
  }
  const std::string& folder = run.empty() ? what.set : run;
  const std::vector<std::string> other_files = not_read_by(find_run_record(folder), files);
  const bool of_other_arm = !other_files.empty();
  const auto own = find_run_file(folder, "gains.yaml");  // a Pareto front has no such file
  const bool of_other_gains = !own || hash_of_input(path) != hash_of_input(*own);
  if (!of_other_arm && !of_other_gains) return origin_of_run(folder);
  auto origin = origin_of_run(folder, false);
  origin.insert(
      origin.begin(),
      {"warning",
       fmt::format(
           "this run's objective, limits and margins do not apply to these gains{}; simulate them first",
           of_other_arm ? " on this arm, which is not the arm of the run"
                        : ", which are not those of its gains.yaml")});
  const auto others = origin_of_inputs(other_files);
  origin.insert(origin.end(), others.begin(), others.end());
  return origin;
}

void warn_of_failed_checks(const std::string& path, const std::string& run) {
  const auto own = run.empty() ? std::nullopt : find_run_file(run, "gains.yaml");
  if (!own || hash_of_input(path) != hash_of_input(*own)) return;
  if (const std::string failed = failed_checks(run); !failed.empty())
    print_warning(fmt::format(
        "in simulation these gains failed: {}. Do not put them on a robot; {}/verdict.yaml has the details",
        failed, run));
}

}  // namespace armtune::internal::cli
