#include "armtune/robustness.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "sim/scenario/arm_distribution.hpp"
#include "tuner/interface/kept_inputs.hpp"
#include "tuner/interface/observing.hpp"
#include "tuner/interface/rollout_maker.hpp"
#include "tuner/session/margins_session.hpp"
#include "tuner/session/monte_carlo_session.hpp"

namespace armtune {
namespace {

internal::Perturbation perturbation_of(const RobustnessOptions& options,
                                       const std::vector<internal::Scenario>& scenarios) {
  internal::Perturbation perturbation = internal::default_perturbation(scenarios);
  if (!options.distribution.empty())
    draw_from(internal::load_arm_distribution(options.distribution, scenarios), perturbation);
  for (const auto& given : options.perturbation) {
    const auto fields = internal::perturbation_fields();
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const auto& field) { return field.name == given.first; });
    if (found == fields.end()) {
      std::vector<std::string> known;
      for (const auto& field : fields) known.emplace_back(field.name);
      const std::string names = fmt::format("{}", fmt::join(known, ", "));
      throw InputError(
          InputPlace{.key = "perturbation"},
          fmt::format("{} cannot be varied; give one or more of: {}", internal::shown(given.first), names))
          .with_value(given.first, fmt::format("one of: {}", names));
    }
    perturbation.*found->width = given.second;
  }
  return perturbation;
}

}  // namespace

bool RobustnessSample::keeps_all() const {
  return std::all_of(broken.begin(), broken.end(), [](const std::string& limit) { return limit.empty(); });
}

double Robustness::yield() const {
  if (samples.empty()) return NAN;
  const auto kept =
      std::count_if(samples.begin(), samples.end(), [](const auto& sample) { return sample.keeps_all(); });
  return static_cast<double>(kept) / static_cast<double>(samples.size());
}

Robustness robustness(const std::vector<Scenario>& scenarios, const Gains& gains,
                      const RobustnessOptions& options) {
  require_workers(options.workers);
  require_fit(gains, scenarios);
  constexpr std::uint64_t kMost = 1'000'000;
  if (options.samples < 1 || options.samples > kMost) {
    throw InputError(InputPlace{.key = "samples"},
                     fmt::format("{}; it must lie between 1 and {}", options.samples, kMost))
        .with_value(std::to_string(options.samples), fmt::format("1 to {}", kMost));
  }
  const KeptInputs inputs(options.folder, files_of(scenarios), "a scenario that was changed");
  internal::MonteCarloSettings settings;
  settings.place = {options.folder, options.resume};
  settings.scenarios = internal_of(scenarios);
  settings.gains = gains.inside();
  settings.deadline = options.deadline;
  settings.options.samples = options.samples;
  settings.options.seed = options.seed;
  settings.options.engine = internal_of(options.engine);
  settings.options.workers = options.workers;
  settings.options.perturbation = perturbation_of(options, settings.scenarios);
  Observing<internal::MonteCarloObserver> observer(options.watch);
  internal::RankGroup alone(nullptr);
  internal::MonteCarloSession session(std::move(settings), context_of(options.watch), observer);
  const internal::MonteCarloOutcome outcome = session.run(alone).value();
  if (outcome.was_finished)
    throw InputError(InputPlace{options.folder}, "this run is finished; there is nothing to resume");

  Robustness found;
  found.verdict = outcome.verdict;
  found.interrupted = outcome.ending == internal::Ending::kInterrupted;
  found.files = outcome.files;
  for (const internal::MonteCarloSample& sample : outcome.samples) {
    RobustnessSample& given = found.samples.emplace_back();
    given.number = sample.number;
    for (const internal::RolloutFailure& failure : sample.broken) given.broken.push_back(failure.text);
    for (std::size_t s = 0; s < sample.results.size(); ++s) {
      given.rollouts.push_back(RolloutMaker::made({scenarios[s].name(), sample.results[s]}));
    }
  }
  return found;
}

Margins margins(const std::vector<Scenario>& scenarios, const Gains& gains, const MarginsOptions& options) {
  require_workers(options.workers);
  require_fit(gains, scenarios);
  const KeptInputs inputs(options.folder, files_of(scenarios), "a scenario that was changed");
  internal::MarginsSettings settings;
  settings.folder = options.folder;
  settings.scenarios = internal_of(scenarios);
  settings.gains = gains.inside();
  settings.options.engine = internal_of(options.engine);
  settings.options.workers = options.workers;
  Observing<internal::SessionObserver> observer(options.watch);
  internal::MarginsSession session(std::move(settings), context_of(options.watch), observer);
  const internal::MarginsOutcome outcome = session.run();

  Margins found;
  found.verdict = outcome.verdict;
  found.interrupted = outcome.ending == internal::Ending::kInterrupted;
  found.files = outcome.files;
  for (const internal::Margin& margin : outcome.margins) {
    const internal::MarginField& field = internal::field(margin.kind);
    found.margins.push_back({field.name, field.unit, margin.scenario, margin.nominal, margin.stands,
                             margin.fails, margin.reason});
  }
  return found;
}

}  // namespace armtune
