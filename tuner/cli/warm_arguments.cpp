#include "tuner/cli/warm_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "armtune/error.hpp"

namespace armtune::internal::cli {

void add_warm_options(CLI::App& command, WarmArguments& args) {
  command.add_option("--warm-start", args.from,
                     "run folder or gains file where the search begins; the objective stays relative to the "
                     "study's start gains");
  command.add_option("--warm-parameters", args.parameters,
                     "gains or fields taken from there, the others from the start (default: all tuned ones)");
  command
      .add_option(
          "--warm-box", args.box,
          "search only this part of each parameter's range, around that point (default: 1, all of it)")
      ->check(CLI::Range(1e-6, 1.0));
  command
      .add_option("--warm-step", args.step,
                  "initial step there, of the range (default: the study's, times the box)")
      ->check(CLI::Range(1e-6, 0.5));
}

void apply(const WarmArguments& args, Study& study) {
  const bool refined = !args.parameters.empty() || args.box > 0.0 || args.step > 0.0;
  if (args.from.empty() && !refined) return;
  if (args.from.empty() && !study.warm) {
    throw InputError(
        fmt::format("{}: no warm start for --warm-parameters, --warm-box or --warm-step to refine; give "
                    "--warm-start too",
                    study.source));
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
