#include "sim/scenario/plant_file.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "sim/yaml/joint_values.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

constexpr double kFastest = 1e5;  // Hz
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec3 read_vec3(const yaml::Node& node) {
  return Vec3(node.as_numbers(3).data());
}

}  // namespace

Payload read_payload(const yaml::Node& node) {
  yaml::MapReader map(node);
  Payload payload;
  payload.mass = map.number_in("mass", 0.0, 0.0, kInfinity);
  if (const yaml::Node* center = map.optional("center")) payload.center = read_vec3(*center);
  map.finish();
  return payload;
}

PlantConditions read_plant(const yaml::Node& node, const std::vector<std::string>& joints) {
  yaml::MapReader map(node);
  PlantConditions plant;
  plant.position_noise = map.number_in("position_noise", 0.0, 0.0, kInfinity);
  plant.velocity_noise = map.number_in("velocity_noise", 0.0, 0.0, kInfinity);
  const long delay = map.integer("torque_delay_periods", 0);
  if (delay < 0 || delay > 1000) {
    map.required("torque_delay_periods")
        .fail(fmt::format("the delay is {} periods; it must lie in 0 .. 1000", delay), "0 .. 1000");
  }
  plant.torque_delay_periods = static_cast<int>(delay);
  plant.rate = map.number_in("rate", 0.0, 0.0, kFastest);
  if (const yaml::Node* payload_node = map.optional("payload")) {
    plant.payload = read_payload(*payload_node);
  }
  for (const auto& [key, values] : {std::pair{"viscous_friction", &plant.viscous_friction},
                                    std::pair{"coulomb_friction", &plant.coulomb_friction}}) {
    const yaml::Node* friction = map.optional(key);
    if (friction == nullptr) continue;
    *values = yaml::joint_values(*friction, joints);
    if ((values->array() < 0.0).any()) {
      friction->fail(InputFault{.problem = fmt::format("the friction of a joint is {}", values->minCoeff()),
                                .value = fmt::to_string(values->minCoeff()),
                                .limit = "0 or more"});
    }
  }
  for (const auto& [key, values] :
       {std::pair{"mass_factors", &plant.mass_factors}, std::pair{"inertia_factors", &plant.inertia_factors},
        std::pair{"rotor_factors", &plant.rotor_factors}}) {
    const yaml::Node* factors = map.optional(key);
    if (factors == nullptr) continue;
    *values = yaml::joint_values(*factors, joints);
    if (!(values->array() > 0.0).all()) {
      factors->fail(InputFault{.problem = fmt::format("a factor is {}", values->minCoeff()),
                               .value = fmt::to_string(values->minCoeff()),
                               .limit = "factors above 0 (1: as in the robot file)"});
    }
  }
  map.finish();
  return plant;
}

Camera read_camera(const yaml::Node& node) {
  yaml::MapReader map(node);
  Camera camera;
  camera.noise = map.number_in("noise", camera.noise, 0.0, kInfinity);
  camera.bandwidth = map.number_in("bandwidth", camera.bandwidth, 1e-3, 1e5);
  map.finish();
  return camera;
}

}  // namespace armtune::internal
