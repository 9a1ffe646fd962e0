#include "sim/scenario/stimulus_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "sim/yaml/map_reader.hpp"
#include "sim/yaml/source_text.hpp"

namespace armtune::internal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostOrders = 32;
constexpr long kMostPeriods = 1000;

/// Reads an offset [m], which must not be zero.
Vec3 read_offset(const yaml::Node& node) {
  Vec3 offset(node.as_numbers(3).data());
  const double length = offset.norm();
  if (!std::isfinite(length) || !(length > 0.0))
    node.fail("the length of this vector must be finite and above zero", "finite and above zero");
  return offset;
}

Step read_step(const yaml::Node& node, double duration, double control_period, Vec3& direction) {
  yaml::MapReader map(node);
  const Vec3 offset = read_offset(map.required("offset"));
  const yaml::Node& at = map.required("at");
  const Step step{offset.norm(), at.as_number()};
  if (step.at < 0.0 || step.at > duration - control_period) {
    at.fail(
        fmt::format(
            "the step is at {} s; it must lie in 0 .. {} s, which is one control period before the end of the "
            "scenario",
            step.at, duration - control_period),
        fmt::format("0 to {} s", duration - control_period));
  }
  map.finish();
  direction = offset / step.size;
  return step;
}

std::vector<int> read_orders(const yaml::Node& node, double base_period, double control_period) {
  std::vector<int> orders;
  orders.reserve(kMostOrders);
  const double limit = 0.5 * base_period / control_period;
  for (const yaml::Node& item : node.items()) {
    if (orders.size() == kMostOrders)
      node.fail(fmt::format("the list has more than {} orders; give fewer", kMostOrders),
                fmt::format("at most {} orders", kMostOrders));
    const long order = item.as_integer();
    const long least = orders.empty() ? 1 : orders.back() + 1;
    if (order < least)
      item.fail(
          fmt::format("the harmonic order {} is not allowed here; orders must be at least 1 and increase",
                      order),
          fmt::format("at least {}", least));
    if (static_cast<double>(order) >= limit) {
      item.fail(
          fmt::format(
              "the order {} is too high; with a base period of {} s it must be below {:.6g}, so that the "
              "frequency is below half the control rate",
              order, base_period, limit),
          fmt::format("below {:.6g}", limit));
    }
    orders.push_back(static_cast<int>(order));
  }
  if (orders.empty()) node.fail("the list is empty; give at least one order", "at least one order");
  return orders;
}

double read_base_period(const yaml::Node& node, double duration, double control_period) {
  const double period = node.as_number();
  if (!(period >= control_period) || period > duration) {
    node.fail(fmt::format("the base period is {} s; it must lie between the control period of {} s and the "
                          "duration of {} s",
                          period, control_period, duration),
              fmt::format("{} to {} s", control_period, duration));
  }
  // Otherwise the Fourier sums over whole base periods would leak into each other.
  const double samples = period / control_period;
  constexpr double kRounding = 1e-6;
  if (std::abs(samples - std::round(samples)) > kRounding) {
    node.fail(InputFault{.problem = fmt::format("the base period is {} s", period),
                         .limit = fmt::format("a whole number of control periods of {} s", control_period)});
  }
  return period;
}

Multisine read_sines(const yaml::Node& node, double duration, double control_period, Vec3& direction) {
  yaml::MapReader map(node);
  direction = read_offset(map.required("direction")).normalized();
  Multisine sines;
  const yaml::Node& amplitude = map.required("amplitude");
  sines.amplitude = amplitude.as_number();
  if (!(sines.amplitude > 0.0))
    amplitude.fail(
        InputFault{.problem = fmt::format("the amplitude is {} m", sines.amplitude), .limit = "above 0"});
  sines.base_period = read_base_period(map.required("base_period"), duration, control_period);
  sines.orders = read_orders(map.required("orders"), sines.base_period, control_period);
  sines.phases = schroeder_phases(sines.orders);
  map.required("from");
  sines.from = map.number_in("from", 0.0, 0.0, kInfinity);
  const long periods = map.integer("periods", 1);
  if (periods < 1 || periods > kMostPeriods) {
    map.required("periods").fail(
        InputFault{.problem = fmt::format("the number of base periods is {}", periods),
                   .limit = fmt::format("1 to {}", kMostPeriods)});
  }
  sines.periods = static_cast<int>(periods);
  if (!reached(duration, sines.window_end())) {
    const std::string problem = fmt::format(
        "the measurement begins at {} s and takes one base period for transients and {} further ones, so it "
        "would end at {} s, but the scenario lasts only {} s; reduce 'from' or 'periods', or increase the "
        "duration",
        sines.from, periods, sines.window_end(), duration);
    throw yaml::error_at(node.file(), node.line(), node.key_path(), {.problem = problem})
        .with_value(fmt::to_string(sines.window_end()), fmt::format("an end at {} s or before", duration));
  }
  map.finish();
  return sines;
}

}  // namespace

Stimulus read_stimulus(const yaml::Node& node, double duration, double control_period) {
  yaml::MapReader map(node);
  Stimulus stimulus;
  const yaml::Node& on = map.required("on");
  const std::string place = on.as_string();
  if (place != "path" && place != "target") on.fail_choice({"path", "target"});
  stimulus.on = place == "path" ? Stimulus::On::kPath : Stimulus::On::kTarget;
  const yaml::Node* step = map.optional("step");
  const yaml::Node* sines = map.optional("sines");
  map.finish();
  if ((step == nullptr) == (sines == nullptr)) node.fail("give one of: step, sines", "one of: step, sines");
  if (step != nullptr) {
    stimulus.shape = read_step(*step, duration, control_period, stimulus.direction);
  } else {
    stimulus.shape = read_sines(*sines, duration, control_period, stimulus.direction);
  }
  return stimulus;
}

}  // namespace armtune::internal
