#include "tuner/derivatives/rollout_difference.hpp"

#include <algorithm>
#include <cmath>

#include "tuner/derivatives/settling.hpp"

namespace armtune::internal {
namespace {

/// The bits of a period after whose difference the rollouts are no longer close to each other.
constexpr PeriodMode kJumps = kModeState | kModeSlerping | kModeTarget;

/// Adds the quotient to the gradient, or the gain to those without a derivative.
void set_quotient(int gain, const std::optional<double>& quotient, Eigen::VectorXd& gradient,
                  std::vector<int>& missing) {
  gradient[gain] = quotient.value_or(0.0);
  if (!quotient) missing.push_back(gain);
}

}  // namespace

MetricShape shape_of(Metric metric) {
  const std::optional<SeriesKind> kind = series_kind(metric);
  if (!kind) return MetricShape::kOther;
  switch (*kind) {
    case SeriesKind::kLargest:
      return MetricShape::kLargest;
    case SeriesKind::kSmallest:
      return MetricShape::kSmallest;
    case SeriesKind::kRms:
      return MetricShape::kRms;
    case SeriesKind::kOutside:
      return MetricShape::kTime;
  }
  return MetricShape::kOther;
}

RolloutDifference::RolloutDifference(const RolloutResult& base, const RolloutResult& copy, double step)
    : base_(base),
      copy_(copy),
      step_(step),
      end_(std::min(base.series.modes.size(), copy.series.modes.size())),
      jump_(0) {
  while (jump_ < end_ && ((base.series.modes[jump_] ^ copy.series.modes[jump_]) & kJumps) == 0) ++jump_;
}

bool RolloutDifference::exists_at(std::size_t period) const {
  return period < jump_ && base_.series.modes[period] == copy_.series.modes[period];
}

RolloutDifference::Quotient RolloutDifference::quotient(double base, double copy) const {
  const double q = (copy - base) / step_;
  return std::isfinite(q) ? Quotient(q) : std::nullopt;
}

RolloutDifference::Quotient RolloutDifference::of_sample(const MetricDerivative& derivative,
                                                         const SampleRow& row) const {
  const MetricSeries* copy = copy_.series.find(derivative.use.metric);
  if (copy == nullptr || !exists_at(row.period)) return std::nullopt;
  return quotient(row.value, copy->at(row.period, static_cast<std::size_t>(row.channel)));
}

// With s_k the value of period k, rms^2 is proportional to the sum of s_k^2. Hence d rms = rms (sum of s_k
// ds_k) / (sum of s_k^2), however often a period counts.
RolloutDifference::Quotient RolloutDifference::of_rms(const MetricDerivative& derivative) const {
  const MetricSeries* base = base_.series.find(derivative.use.metric);
  const MetricSeries* copy = copy_.series.find(derivative.use.metric);
  if (base == nullptr || copy == nullptr || std::isnan(derivative.value)) return std::nullopt;
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < base->periods(); ++k) {
    const double s = base->at(k);
    const double there = k < jump_ ? copy->at(k) : NAN;
    if (std::isnan(s) && std::isnan(there)) continue;
    if (std::isnan(s) || std::isnan(there)) return std::nullopt;
    products += s * (there - s);
    squares += s * s;
  }
  return squares > 0.0 ? Quotient(derivative.value * products / squares / step_) : Quotient(0.0);
}

RolloutDifference::Quotient RolloutDifference::of_time(const MetricDerivative& derivative) const {
  const MetricSeries* base = base_.series.find(derivative.use.metric);
  const MetricSeries* copy = copy_.series.find(derivative.use.metric);
  if (base == nullptr || copy == nullptr) return std::nullopt;
  const std::optional<Settling> here = longest_settling(base_.series, *base);
  // The metric counts whole periods. A larger difference means that it measures from another event.
  const double rounding = 1.5 * base_.series.period;
  if (!here || !(std::abs(here->time - derivative.value) <= rounding)) return std::nullopt;
  if (here->period >= jump_ && jump_ < base_.series.modes.size()) return std::nullopt;
  const Settling there = settling_after(copy_.series, *copy, here->event);
  const std::size_t apart = std::max(here->period, there.period) - std::min(here->period, there.period);
  return apart <= 1 ? quotient(here->time, there.time) : std::nullopt;
}

RolloutDifference::Quotient RolloutDifference::of_whole(const MetricDerivative& derivative) const {
  if (jump_ < base_.series.modes.size()) return std::nullopt;
  return quotient(derivative.value, copy_.metrics[derivative.use.metric]);
}

void RolloutDifference::differentiate(int gain, MetricDerivative& derivative) const {
  for (SampleRow& row : derivative.rows)
    set_quotient(gain, of_sample(derivative, row), row.gradient, row.missing);
  const auto whole = [&]() -> Quotient {
    switch (derivative.shape) {
      case MetricShape::kRms:
        return of_rms(derivative);
      case MetricShape::kTime:
        return of_time(derivative);
      case MetricShape::kOther:
        return of_whole(derivative);
      default:
        return derivative.rows.empty() ? std::nullopt : of_sample(derivative, derivative.rows.front());
    }
  };
  set_quotient(gain, whole(), derivative.gradient, derivative.missing);
}

EventCause RolloutDifference::cause_at(std::size_t period) const {
  if (period >= end_) return EventCause::kEnd;
  const PeriodMode differs = base_.series.modes[period] ^ copy_.series.modes[period];
  if ((differs & (kModeState | kModeTarget)) != 0) return EventCause::kState;
  if ((differs & kModeSlerping) != 0) return EventCause::kSlerp;
  if ((differs & kModeSaturated) != 0) return EventCause::kSaturation;
  return (differs & kModeDamped) != 0 ? EventCause::kDampedInverse : EventCause::kSlowedReference;
}

std::vector<MissingInterval> RolloutDifference::missing() const {
  std::vector<MissingInterval> intervals;
  const std::size_t periods = base_.series.modes.size();
  bool open = false;
  for (std::size_t k = 0; k < periods && k <= jump_; ++k) {
    const bool exists = exists_at(k);
    if (!exists && (!open || cause_at(k) != intervals.back().cause)) {
      intervals.push_back({});
      intervals.back().begin = base_.series.time(k);
      intervals.back().cause = cause_at(k);
    }
    open = !exists;
    if (open) intervals.back().end = base_.series.time(k == jump_ ? periods : k + 1);
  }
  return intervals;
}

}  // namespace armtune::internal
