#include "tuner/study/parameter_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/common/nearest.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

/// Returns the entries that a name denotes: one number, or all numbers of a field.
std::vector<GainEntry> find_entries(const yaml::Node& node, const std::vector<GainEntry>& all) {
  const std::string name = node.as_string();
  std::vector<GainEntry> found;
  std::vector<std::string> names;
  for (const GainEntry& entry : all) {
    if (is_named(entry, name)) found.push_back(entry);
    if (names.empty() || names.back() != entry.field->name) names.emplace_back(entry.field->name);
    names.push_back(entry.name);
  }
  if (found.empty())
    node.fail("'" + name + "' is not a gain" + suggestion(name, names) + "; see armtune controllers");
  return found;
}

Parameter default_parameter(const GainEntry& entry, const Gains& start) {
  Parameter p;
  p.entry = entry;
  p.start = value(start, entry);
  if (entry.field->search == SearchRange::kCriticalDamping) {
    const double Kp = start.task_space_gains_p[static_cast<Eigen::Index>(entry.component)];
    p.lower = 0.0;
    p.upper = std::max(0.25 * Kp * Kp, 2.0 * p.start);
    p.scale = Scale::kLinear;
  } else {
    p.lower = p.start * entry.field->lower_factor;
    p.upper = p.start * entry.field->upper_factor;
  }
  return p;
}

/// True if the gain acts only on the tool's orientation.
bool turns_tool(const GainEntry& entry) {
  constexpr std::size_t kRotations = 3;  // of x y z rx ry rz
  if (const auto* scalar = std::get_if<double Gains::*>(&entry.field->member))
    return *scalar == &Gains::slerpDurationErrorGain;
  return component_names(*entry.field, {}).size() == 6 && entry.component >= kRotations;
}

/// True if the gain acts only on the motion of the tool, and not in states that track joints.
bool moves_tool(const GainEntry& entry) {
  const auto* scalar = std::get_if<double Gains::*>(&entry.field->member);
  if (scalar != nullptr && *scalar == &Gains::trajectoryDurationErrorGain) return true;
  return turns_tool(entry) || component_names(*entry.field, {}).size() == 6;
}

/// Returns " [UNIT]"; empty for a gain without a unit.
std::string unit_of(const GainField& field) {
  return *field.unit != '\0' ? fmt::format(" [{}]", field.unit) : std::string();
}

template <typename List>
auto find_by_name(List& list, const std::string& name) {
  return std::find_if(list.begin(), list.end(), [&name](const auto& p) { return p.entry.name == name; });
}

/// Reads one entry of `parameters`. Its gains are fixed, linked, or tuned between bounds.
void read_parameter(const yaml::Node& node, const std::vector<GainEntry>& all, ParameterSpace& space) {
  yaml::MapReader map(node);
  const auto entries = find_entries(map.required("name"), all);
  const yaml::Node* fixed = map.optional("fixed");
  const yaml::Node* link = map.optional("link");
  const yaml::Node* lower = map.optional("lower");
  const yaml::Node* upper = map.optional("upper");
  const yaml::Node* start = map.optional("start");
  const std::string scale = map.string("scale", "");
  const double factor = map.number_in("factor", 1.0, 0.0, std::numeric_limits<double>::infinity());
  if (!scale.empty() && scale != "log" && scale != "linear")
    map.required("scale").fail_choice({"log", "linear"});
  map.finish();
  if (fixed != nullptr && link != nullptr)
    node.fail("give at most one of: fixed, link", "at most one of the keys: fixed, link");
  for (const GainEntry& entry : entries) {
    // A link stores the index of its parameter. Thus no index may change once there is a link.
    const bool linked = find_by_name(space.links, entry.name) != space.links.end();
    if (linked || (!space.links.empty() && find_by_name(space.free, entry.name) != space.free.end())) {
      map.required("name").fail(entry.name +
                                " is listed again after a link; list every gain before the links");
    }
    if (const auto old = find_by_name(space.free, entry.name); old != space.free.end()) space.free.erase(old);
    if (fixed != nullptr) {
      value(space.start, entry) = fixed->as_number();
    } else if (link != nullptr) {
      const auto target = find_by_name(space.free, link->as_string());
      if (target == space.free.end()) {
        link->fail("'" + link->as_string() +
                   "' is not a tuned parameter listed before this one; list it first, then the link");
      }
      space.links.push_back({entry, static_cast<std::size_t>(target - space.free.begin()), factor});
    } else {
      if (entry.field->search == SearchRange::kBounded && upper == nullptr)
        node.fail(fmt::format(
                      "{} has no 'upper'; give its largest value{}, because this value depends on contacts, "
                      "which are not simulated",
                      entry.name, unit_of(*entry.field)),
                  "the key 'upper'");
      if (start != nullptr) value(space.start, entry) = start->as_number();
      Parameter p = default_parameter(entry, space.start);
      if (!scale.empty()) p.scale = scale == "log" ? Scale::kLog : Scale::kLinear;
      if (lower != nullptr) p.lower = lower->as_number();
      if (upper != nullptr) p.upper = upper->as_number();
      space.free.push_back(p);
    }
  }
}

}  // namespace

ParameterSpace read_space(const yaml::Node* node, const Gains& start, const std::vector<std::string>& joints,
                          bool task, bool orientation) {
  ParameterSpace space;
  space.start = start;
  const auto all = gain_entries(start, joints);
  if (node == nullptr) {
    for (const GainEntry& entry : all) {
      // A gain that is zero is switched off. Factors on zero would give no range.
      const bool off = entry.field->search == SearchRange::kFactor && value(start, entry) == 0.0;
      const bool idle = (!task && moves_tool(entry)) || (!orientation && turns_tool(entry));
      const bool asks =
          entry.field->search == SearchRange::kNone || entry.field->search == SearchRange::kBounded;
      if (!asks && !off && !idle) space.free.push_back(default_parameter(entry, start));
    }
    return space;
  }
  for (const yaml::Node& item : node->items()) read_parameter(item, all, space);
  return space;
}

std::vector<SweepAxis> read_sweep(const yaml::Node& node, const std::vector<GainEntry>& all,
                                  const ParameterSpace& space) {
  std::vector<SweepAxis> axes;
  double points = 1.0;
  for (const yaml::Node& item : node.items()) {
    yaml::MapReader map(item);
    SweepAxis& axis = axes.emplace_back();
    for (const yaml::Node& name : map.required("parameters").items()) {
      for (const GainEntry& entry : find_entries(name, all)) {
        const auto found = find_by_name(space.free, entry.name);
        if (found == space.free.end()) name.fail(entry.name + " is not tuned by this study");
        axis.parameters.push_back(static_cast<std::size_t>(found - space.free.begin()));
      }
    }
    for (const yaml::Node& factor : map.required("factors").items()) {
      const double f = axis.factors.emplace_back(factor.as_number());
      if (!(f > 0.0)) factor.fail(fmt::format("factor {} is not above zero", f), "above zero");
    }
    points *= static_cast<double>(axis.factors.size());
    map.finish();
  }
  if (points > 1e5)
    node.fail(InputFault{.problem = fmt::format("the sweep has {:.0f} points", points),
                         .value = fmt::format("{:.0f}", points),
                         .limit = "at most 100000"});
  return axes;
}

}  // namespace armtune::internal
