#include "sim/logs/message_units.hpp"

#include <algorithm>
#include <array>

namespace armtune::internal {
namespace {

struct FieldUnit {
  std::string_view type;
  std::string_view field;  ///< empty: every field
  std::string_view unit;
};

constexpr std::array<FieldUnit, 12> kUnits = {{
    {"geometry_msgs/Wrench", "force", "N"},
    {"geometry_msgs/Wrench", "torque", "N m"},
    {"geometry_msgs/Pose", "position", "m"},
    {"geometry_msgs/Point", "", "m"},
    {"geometry_msgs/Transform", "translation", "m"},
    {"geometry_msgs/Twist", "linear", "m/s"},
    {"geometry_msgs/Twist", "angular", "rad/s"},
    {"geometry_msgs/Accel", "linear", "m/s^2"},
    {"geometry_msgs/Accel", "angular", "rad/s^2"},
    {"sensor_msgs/Imu", "angular_velocity", "rad/s"},
    {"sensor_msgs/Imu", "linear_acceleration", "m/s^2"},
    {"sensor_msgs/Temperature", "temperature", "degC"},
}};

}  // namespace

std::string_view unit_of(std::string_view type, std::string_view field) {
  const auto known = std::find_if(kUnits.begin(), kUnits.end(), [&](const FieldUnit& unit) {
    return unit.type == type && (unit.field.empty() || unit.field == field);
  });
  return known == kUnits.end() ? std::string_view() : known->unit;
}

}  // namespace armtune::internal
