#include "sim/controller_files/joint_trajectory_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string_view>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/common/nearest.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "sim/yaml/decimal.hpp"

namespace armtune::internal {
namespace {

using yaml::PlacedValue;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// A gain of ours and what the file calls it, within a joint's map.
struct Name {
  const char* own;
  const char* in_file;
};
constexpr Name kNames[] = {{"jtc_p", "p"}, {"jtc_i", "i"}, {"jtc_d", "d"}};

class Reader {
 public:
  Reader(const RosController& controller, const std::string& file) : controller_(controller), file_(file) {}

  [[noreturn]] void fail(int line, const std::string& what) const {
    throw InputError(one_line(fmt::format("{}:{}: {}: {}", file_, line, controller_.name, what)));
  }

  /// Infinite where the file says so (.inf).
  double number(const PlacedValue& value, const std::string& what) const {
    std::string_view text = value.text;
    if (value.kind == PlacedValue::Kind::kScalar) {
      const bool minus = text.starts_with('-');
      const std::string_view size = text.substr(minus || text.starts_with('+') ? 1 : 0);
      if (size == ".inf" || size == ".Inf" || size == ".INF") return minus ? -kUnbounded : kUnbounded;
      double number = 0.0;
      const auto [end, error] = std::from_chars(size.data(), size.data() + size.size(), number);
      if (error == std::errc() && end == size.data() + size.size() && std::isfinite(number) &&
          !size.starts_with('-') && value.has_place())
        return minus ? -number : number;
    }
    fail(value.line, fmt::format("{} is {}; expected a number", what, shown(value.text)));
  }

  /// What the file has of a joint, at `key`; null: nothing.
  const PlacedValue* of_joint(const std::string& joint, const char* key) const {
    const PlacedValue* gains = controller_.parameters->find("gains");
    const PlacedValue* own = gains->find(joint);
    return own == nullptr ? nullptr : own->find(key);
  }
  double of_joint(const std::string& joint, const char* key, double otherwise) const {
    const PlacedValue* value = of_joint(joint, key);
    return value == nullptr ? otherwise : number(*value, fmt::format("gains/{}/{}", joint, key));
  }

  /// ROS 1 has feed-forward in a map of its own.
  const PlacedValue* feed_forward(const std::string& joint) const {
    if (const PlacedValue* in_gains = of_joint(joint, "ff_velocity_scale")) return in_gains;
    const PlacedValue* map = controller_.parameters->find("velocity_ff");
    return map == nullptr ? nullptr : map->find(joint);
  }

  void refuse_other_joints(const std::vector<std::string>& joints) const {
    const PlacedValue* gains = controller_.parameters->find("gains");
    std::vector<std::string> missing;
    for (const std::string& joint : joints) {
      if (gains->find(joint) == nullptr) missing.push_back(joint);
    }
    for (const auto& [joint, own, alias] : gains->entries) {
      if (std::find(joints.begin(), joints.end(), joint) == joints.end())
        fail(own->line, fmt::format("the arm has no joint '{}'{}; it has: {}", joint,
                                    suggestion(joint, joints), fmt::join(joints, ", ")));
    }
    if (!missing.empty())
      fail(gains->line, fmt::format("no gains for {} of the arm", fmt::join(missing, ", ")));
  }

  void refuse_other_commands() const {
    std::vector<std::string> commands;
    if (const PlacedValue* given = controller_.parameters->find("command_interfaces")) {
      for (const yaml::PlacedEntry& item : given->items) commands.push_back(item.value->text);
    } else if (!controller_.ros2 && controller_.type.find('/') != std::string::npos) {
      commands.push_back(controller_.type.starts_with("effort_") ? "effort" : controller_.type);
    }
    if (!commands.empty() && commands != std::vector<std::string>{"effort"}) {
      fail(controller_.parameters->line,
           fmt::format("it commands {}; armtune simulates effort commands alone", fmt::join(commands, ", ")));
    }
  }

  /// The largest contribution of the integral, the same in both directions.
  double clamp(const std::string& joint) const {
    const double both = of_joint(joint, "i_clamp", kUnbounded);
    const double most = of_joint(joint, "i_clamp_max", both);
    const double least = of_joint(joint, "i_clamp_min", -both);
    const double upper = std::isfinite(most) ? most : both;
    const double lower = std::isfinite(least) ? least : -both;
    const int line = controller_.parameters->find("gains")->find(joint)->line;
    if (std::abs(upper) != std::abs(lower)) {
      fail(line,
           fmt::format("the integral of {} is clamped to [{}, {}]; armtune simulates clamps of one size "
                       "in both directions",
                       joint, lower, upper));
    }
    if (std::isfinite(upper)) return std::abs(upper);
    const bool said = of_joint(joint, "i_clamp") != nullptr || of_joint(joint, "i_clamp_max") != nullptr;
    if (of_joint(joint, "i", 0.0) != 0.0 && !said) {
      fail(line,
           fmt::format("{} has an i and no i_clamp, which ROS 2 Humble and ROS 1 take for 0 and Jazzy for "
                       "none at all; write i_clamp, .inf for none",
                       joint));
    }
    return 1e6;  // N m, N: beyond any joint
  }

  void refuse_limits_of_output(const std::string& joint) const {
    for (const char* key : {"u_clamp_max", "u_clamp_min"}) {
      const PlacedValue* value = of_joint(joint, key);
      if (value == nullptr || !std::isfinite(number(*value, key))) continue;
      fail(value->line,
           fmt::format("armtune does not simulate {} of {}; the joint's effort limit bounds the torque", key,
                       joint));
    }
  }

  /// 1: the integral itself is clamped; 0: its contribution.
  double anti_windup(const std::string& joint) const {
    if (const PlacedValue* strategy = of_joint(joint, "antiwindup_strategy")) {
      if (strategy->text != "legacy")
        fail(strategy->line,
             fmt::format("armtune simulates antiwindup_strategy 'legacy', not {}", shown(strategy->text)));
      return 1.0;
    }
    const PlacedValue* given = of_joint(joint, "antiwindup");
    if (given == nullptr) return controller_.ros2 ? 1.0 : 0.0;
    return given->text == "true" || given->text == "True" ? 1.0 : 0.0;
  }

 private:
  const RosController& controller_;
  const std::string& file_;
};

/// The numbers that an alias or a merge key has elsewhere than in this controller's gains, by their places.
class UsedElsewhere {
 public:
  explicit UsedElsewhere(const RosController& controller) : controller_(controller) {
    see(*controller.all, false);
  }
  bool contains(std::size_t place) const { return places_.contains(place); }

 private:
  void see(const PlacedValue& value, bool by_alias) {
    if (!seen_.emplace(&value, by_alias).second) return;
    if (by_alias && value.has_place()) places_.insert(value.begin);
    const bool parameters = &value == controller_.parameters.get();
    for (const auto* entries : {&value.items, &value.entries}) {
      for (const yaml::PlacedEntry& entry : *entries) {
        if (parameters && (entry.key == "gains" || entry.key == "velocity_ff")) continue;
        see(*entry.value, by_alias || entry.alias);
      }
    }
  }

  const RosController& controller_;
  std::set<std::pair<const PlacedValue*, bool>> seen_;
  std::set<std::size_t> places_;
};

/// A number that is to stand in the file in place of another.
struct Change {
  std::size_t begin, end;
  std::string text;
  std::string joint;
};

/// Adds what a gain of a joint is to be, unless the file has it already.
void add_change(const Reader& reader, const PlacedValue* at, const std::string& joint,
                const std::string& what, double now, double wanted, const RosController& controller,
                const UsedElsewhere& elsewhere, std::vector<Change>& changes) {
  if (at == nullptr || !at->has_place()) {
    if (now == wanted) return;
    reader.fail(controller.parameters->find("gains")->line,
                fmt::format("{} of {} is to be {}, and the file has no number for it; write one", what, joint,
                            yaml::decimal(wanted)));
  }
  if (now != wanted && elsewhere.contains(at->begin)) {
    reader.fail(at->line,
                fmt::format("{} of {} is to be {}, and an alias elsewhere in the file has the same number; "
                            "write it out there",
                            what, joint, yaml::decimal(wanted)));
  }
  changes.push_back({at->begin, at->end, now == wanted ? at->text : yaml::decimal(wanted), joint});
}

}  // namespace

Gains joint_trajectory_gains(const RosController& controller, const std::string& file,
                             const std::vector<std::string>& joints) {
  const Reader reader(controller, file);
  reader.refuse_other_joints(joints);
  reader.refuse_other_commands();
  const auto n = static_cast<Eigen::Index>(joints.size());
  Gains gains;
  become(gains, kJointTrajectoryController, static_cast<int>(n));
  gains.joint_space_gains_p = gains.joint_space_gains_d = JointVector::Zero(n);
  gains.force_control_gains = JointVector::Zero(n);
  std::optional<double> anti_windup;
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::string& joint = joints[static_cast<std::size_t>(k)];
    for (const Name& name : kNames) own(gains, name.own)[k] = reader.of_joint(joint, name.in_file, 0.0);
    own(gains, "jtc_i_clamp")[k] = reader.clamp(joint);
    const PlacedValue* forward = reader.feed_forward(joint);
    own(gains, "jtc_ff_velocity_scale")[k] =
        forward == nullptr ? 0.0 : reader.number(*forward, "feed-forward of " + joint);
    reader.refuse_limits_of_output(joint);
    const double own_anti_windup = reader.anti_windup(joint);
    if (anti_windup && *anti_windup != own_anti_windup) {
      reader.fail(controller.parameters->find("gains")->line,
                  "some joints have anti-windup and others do not; armtune simulates one kind for all");
    }
    anti_windup = own_anti_windup;
  }
  own(gains, "jtc_antiwindup")[0] = anti_windup.value_or(1.0);
  return gains;
}

std::string with_gains(const std::string& text, const RosController& controller, const std::string& file,
                       const Gains& gains, const std::vector<std::string>& joints) {
  const Reader reader(controller, file);
  const Gains now = joint_trajectory_gains(controller, file, joints);
  const UsedElsewhere elsewhere(controller);
  std::vector<Change> changes;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto place = static_cast<Eigen::Index>(k);
    for (const Name& name : kNames) {
      add_change(reader, reader.of_joint(joints[k], name.in_file), joints[k], name.in_file,
                 own(now, name.own)[place], own(gains, name.own)[place], controller, elsewhere, changes);
    }
    const double clamp_now = own(now, "jtc_i_clamp")[place], clamp = own(gains, "jtc_i_clamp")[place];
    const bool one = reader.of_joint(joints[k], "i_clamp") != nullptr;
    add_change(reader, reader.of_joint(joints[k], one ? "i_clamp" : "i_clamp_max"), joints[k], "i_clamp",
               clamp_now, clamp, controller, elsewhere, changes);
    if (const PlacedValue* least = reader.of_joint(joints[k], "i_clamp_min"))
      add_change(reader, least, joints[k], "i_clamp_min", -clamp_now, -clamp, controller, elsewhere, changes);
    add_change(reader, reader.feed_forward(joints[k]), joints[k], "feed-forward",
               own(now, "jtc_ff_velocity_scale")[place], own(gains, "jtc_ff_velocity_scale")[place],
               controller, elsewhere, changes);
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.begin < b.begin; });
  std::string changed;
  std::size_t copied = 0;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const Change& change = changes[i];
    if (i > 0 && changes[i - 1].begin == change.begin) {
      if (changes[i - 1].text == change.text) continue;
      throw InputError(one_line(fmt::format(
          "{}: {} and {} share a number by an anchor, and are to be {} and {}; write each joint's numbers out",
          file, changes[i - 1].joint, change.joint, changes[i - 1].text, change.text)));
    }
    changed += text.substr(copied, change.begin - copied) + change.text;
    copied = change.end;
  }
  return changed + text.substr(copied);
}

}  // namespace armtune::internal
