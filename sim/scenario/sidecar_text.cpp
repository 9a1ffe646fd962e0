#include "sim/scenario/sidecar_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

/// A key of the file, with its value or with the keys in its map.
struct Entry {
  std::string name;
  std::string value = {};
  std::string note = {};  ///< a comment behind the value
  bool asked = false;     ///< false: the whole line is a comment
  std::vector<Entry> inside = {};

  /// Returns the key of this name in the map, which is added if there is none.
  Entry& at(const std::string& key) {
    const auto same = [&key](const Entry& entry) { return entry.name == key; };
    const auto found = std::find_if(inside.begin(), inside.end(), same);
    return found != inside.end() ? *found : inside.emplace_back(Entry{key});
  }
};

/// Adds keys that are not comments: `field` of `name` in the map `key`.
class Asked {
 public:
  Asked(Entry& root, const std::string& key, const std::string& name)
      : key_(root.at(key)), name_(key_.at(yaml::quoted(name))) {
    key_.asked = name_.asked = true;
  }
  void note(const std::string& text) { name_.note = text; }
  void add(const std::string& field, const std::string& value, const std::string& note = {}) {
    name_.inside.push_back({field, value, note, true});
  }

 private:
  Entry& key_;
  Entry& name_;
};

constexpr const char* kMomentsNote = "[ixx, ixy, ixz, iyy, iyz, izz] about the centre, kg m^2";

void ask_for_limits(const MissingData& missing, Entry& root) {
  for (const std::string& joint : missing.position) {
    Asked limits(root, "limits", joint);
    limits.add("lower", "", "rad or m");
    limits.add("upper", "", "rad or m");
  }
  for (const std::string& joint : missing.velocity)
    Asked(root, "limits", joint).add("velocity", "", "rad/s or m/s");
  for (const std::string& joint : missing.effort) Asked(root, "limits", joint).add("effort", "", "N m or N");
}

/// Adds the nearest possible inertia in place of an impossible one.
void ask_to_check(const ImpossibleInertia& link, Entry& root) {
  const GivenInertia& nearest = link.nearest;
  const Vec3& c = nearest.center;
  const Mat3& I = nearest.about_center;
  Asked inertia(root, "inertia", link.link);
  inertia.note(
      fmt::format("no moving link can have the inertia of the URDF: {}{}", link.fault,
                  link.is_complete()
                      ? fmt::format("; this is the nearest possible one, {:.2g} % away", 100.0 * link.moved)
                      : "; fill in what is missing here"));
  inertia.add("mass", nearest.mass > 0.0 ? fmt::format("{:.10g}", nearest.mass) : "",
              nearest.mass > 0.0 ? "" : "kg");
  inertia.add("center", fmt::format("[{:.10g}, {:.10g}, {:.10g}]", c.x(), c.y(), c.z()));
  if (link.has_moments()) {
    inertia.add("moments", fmt::format("[{:.10g}, {:.10g}, {:.10g}, {:.10g}, {:.10g}, {:.10g}]", I(0, 0),
                                       I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2)));
  } else {
    inertia.add("moments", "", kMomentsNote);
  }
}

void ask_for_inertia(const std::string& link, Entry& root) {
  Asked inertia(root, "inertia", link);
  inertia.add("mass", "", "kg");
  inertia.add("center", "[0, 0, 0]", "m, in the link's frame");
  inertia.add("moments", "", kMomentsNote);
}

/// Adds a proposal as a comment, unless its key is there already.
void propose(const ProposedValue& proposed, Entry& root) {
  Entry& name = root.at(proposed.key).at(yaml::quoted(proposed.name));
  Entry& entry = proposed.field.empty() ? name : name.at(proposed.field);
  if (!entry.asked && entry.value.empty()) entry.value = proposed.value;
}

void write(const Entry& entry, std::size_t indent, std::string& text) {
  text +=
      fmt::format("{}{}{}:{}{}{}{}\n", entry.asked ? "" : "#", std::string(indent, ' '), entry.name,
                  entry.value.empty() ? "" : " ", entry.value, entry.note.empty() ? "" : "  # ", entry.note);
  for (const Entry& inner : entry.inside) write(inner, indent + 2, text);
}

}  // namespace

std::string sidecar_yaml(const std::string& urdf, const MissingData& missing,
                         const std::vector<Doubt>& found) {
  std::string text = urdf.empty() ? "" : fmt::format("urdf: {}\n", yaml::quoted(urdf));
  if (!found.empty()) {
    text += "# Doubtful values:\n";
    for (const Doubt& doubt : found) text += "\n" + yaml::comment(doubt.says);
    text +=
        "\n# Proposed values are comments. Remove the # before those that are right, and fill in empty ones.\n";
  }
  Entry root{""};
  ask_for_limits(missing, root);
  for (const ImpossibleInertia& link : missing.impossible) ask_to_check(link, root);
  for (const std::string& link : missing.inertia) ask_for_inertia(link, root);
  for (const Doubt& doubt : found) {
    for (const ProposedValue& proposed : doubt.proposed) propose(proposed, root);
  }
  for (const Entry& entry : root.inside) write(entry, 0, text);
  return text;
}

}  // namespace armtune::internal
