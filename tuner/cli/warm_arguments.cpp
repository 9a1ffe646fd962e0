#include "tuner/cli/warm_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "armtune/error.hpp"
#include "tuner/session/study_files.hpp"

namespace armtune::internal::cli {

void add_warm_options(CLI::App& command, WarmArguments& args) {
  command.add_option("--warm-start", args.from,
                     "run folder or gains file with the gains from which the search starts. The objective "
                     "stays relative to the study's start gains");
  command
      .add_option("--warm-parameters", args.parameters,
                  "gains to take from --warm-start, such as task_space_gains_p or task_space_gains_p/x; "
                  "all other gains start at the study's start gains")
      ->default_str("all tuned gains");
  command
      .add_option(
          "--warm-box", args.box,
          "width of the region that is searched around the warm start, as a share of each gain's range")
      ->default_str("1, the whole range")
      ->check(CLI::Range(1e-6, 1.0));
  command
      .add_option("--warm-step", args.step,
                  "initial step of the search from a warm start, as a share of each gain's range")
      ->default_str("the step of the study, multiplied by the value of --warm-box")
      ->check(CLI::Range(1e-6, 0.5));
}

void apply(WarmArguments args, const RunPlace& place, Study& study) {
  if (place.resume && !args.from.empty()) args.from = place.folder + "/" + kWarmGains;
  const bool refined = !args.parameters.empty() || args.box > 0.0 || args.step > 0.0;
  if (args.from.empty() && !refined) return;
  if (args.from.empty() && !study.warm) {
    throw InputError(InputPlace{study.source},
                     "--warm-parameters, --warm-box and --warm-step need a warm start, and the study "
                     "has none; give --warm-start too");
  }
  WarmStart warm = study.warm.value_or(WarmStart{});
  if (!args.from.empty())
    load_warm_gains(warm, args.from, study.space, joint_names(*study.scenarios.front().robot));
  if (!args.parameters.empty()) warm.parameters = args.parameters;
  if (args.box > 0.0) warm.box = args.box;
  if (args.step > 0.0) warm.step = args.step;
  try {
    warm_point(study.space, warm);
  } catch (const InputError& e) {
    throw InputError(fmt::format("--warm-parameters: {}", e.what()));
  }
  study.warm = std::move(warm);
}

}  // namespace armtune::internal::cli
