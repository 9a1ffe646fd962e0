#include "tuner/controller_study/controller_rate.hpp"

#include <fmt/format.h>

#include <charconv>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"

namespace armtune::internal {
namespace {

using yaml::PlacedValue;

constexpr double kSlowest = 10.0;     // Hz
constexpr double kFastest = 10000.0;  // Hz
constexpr const char* kRos2Parameters = "ros__parameters";
constexpr const char* kRos2Rate = "update_rate";
constexpr const char* kRos1Rate = "loop_hz";

double number(const PlacedValue& value) {
  double found = 0.0;
  const char* end = value.text.data() + value.text.size();
  const auto [stop, error] = std::from_chars(value.text.data(), end, found);
  return error == std::errc() && stop == end ? found : -1.0;
}

/// A rate in the file. value is null if there is none.
struct FoundRate {
  const PlacedValue* value = nullptr;
  std::string key;
};

/// Returns a parameter of a node, or null if it has none. In ROS 2, it is below `ros__parameters`.
const PlacedValue* node_parameter(const PlacedValue& node, const char* key) {
  const PlacedValue* parameters = node.find(kRos2Parameters);
  return (parameters == nullptr ? node : *parameters).find(key);
}

/// Returns the rate of a node called controller_manager in any namespace. If there is none, returns the rate
/// of all nodes (`/**`).
FoundRate rate_of_manager(const PlacedValue& map) {
  FoundRate of_every_node;
  for (const yaml::PlacedEntry& entry : map.entries) {
    const PlacedValue* rate = node_parameter(*entry.value, kRos2Rate);
    const std::string key = fmt::format("{}/{}", entry.key, kRos2Rate);
    if (entry.key.ends_with("controller_manager") && rate != nullptr) return {rate, key};
    if (entry.key == "/**" && rate != nullptr) of_every_node = {rate, key};
    if (entry.key != kRos2Parameters && rate == nullptr && !entry.alias) {
      if (FoundRate below = rate_of_manager(*entry.value); below.value != nullptr) return below;
    }
  }
  return of_every_node;
}

/// Returns the rate of the node that runs the control loop of a ROS 1 robot, in any namespace.
FoundRate rate_of_loop(const PlacedValue& map) {
  for (const yaml::PlacedEntry& entry : map.entries) {
    if (entry.key.ends_with("control_loop") || entry.key.ends_with("hardware_interface")) {
      const PlacedValue* rate = entry.value->find(kRos1Rate);
      if (rate != nullptr) return {rate, fmt::format("{}/{}", entry.key, kRos1Rate)};
    }
    if (entry.alias) continue;
    if (FoundRate below = rate_of_loop(*entry.value); below.value != nullptr) return below;
  }
  return {};
}

}  // namespace

std::optional<ControllerRate> controller_rate(const RosController& controller, const std::string& file) {
  FoundRate rate{controller.parameters->find(kRos2Rate), fmt::format("{}/{}", controller.name, kRos2Rate)};
  if (rate.value == nullptr || number(*rate.value) == 0.0) rate = rate_of_manager(*controller.all);
  if (rate.value == nullptr) rate = rate_of_loop(*controller.all);
  if (rate.value == nullptr) return std::nullopt;
  const double hertz = number(*rate.value);
  if (hertz >= kSlowest && hertz <= kFastest) return ControllerRate{hertz, rate.key};
  throw InputError(at_line(file, rate.value->line, rate.key),
                   InputFault{.problem = fmt::format("{} is {}", rate.key, shown(rate.value->text)),
                              .value = rate.value->text,
                              .limit = fmt::format("{:g} to {:g} Hz", kSlowest, kFastest)});
}

}  // namespace armtune::internal
