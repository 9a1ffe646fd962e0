#include "sim/controller_files/joint_trajectory_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/common/nearest.hpp"
#include "core/control/laws/controller_kind.hpp"
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
          !size.starts_with('-') && value.has_place() && is_same_to_all(size))
        return minus ? -number : number;
    }
    fail(value.line,
         fmt::format("{} is {}; expected a number, plainly, without quotes, tags or leading zeros{}", what,
                     shown(value.text), controller_.ros2 ? "" : ", with a point before an exponent"));
  }

  /// 010 is octal to YAML 1.1, and 3e2 a text.
  bool is_same_to_all(std::string_view digits) const {
    if (digits.size() > 1 && digits[0] == '0' && digits[1] >= '0' && digits[1] <= '9') return false;
    return controller_.ros2 || digits.find_first_of("eE") == std::string_view::npos ||
           digits.find('.') != std::string_view::npos;
  }

  /// What the file has of a joint, at `key`; null: nothing.
  const PlacedValue* of_joint(const std::string& joint, const char* key) const {
    const PlacedValue* gains = controller_.parameters->find("gains");
    const PlacedValue* own = gains->find(joint);
    return own == nullptr ? nullptr : own->find(key);
  }
  double finite(const PlacedValue& value, const std::string& what) const {
    const double found = number(value, what);
    if (!std::isfinite(found))
      fail(value.line, fmt::format("{} is {}; expected a finite number", what, value.text));
    return found;
  }
  double of_joint(const std::string& joint, const char* key, double otherwise) const {
    const PlacedValue* value = of_joint(joint, key);
    return value == nullptr ? otherwise : number(*value, fmt::format("gains/{}/{}", joint, key));
  }

  /// ROS 1 has feed-forward in a map of its own.
  const PlacedValue* feed_forward(const std::string& joint) const {
    if (controller_.ros2) return of_joint(joint, "ff_velocity_scale");
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
    if (controller_.ros2) {
      const PlacedValue* given = controller_.parameters->find("command_interfaces");
      if (given == nullptr || given->kind != PlacedValue::Kind::kSequence)
        fail(controller_.parameters->line, "no list of command_interfaces; armtune simulates [effort]");
      for (const yaml::PlacedEntry& item : given->items) commands.push_back(item.value->text);
    } else if (controller_.type.find('/') != std::string::npos) {
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
    if (controller_.ros2 && (upper < 0.0 || lower > 0.0))
      fail(line, fmt::format("the integral of {} is clamped to [{}, {}], which leaves no room for 0", joint,
                             lower, upper));
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
    if (const PlacedValue* deadband = of_joint(joint, "error_deadband")) {
      if (number(*deadband, "error_deadband") != 0.0)
        fail(deadband->line, fmt::format("armtune does not simulate error_deadband of {}", joint));
    }
    if (const PlacedValue* wraps = of_joint(joint, "angle_wraparound")) {
      if (wraps->text == "true" || wraps->text == "True")
        fail(wraps->line,
             fmt::format("armtune takes the short way round for joints without limits, and does not "
                         "simulate angle_wraparound of {}",
                         joint));
    }
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
    if (controller_.ros2) return 1.0;
    const PlacedValue* given = of_joint(joint, "antiwindup");
    if (given == nullptr || given->text == "false" || given->text == "False") return 0.0;
    if (given->text == "true" || given->text == "True") return 1.0;
    fail(given->line,
         fmt::format("antiwindup of {} is {}; expected true or false", joint, shown(given->text)));
  }

 private:
  const RosController& controller_;
  const std::string& file_;
};

/// In how many places of the whole file, aliases and merge keys counted, a value is had.
class Uses {
 public:
  explicit Uses(const PlacedValue& root) {
    visit(root);
    uses_[&root] = 1.0;
    // Parents come before children.
    for (auto value = order_.rbegin(); value != order_.rend(); ++value) {
      for (const auto* entries : {&(*value)->items, &(*value)->entries}) {
        for (const yaml::PlacedEntry& entry : *entries) uses_[entry.value.get()] += uses_[*value];
      }
    }
  }
  double of(const PlacedValue& value) const { return uses_.at(&value); }

 private:
  void visit(const PlacedValue& value) {
    if (!uses_.emplace(&value, 0.0).second) return;
    for (const auto* entries : {&value.items, &value.entries}) {
      for (const yaml::PlacedEntry& entry : *entries) visit(*entry.value);
    }
    order_.push_back(&value);
  }

  std::unordered_map<const PlacedValue*, double> uses_;  ///< may be astronomical
  std::vector<const PlacedValue*> order_;                ///< children before parents
};

/// A number that is to stand in the file in place of another.
struct Change {
  const PlacedValue* at;
  bool differs;
  std::string text;
  std::string gain;  ///< "p of shoulder"
};

/// What a gain of a joint is to be. None: the file has no number for it.
std::optional<Change> change_of(const PlacedValue* at, const std::string& gain, double now, double wanted) {
  if (at == nullptr || !at->has_place()) return std::nullopt;
  return Change{at, now != wanted, now == wanted ? at->text : yaml::decimal(wanted), gain};
}

/// Throws InputError if the changed text does not read back as the gains.
void refuse_what_is_lost(const std::string& changed, const RosController& controller, const std::string& file,
                         const Gains& gains, const std::vector<std::string>& joints) {
  const Gains back = joint_trajectory_gains(
      chosen_controller(ros_controllers(changed, file), file, controller.name), file, joints);
  for (const GainField& field : fields_of(gains)) {
    const auto* own_gain = std::get_if<OwnGain>(&field.member);
    if (own_gain == nullptr) continue;
    const std::size_t place = own_gain->place;
    if (back.own[place] == gains.own[place]) continue;
    Eigen::Index k = 0;
    (back.own[place] - gains.own[place]).cwiseAbs().maxCoeff(&k);
    const bool each = own_gain->shape == GainShape::kJoints;
    throw InputError(one_line(
        fmt::format("{}: {}: {}{} is to be {}, and the file would give {}; write a number for it there", file,
                    controller.name, field.name, each ? " of " + joints[static_cast<std::size_t>(k)] : "",
                    yaml::decimal(gains.own[place][k]), yaml::decimal(back.own[place][k]))));
  }
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
    for (const Name& name : kNames) {
      const PlacedValue* value = reader.of_joint(joint, name.in_file);
      own(gains, name.own)[k] =
          value == nullptr ? 0.0 : reader.finite(*value, fmt::format("gains/{}/{}", joint, name.in_file));
    }
    own(gains, "jtc_i_clamp")[k] = reader.clamp(joint);
    const PlacedValue* forward = reader.feed_forward(joint);
    own(gains, "jtc_ff_velocity_scale")[k] =
        forward == nullptr ? 0.0 : reader.finite(*forward, "feed-forward of " + joint);
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
  std::vector<Change> changes;
  const auto add = [&changes](const PlacedValue* at, const std::string& gain, double had, double wanted) {
    if (auto change = change_of(at, gain, had, wanted)) changes.push_back(std::move(*change));
  };
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const std::string& joint = joints[k];
    const auto place = static_cast<Eigen::Index>(k);
    for (const Name& name : kNames) {
      add(reader.of_joint(joint, name.in_file), fmt::format("{} of {}", name.in_file, joint),
          own(now, name.own)[place], own(gains, name.own)[place]);
    }
    const double had = own(now, "jtc_i_clamp")[place], wanted = own(gains, "jtc_i_clamp")[place];
    for (const auto& [key, sign] : {std::pair{"i_clamp", 1.0}, {"i_clamp_max", 1.0}, {"i_clamp_min", -1.0}})
      add(reader.of_joint(joint, key), fmt::format("{} of {}", key, joint), sign * had, sign * wanted);
    add(reader.feed_forward(joint), "feed-forward of " + joint, own(now, "jtc_ff_velocity_scale")[place],
        own(gains, "jtc_ff_velocity_scale")[place]);
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.at->begin < b.at->begin; });
  const Uses uses(*controller.all);
  std::string changed;
  std::size_t copied = 0;
  for (std::size_t i = 0, next = 0; i < changes.size(); i = next) {
    const Change& change = changes[i];
    for (next = i; next < changes.size() && changes[next].at == change.at; ++next) {
      if (changes[next].text == change.text) continue;
      reader.fail(change.at->line,
                  fmt::format("{} and {} share a number by an anchor, and are to be {} and {}; write "
                              "both out",
                              change.gain, changes[next].gain, change.text, changes[next].text));
    }
    if (change.differs && uses.of(*change.at) != static_cast<double>(next - i)) {
      reader.fail(change.at->line,
                  fmt::format("{} is to be {}, and an alias elsewhere in the file has the same number; "
                              "write both out",
                              change.gain, change.text));
    }
    if (!change.differs) continue;
    changed += text.substr(copied, change.at->begin - copied) + change.text;
    copied = change.at->end;
  }
  changed += text.substr(copied);
  refuse_what_is_lost(changed, controller, file, gains, joints);
  return changed;
}

}  // namespace armtune::internal
