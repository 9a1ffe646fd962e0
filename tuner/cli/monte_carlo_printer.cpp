#include "tuner/cli/monte_carlo_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "tuner/cli/commands.hpp"
#include "tuner/cli/conclusion.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/rollouts/comparison.hpp"
#include "tuner/samples/statistics.hpp"

namespace armtune::internal::cli {
namespace {

void print_yield(const std::vector<Scenario>& scenarios, const std::vector<MonteCarloSample>& samples,
                 const std::vector<MetricLimit>& limits) {
  const auto kept = static_cast<std::size_t>(
      std::count_if(samples.begin(), samples.end(), [](const MonteCarloSample& s) { return s.keeps_all(); }));
  const auto [low, high] = wilson_interval(kept, samples.size());
  say(fmt::format("{:.1f} % of {} random arms keep every limit (95 % confidence: {:.1f} .. {:.1f} %):\n",
                  100.0 * static_cast<double>(kept) / static_cast<double>(samples.size()), samples.size(),
                  100.0 * low, 100.0 * high));
  for (const MetricLimit& limit : limits) say(fmt::format("  {}\n", to_string(limit)));
  say(fmt::format("  torque saturated in at most {:.0f} % of the control periods\n",
                  100.0 * kSaturatedShare));
  std::map<std::pair<std::string, std::string>, std::vector<std::uint64_t>> breaks;
  for (const MonteCarloSample& sample : samples) {
    for (std::size_t s = 0; s < scenarios.size(); ++s) {
      if (!sample.broken[s].text.empty())
        breaks[{scenarios[s].name, sample.broken[s].text}].push_back(sample.number);
    }
  }
  constexpr std::size_t kShown = 8;
  for (const auto& [what, numbers] : breaks) {
    say(fmt::format(
        "{}: {} of {} random arms break '{}': sample numbers {}{}\n", what.first, numbers.size(),
        samples.size(), what.second,
        fmt::join(numbers.begin(),
                  numbers.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, numbers.size())), " "),
        numbers.size() > kShown ? " ..." : ""));
  }
}

void print_spreads(const std::vector<Scenario>& scenarios, const std::vector<MonteCarloSample>& samples) {
  const auto& headline = headline_metrics();
  for (std::size_t s = 0; s < scenarios.size(); ++s) {
    say(fmt::format("\n{:<36}{:>9}{:>9}{:>9}{:>9}{:>8}\n", scenarios[s].name, "median", "95 %", "99 %",
                    "worst", "sample"));
    for (const MetricSpread& spread : spreads(samples, s)) {
      if (std::find(headline.begin(), headline.end(), spread.metric) == headline.end()) continue;
      const MetricField& f = field(spread.metric);
      say(fmt::format("{:<36}{:>9.3g}{:>9.3g}{:>9.3g}{:>9.3g}{:>8}\n",
                      fmt::format("  {} [{}]", f.name, f.unit), spread.median, spread.p95, spread.p99,
                      spread.worst, spread.worst_sample));
    }
  }
}

}  // namespace

void MonteCarloPrinter::resumed(std::size_t recalled) {
  say(fmt::format("resuming after {} finished random arms\n", recalled));
}

int MonteCarloPrinter::ended(const MonteCarloOutcome& outcome) const {
  const std::string& folder = settings_.place.folder;
  if (outcome.was_finished) {
    say(fmt::format("{}: this run is finished; there is nothing to resume\n", folder));
    return static_cast<int>(outcome.ending);
  }
  if (!outcome.samples.empty()) {
    print_yield(settings_.scenarios, outcome.samples, settings_.options.limits);
    print_spreads(settings_.scenarios, outcome.samples);
  }
  if (!folder.empty()) {
    say(fmt::format("\nwrote {}: {}{}\n", folder, fmt::join(outcome.files, ", "),
                    outcome.recorded ? "; recordings of the nominal arm are in nominal/" : ""));
  }
  if (outcome.ending != Ending::kInterrupted) return conclude(outcome.verdict);
  if (!folder.empty())
    say(fmt::format("interrupted; to resume: {} robustness --resume {}\n", program_name(), folder));
  return kInterrupted;
}

}  // namespace armtune::internal::cli
