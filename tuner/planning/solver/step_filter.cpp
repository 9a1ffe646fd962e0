#include "tuner/planning/solver/step_filter.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

constexpr double kAccept = 1e-4;           // least accepted share of the predicted decrease
constexpr double kSubproblemNoise = 1e-8;  // error due to the subproblem's tolerance, relative to the merit
constexpr double kElastic = 1e-6;          // largest violation of a linearised row that counts as none
constexpr double kMargin = 1e-5;
constexpr double kWorth = 1e3;  // violation that is accepted for a predicted decrease of 1

}  // namespace

void StepFilter::allow(double largest) {
  largest_allowed_ = std::max(largest_allowed_, largest);
}

bool StepFilter::accepts(const Judged& before, const Judged& model, const Judged& after, double part,
                         double price) {
  if (!std::isfinite(after.objective) || !std::isfinite(after.violation) || after.largest > largest_allowed_)
    return false;
  const double noise = 1e-12 * std::max(1.0, std::abs(before.objective));
  if (model.largest > kElastic) {
    // Even the subproblem violates rows. It minimises the objective plus the price of the violations.
    const auto merit = [&](const Judged& at) { return at.objective + price * at.violation; };
    const double promised = part * (merit(before) - merit(model));
    return merit(after) <= merit(before) - kAccept * promised + kSubproblemNoise * std::abs(merit(before));
  }
  const auto better = [&](const Judged& than) {
    return after.violation <= (1.0 - kMargin) * than.violation || after.violation <= 1e-11 ||
           after.objective <= than.objective - kMargin * than.violation;
  };
  for (const Judged& remembered : remembered_) {
    if (!better(remembered)) return false;
  }
  const double promised = part * (before.objective - model.objective);
  const double worth = kWorth * std::max(0.0, promised);
  if (after.largest > std::max({2.0 * before.largest, 1e-7, worth})) return false;
  if (promised > noise && promised > before.violation) {
    return after.objective <= before.objective - kAccept * promised + noise;
  }
  if (!better(before) && after.violation > before.violation + 1e-11) return false;
  remembered_.push_back(before);
  return true;
}

}  // namespace armtune::internal
