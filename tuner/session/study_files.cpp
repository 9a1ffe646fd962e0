#include "tuner/session/study_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "sim/controller_files/parameter_file.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/session/recorded_distribution.hpp"

namespace armtune::internal {

std::string search_text(const Study& study) {
  return fmt::format("{}{}{}{}", global_of(study).empty() ? "" : global_of(study) + ", then ",
                     study.solver.algorithm,
                     study.starts > 1 ? fmt::format(" from {} starts", study.starts) : "",
                     study.final_phase ? ", then a minimax model" : "");
}

std::string engine_text(Engine searched_in) {
  return searched_in == Engine::kSimbody ? "simbody" : fmt::format("{}, then simbody", name(searched_in));
}

std::string robust_text(const Study& study) {
  if (!study.robust) return {};
  return fmt::format(" ({} of {} arms in each scenario)",
                     risk_measure_names()[static_cast<std::size_t>(study.robust->measure)],
                     arms(*study.robust));
}

std::string budget_text(long max_evaluations, double max_minutes) {
  return fmt::format("{} evaluations{}", max_evaluations,
                     max_minutes > 0.0 ? fmt::format(" or {} minutes", max_minutes) : "");
}

double seconds_left(long evaluations, long max_evaluations, double seconds, double max_minutes) {
  const double by_evaluations =
      seconds / static_cast<double>(evaluations) * static_cast<double>(max_evaluations - evaluations);
  if (max_minutes <= 0.0) return by_evaluations;
  return std::min(by_evaluations, std::max(0.0, 60.0 * max_minutes - seconds));
}

std::vector<std::string> files_of(const Study& study) {
  std::vector<std::string> files = {study.source};
  if (!study.gains.empty()) {
    for (std::string& file : files_of_gains(study.gains)) files.push_back(std::move(file));
  }
  if (study.warm) files.push_back(study.warm->source);
  for (std::string& file : inputs_of(study)) files.push_back(std::move(file));
  return files;
}

std::vector<std::pair<std::string, std::string>> identity_of(const Study& study) {
  const std::string warm = study.warm ? kWarmGains : "";
  std::vector<std::pair<std::string, std::string>> identity = {
      {"seed", fmt::format("{}", study.solver.seed)},
      {"study", study_yaml(study, "start/gains.yaml", warm)},
      {"start gains", gains_yaml(study.space.start, {})}};
  if (study.warm) identity.emplace_back("warm gains", gains_yaml(study.warm->gains, {}));
  return identity;
}

std::vector<std::string> inputs_of(const Study& study) {
  std::vector<std::string> inputs;
  add_inputs(study.scenarios, inputs);
  if (study.robust) add_distribution(study.robust->perturbation, inputs);
  return inputs;
}

RunRecord record_of_search(const Study& study, const Invocation& invocation, int workers, double seconds) {
  RunRecord run;
  run.command = invocation.line;
  run.wall_seconds = seconds;
  run.seed = study.solver.seed;
  run.workers = workers;
  SearchFacts& search = run.search.emplace();
  search.study = shown_path(study.source);
  search.start = study.given ? "armtune's first gains" : stem(study.gains);
  search.stepper = study.stepper;
  if (study.robust) run.distribution = distribution_facts(study.robust->perturbation);
  return run;
}

void write_start(const Study& study, const std::string& folder) {
  make_folder(folder + "/start");
  write_text_file(
      folder + "/start/gains.yaml",
      gains_yaml(study.space.start,
                 {study.given ? "start gains that armtune computed for " + shown_path(study.source)
                              : "start gains of " + shown_path(study.source)}));
  if (study.given) {
    make_folder(folder + "/given");
    write_text_file(folder + "/" + kGivenGains,
                    gains_yaml(*study.given, {"start gains that " + shown_path(study.source) + " gives",
                                              study.given_failure}));
  }
  write_text_file(folder + "/study.yaml", study_yaml(study, "start/gains.yaml", write_warm(study, folder)));
}

std::string write_warm(const Study& study, const std::string& folder) {
  if (!study.warm) return {};
  std::string file = kWarmGains;
  const std::string path = folder + "/" + file;
  std::error_code none;
  // A resumed run reads the gains from this file. It is not written again, so that it keeps its comment on
  // where they came from.
  if (std::filesystem::equivalent(path, study.warm->source, none)) return file;
  make_folder(folder + "/start");
  write_text_file(path,
                  gains_yaml(study.warm->gains, {"warm start, from " + shown_path(study.warm->source)}));
  return file;
}

void warn_of_clamped(const Study& study, SessionObserver& observer) {
  if (!study.warm) return;
  for (const std::string& line : warm_point(study.space, *study.warm).clamped) observer.warned(line);
}

std::string given_note(const Study& study) {
  if (!study.given) return {};
  return fmt::format(
      "the start gains of the study cannot be a reference ({}). The objective needs one, so armtune computed "
      "other start gains, which are named 'start' in the results. The study's own start gains are named "
      "'given'",
      study.given_failure);
}

void warn_of_given(const Study& study, SessionObserver& observer) {
  if (study.given) observer.warned(given_note(study));
}

void write_sensitivity(const Study& study, const Sensitivity& sensitivity, const std::string& folder) {
  write_text_file(folder + "/sensitivity.csv", sensitivity_csv(study, sensitivity));
  write_text_file(folder + "/reduced_study.yaml",
                  study_yaml(without_less_important_half(study, sensitivity), "start/gains.yaml"));
}

}  // namespace armtune::internal
