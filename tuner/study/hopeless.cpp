#include "tuner/study/hopeless.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace armtune::internal {
namespace {

/// Factor on the study's velocity limit, which lies below the limit of the drives. At twice the study's
/// limit, no gain set is near a good one.
constexpr double kVelocityFactor = 2.0;
/// A joint this far beyond its position limit [rad, m] would have hit its mechanical stop.
constexpr double kMarginBeyond = 0.1;

std::vector<std::string> names_of_those_that_can(bool upper) {
  std::vector<std::string> names;
  for (const Metric m : all_metrics()) {
    if (can_be_hopeless(m, upper)) names.emplace_back(name(m));
  }
  return names;
}

}  // namespace

bool can_be_hopeless(Metric metric, bool upper) {
  return only_worsens(metric) && upper != larger_is_better(metric);
}

std::optional<double> default_hopeless(Metric metric, bool upper, double limit) {
  if (!can_be_hopeless(metric, upper)) return std::nullopt;
  if (metric == Metric::kJointVelocityMaxRatio) return kVelocityFactor * limit;
  if (metric == Metric::kJointPositionMinMargin) return limit - kMarginBeyond;
  return std::nullopt;
}

Hopeless read_hopeless(const yaml::Node* node, Metric metric, bool upper, std::optional<double> limit) {
  if (node == nullptr || node->is_word("auto")) return {};
  if (node->is_word("never")) return {Hopeless::Kind::kNever, 0.0};
  const double value = node->as_number();
  const char* bound = upper ? "at_most" : "at_least";
  if (!can_be_hopeless(metric, upper)) {
    const std::string usable = fmt::format("{}", fmt::join(names_of_those_that_can(upper), ", "));
    node->fail(fmt::format(
                   "'hopeless' cannot be used for {} with '{}', because a rollout that violates the limit "
                   "early can still keep it at the end; leave the key out. With '{}', 'hopeless' can be used "
                   "for: {}",
                   name(metric), bound, bound, usable),
               fmt::format("never or auto; a number only for: {}", usable));
  }
  if (limit && (upper ? value <= *limit : value >= *limit)) {
    const char* beyond = upper ? "above" : "below";
    node->fail(fmt::format("{} does not lie beyond the limit ({} {}); give a value {} this limit, or 'never'",
                           value, bound, *limit, beyond),
               fmt::format("{} {}, or never", beyond, *limit));
  }
  return {Hopeless::Kind::kFrom, value};
}

std::string hopeless_text(const Hopeless& hopeless) {
  switch (hopeless.kind) {
    case Hopeless::Kind::kAuto:
      return "auto";
    case Hopeless::Kind::kNever:
      return "never";
    case Hopeless::Kind::kFrom:
      return fmt::format("{}", hopeless.value);
  }
  return "";
}

}  // namespace armtune::internal
