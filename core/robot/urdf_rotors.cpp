#include "core/robot/urdf_rotors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"

namespace armtune::internal {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

/// Returns the text as a number. Blanks around it are ignored; if it is not a finite number, returns nothing.
std::optional<double> number(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  text.remove_suffix(text.size() - std::min(text.find_last_not_of(kBlanks) + 1, text.size()));
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// An element of an actuator, and its text.
struct Said {
  const char* element;
  const char* text;
};

std::optional<Said> said(const pugi::xml_node& actuator, const char* element, bool in_attribute) {
  const pugi::xml_node node = actuator.child(element);
  if (!node) return std::nullopt;
  return Said{element, in_attribute ? node.attribute("value").value() : node.child_value()};
}

[[noreturn]] void refuse(const Said& said, const std::string& joint, const std::string& path,
                         const std::string& problem, const char* limit) {
  throw InputError(InputPlace{path, 0, fmt::format("{}/{}", joint, said.element)},
                   fmt::format("joint '{}': the {} of its transmission {}", joint, said.element, problem))
      .with_value(said.text, limit);
}

double read(const Said& said, const std::string& joint, const std::string& path) {
  const std::optional<double> value = number(said.text);
  if (!value)
    refuse(said, joint, path, fmt::format("is '{}', which is not a number", said.text), "a finite number");
  return *value;
}

/// Returns the rotor inertia that acts on the joint (gear ratio^2 x inertia); nothing if none is given.
std::optional<double> reflected(const pugi::xml_node& actuator, const std::string& joint,
                                const std::string& path) {
  const std::optional<Said> rotor = said(actuator, "drake:rotor_inertia", true);
  if (!rotor) return std::nullopt;
  const double inertia = read(*rotor, joint, path);
  if (inertia < 0.0)
    refuse(*rotor, joint, path, fmt::format("is {}; it must not be negative", inertia), "not negative");
  std::optional<Said> gear = said(actuator, "drake:gear_ratio", true);
  if (!gear) gear = said(actuator, "mechanicalReduction", false);
  if (!gear) return inertia;
  const double ratio = read(*gear, joint, path);
  if (ratio == 0.0) refuse(*gear, joint, path, "is 0; it must not be 0", "not 0");
  return ratio * ratio * inertia;
}

}  // namespace

std::map<std::string, double> rotor_inertias(const std::string& urdf, const std::string& path) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(urdf.data(), urdf.size());
  if (!parsed) {
    const auto line = 1 + std::count(urdf.begin(), urdf.begin() + parsed.offset, '\n');
    throw InputError(at_line(path, line), fmt::format("{}; correct the file", parsed.description()));
  }
  std::map<std::string, double> inertias;
  for (const pugi::xml_node& transmission : document.child("robot").children("transmission")) {
    const auto joints = transmission.children("joint");
    if (std::distance(joints.begin(), joints.end()) != 1) continue;
    const std::string joint = transmission.child("joint").attribute("name").value();
    for (const pugi::xml_node& actuator : transmission.children("actuator")) {
      if (const std::optional<double> inertia = reflected(actuator, joint, path)) inertias[joint] += *inertia;
    }
  }
  return inertias;
}

}  // namespace armtune::internal
