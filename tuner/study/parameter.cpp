#include "tuner/study/parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {
namespace {

/// Largest ratio of the bounds on a log scale.
constexpr double kWidestSpan = 1e30;

double to_coordinate(const Parameter& p, double v) {
  const double x = p.scale == Scale::kLog ? std::log(v / p.lower) / std::log(p.upper / p.lower)
                                          : (v - p.lower) / (p.upper - p.lower);
  return std::clamp(x, 0.0, 1.0);
}

double from_coordinate(const Parameter& p, double coordinate) {
  if (coordinate == to_coordinate(p, p.start)) return p.start;  // bit-identical: not rounded by exp or log
  const double x = std::clamp(coordinate, 0.0, 1.0);
  const double v =
      p.scale == Scale::kLog ? p.lower * std::pow(p.upper / p.lower, x) : p.lower + x * (p.upper - p.lower);
  return std::clamp(v, p.lower, p.upper);
}

}  // namespace

std::vector<GainEntry> gain_entries(const Gains& gains, const std::vector<std::string>& joints) {
  std::vector<GainEntry> entries;
  for (const GainField& field : fields_of(gains)) {
    const std::size_t count = numbers(gains, field).size();
    if (count == 0) continue;
    const auto components = component_names(gains, field, joints);
    for (std::size_t i = 0; i < components.size(); ++i) {
      entries.push_back(
          {&field, i, count, components[i].empty() ? field.name : field.name + ("/" + components[i])});
    }
  }
  return entries;
}

bool is_named(const GainEntry& entry, const std::string& name) {
  return entry.name == name || entry.name.starts_with(name + "/");
}

bool has(const Gains& gains, const GainEntry& entry) {
  return numbers(gains, *entry.field).size() == entry.count;
}

double& value(Gains& gains, const GainEntry& entry) {
  return numbers(gains, *entry.field)[entry.component];
}
double value(const Gains& gains, const GainEntry& entry) {
  return numbers(gains, *entry.field)[entry.component];
}

bool on_bound(const Parameter& parameter, double value) {
  constexpr double kRounding = 1e-9;
  return value <= parameter.lower * (1.0 + kRounding) || value >= parameter.upper * (1.0 - kRounding);
}

std::vector<double> ParameterSpace::start_point() const {
  std::vector<double> x;
  for (const Parameter& p : free) x.push_back(to_coordinate(p, p.start));
  return x;
}

Gains ParameterSpace::gains_at(const std::vector<double>& x) const {
  Gains gains = start;
  for (std::size_t i = 0; i < free.size(); ++i) value(gains, free[i].entry) = from_coordinate(free[i], x[i]);
  for (const Link& link : links) {
    value(gains, link.entry) = link.factor * value(gains, free[link.parameter].entry);
  }
  return gains;
}

std::vector<double> ParameterSpace::point_of(const Gains& gains) const {
  std::vector<double> x;
  for (const Parameter& p : free) x.push_back(to_coordinate(p, value(gains, p.entry)));
  return x;
}

void validate(const ParameterSpace& space, const std::string& where) {
  if (space.free.empty())
    throw InputError(
        InputPlace{where, 0, "parameters"},
        "no parameter to tune; list some under 'parameters'. If the study has no such list, armtune tunes "
        "the gains that act in its scenarios, but " +
            space.start.controller + " has none: choose another controller");
  for (const Parameter& p : space.free) {
    const auto fail = [&](const std::string& what, std::optional<double> given = {},
                          const std::string& limit = {}) {
      throw InputError(InputPlace{where, 0, p.entry.name},
                       fmt::format("parameter {}: {}", p.entry.name, what))
          .with_value(given ? fmt::to_string(*given) : "", limit);
    };
    if (p.lower == 0.0 && p.upper == 0.0) {
      fail(
          "its start value is 0, and its default bounds are multiples of this value; give 'lower' and "
          "'upper', or remove the parameter",
          p.start, "above zero, or with bounds");
    }
    if (p.lower == p.upper) {
      fail(fmt::format("both bounds are {0}; give a range, or fix the value with 'fixed: {0}'", p.lower),
           p.lower, fmt::format("below the upper bound {}", p.upper));
    }
    if (!std::isfinite(p.lower) || !std::isfinite(p.upper) || p.lower > p.upper) {
      fail(fmt::format("lower bound {} is not below upper bound {}", p.lower, p.upper),
           std::isfinite(p.upper) ? p.lower : p.upper,
           std::isfinite(p.upper) ? fmt::format("below the upper bound {}", p.upper) : "finite");
    }
    if (p.lower < 0.0)
      fail(fmt::format("lower bound {} is negative; a gain must not be negative", p.lower), p.lower,
           "not negative");
    if (p.scale == Scale::kLog && p.lower <= 0.0) {
      fail(fmt::format("lower bound {} does not fit a log scale; give a bound above zero, or 'scale: linear'",
                       p.lower),
           p.lower, "above zero");
    }
    if (p.scale == Scale::kLog && !(p.upper / p.lower <= kWidestSpan)) {
      fail(fmt::format("its bounds {} .. {} span more than a factor of {:.0e}, too much for a log scale; "
                       "raise the lower bound, or give 'scale: linear'",
                       p.lower, p.upper, kWidestSpan),
           p.lower, fmt::format("a factor of at most {:.0e} below the upper bound {}", kWidestSpan, p.upper));
    }
    if (!(p.start >= p.lower && p.start <= p.upper)) {
      fail(fmt::format(
               "start {} lies outside its bounds {} .. {}; give a 'start' between them, or other bounds",
               p.start, p.lower, p.upper),
           p.start, fmt::format("{} to {}", p.lower, p.upper));
    }
  }
}

}  // namespace armtune::internal
