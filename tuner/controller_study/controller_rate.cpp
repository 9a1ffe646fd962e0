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

double number(const PlacedValue& value) {
  double found = 0.0;
  const char* end = value.text.data() + value.text.size();
  const auto [stop, error] = std::from_chars(value.text.data(), end, found);
  return error == std::errc() && stop == end ? found : -1.0;
}

/// Returns the `update_rate` of a node, or null if it has none. In ROS 2, it is below `ros__parameters`.
const PlacedValue* rate_of(const PlacedValue& node) {
  const PlacedValue* parameters = node.find("ros__parameters");
  return (parameters == nullptr ? node : *parameters).find("update_rate");
}

/// Returns the rate of a node called controller_manager in any namespace. If there is none, returns the rate
/// of all nodes (`/**`), or null.
const PlacedValue* rate_of_manager(const PlacedValue& map) {
  const PlacedValue* of_every_node = nullptr;
  for (const yaml::PlacedEntry& entry : map.entries) {
    const PlacedValue* rate = rate_of(*entry.value);
    if (entry.key.ends_with("controller_manager") && rate != nullptr) return rate;
    if (entry.key == "/**" && rate != nullptr) of_every_node = rate;
    if (entry.key != "ros__parameters" && rate == nullptr) {
      if (const PlacedValue* below = rate_of_manager(*entry.value)) return below;
    }
  }
  return of_every_node;
}

}  // namespace

std::optional<double> controller_rate(const RosController& controller, const std::string& file) {
  const PlacedValue* rate = controller.parameters->find("update_rate");
  if (rate == nullptr || number(*rate) == 0.0) rate = rate_of_manager(*controller.all);
  if (rate == nullptr) return std::nullopt;
  const double hertz = number(*rate);
  if (hertz >= kSlowest && hertz <= kFastest) return hertz;
  throw InputError(at_line(file, rate->line, "update_rate"),
                   InputFault{.problem = fmt::format("update_rate is {}", shown(rate->text)),
                              .value = rate->text,
                              .limit = fmt::format("{:g} to {:g} Hz", kSlowest, kFastest)});
}

}  // namespace armtune::internal
