#include "sim/controller_files/joint_trajectory_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/common/nearest.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "sim/controller_files/commanded_interfaces.hpp"
#include "sim/controller_files/joint_parameters.hpp"

namespace armtune::internal {
namespace {

using yaml::PlacedValue;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kNoClamp = 1e6;  // N m, N, rad/s, m/s: more than any joint can reach, so no clamp

/// The values of antiwindup_strategy, from 1 on in the order of the numbers of the gain jtc_antiwindup.
constexpr std::array<std::string_view, 4> kStrategies = {"legacy", "none", "conditional_integration",
                                                         "back_calculation"};

/// Reads the parameters of a controller and its joints, and refuses those that armtune cannot simulate.
class Reader : public JointParameters {
 public:
  using JointParameters::JointParameters;
  using JointParameters::of_joint;

  double of_joint(const std::string& joint, const char* key, double otherwise) const {
    const PlacedValue* value = of_joint(joint, key);
    return value == nullptr ? otherwise : number(*value, fmt::format("gains/{}/{}", joint, key));
  }

  void refuse_other_joints(const std::vector<std::string>& joints) const {
    const PlacedValue* gains = controller().parameters->find("gains");
    std::vector<std::string> missing = joints;
    for (const auto& [key, own, alias] : gains->entries) {
      const std::string joint = without_prefix(key);
      if (std::find(joints.begin(), joints.end(), joint) == joints.end())
        fail(own->line,
             fmt::format("the arm has no joint '{}'{}; it has: {}", joint, suggestion(joint, joints),
                         fmt::join(joints, ", ")),
             joint, fmt::format("one of: {}", fmt::join(joints, ", ")));
      if (std::erase(missing, joint) == 0)
        fail(own->line,
             fmt::format("'{}' is the second entry for {}, because prefixes that launch files put before "
                         "joint names are ignored; give a file for one arm",
                         key, joint),
             key);
    }
    if (!missing.empty())
      fail(gains->line,
           fmt::format("the file has no gains for {} of the arm; add them", fmt::join(missing, ", ")), "",
           fmt::format("{}", fmt::join(missing, ", ")));
  }

  /// Returns the kind of controller, which its commands determine. Throws InputError for commands that
  /// armtune cannot simulate.
  const char* kind() const {
    const std::vector<std::string> commands = commanded_interfaces(controller());
    const PlacedValue* list = controller().parameters->find("command_interfaces");
    if (controller().ros2 && (list == nullptr || list->kind != PlacedValue::Kind::kSequence))
      fail(controller().parameters->line,
           "the list command_interfaces is missing; give [effort] or [velocity], which armtune simulates", "",
           "[effort] or [velocity]");
    if (commands.empty() || commands == std::vector<std::string>{"effort"}) return kJointTrajectoryController;
    if (!are_simulated(commands, controller().ros2))
      fail(controller().parameters->line,
           fmt::format(
               "the controller commands {}; armtune simulates either effort commands or velocity "
               "commands with such a file; for streamed positions, use --controller position_streaming "
               "instead of this file",
               fmt::join(commands, ", ")),
           fmt::format("{}", fmt::join(commands, ", ")), "effort or velocity");
    const PlacedValue* open_loop = controller().parameters->find("open_loop_control");
    if (open_loop != nullptr && (open_loop->text == "true" || open_loop->text == "True"))
      fail(open_loop->line, "with open_loop_control the gains have no effect; set it to false to tune them",
           open_loop->text, "false");
    return kJointTrajectoryVelocityController;
  }

  /// Returns the sizes of the bounds of the integral's contribution, for the largest and for the smallest
  /// one.
  std::pair<double, double> clamps(const std::string& joint) const {
    const bool each = rules_.has_bounds_of_integral;
    refuse_missing_clamp(joint);
    const double both = of_joint(joint, "i_clamp", rules_.unbounded_by_default ? kUnbounded : 0.0);
    const double most = each ? of_joint(joint, "i_clamp_max", both) : both;
    const double least = each ? of_joint(joint, "i_clamp_min", -both) : -both;
    const double upper = std::isfinite(most) ? most : both;
    const double lower = std::isfinite(least) ? least : -both;
    const int line = controller().parameters->find("gains")->line;
    if (controller().ros2 && (upper < 0.0 || lower > 0.0))
      fail(line,
           fmt::format("the integral of {} is clamped to [{}, {}]; this range must contain 0", joint, lower,
                       upper),
           fmt::format("[{}, {}]", lower, upper), "a range that contains 0");
    if (lower == 0.0 && upper != 0.0) {
      fail(line,
           fmt::format("the integral of {} is clamped to [{}, {}]; armtune cannot simulate a lower bound "
                       "of 0 with an upper bound above 0; give i_clamp_min below 0",
                       joint, lower, upper),
           fmt::format("[{}, {}]", lower, upper), "i_clamp_min below 0");
    }
    return {std::min(std::abs(upper), kNoClamp), std::min(std::abs(lower), kNoClamp)};
  }

  /// Throws InputError if the joint has an integral gain, but no clamp where that does not mean "no clamp".
  void refuse_missing_clamp(const std::string& joint) const {
    const auto has = [&](const char* key) { return of_joint(joint, key) != nullptr; };
    if (of_joint(joint, "i", 0.0) == 0.0 || has("i_clamp")) return;
    if (rules_.has_bounds_of_integral && (has("i_clamp_max") || has("i_clamp_min"))) return;
    const int line = controller().parameters->find("gains")->line;
    if (!rules_.unbounded_by_default)
      fail(line,
           fmt::format("{} has an i but no i_clamp, so {} clamps the integral to 0 and i has no effect; "
                       "give i_clamp, where .inf means no clamp",
                       joint, rules_.title),
           "", "i_clamp");
    // A file with a strategy is for ROS 2 Jazzy or later.
    if (!controller().distro && !has("antiwindup_strategy"))
      fail(line,
           fmt::format("{} has an i but no i_clamp; ROS 2 Humble then clamps the integral to 0, and Jazzy "
                       "does not clamp it. Give i_clamp, where .inf means no clamp, or --distro jazzy",
                       joint),
           "", "i_clamp or --distro");
  }

  bool is_true(const std::string& joint, const char* key) const {
    const PlacedValue* value = of_joint(joint, key);
    return value != nullptr && (value->text == "true" || value->text == "True");
  }

  /// Returns true if the file asks for the shorter way round for the joint, where this is a parameter.
  bool wraps(const std::string& joint) const {
    if (rules_.wraparound == Wraparound::kAsParameter)
      return is_true(joint, "angle_wraparound") || is_true(joint, "normalize_error");
    if (controller().ros2 && is_true(joint, "angle_wraparound"))
      fail(of_joint(joint, "angle_wraparound")->line,
           fmt::format("{} does not have the angle_wraparound of {}; set it to false (a joint without limits "
                       "takes the short way round in any case), or give --distro humble",
                       rules_.title, joint),
           "true", "false");
    return false;
  }

  /// Returns the sizes of the bounds of the output, for the largest and for the smallest output. Throws
  /// InputError if the range between them does not contain 0.
  std::pair<double, double> output_clamps(const std::string& joint) const {
    if (!rules_.has_strategies) return {kNoClamp, kNoClamp};
    const double upper = of_joint(joint, "u_clamp_max", kUnbounded);
    const double lower = of_joint(joint, "u_clamp_min", -kUnbounded);
    if (upper < 0.0 || lower > 0.0)
      fail(controller().parameters->find("gains")->line,
           fmt::format("the output of {} is clamped to [{}, {}]; this range must contain 0", joint, lower,
                       upper),
           fmt::format("[{}, {}]", lower, upper), "a range that contains 0");
    return {std::min(upper, kNoClamp), std::min(-lower, kNoClamp)};
  }

  /// Returns a number of the anti-windup that may not be negative; 0 if the file does not give it.
  double not_negative(const std::string& joint, const char* key) const {
    const PlacedValue* value = of_joint(joint, key);
    if (value == nullptr || !rules_.has_strategies) return 0.0;
    const double given = finite(*value, fmt::format("gains/{}/{}", joint, key));
    if (given < 0.0)
      fail(value->line, fmt::format("{} of {} is {}; it may not be negative", key, joint, given), value->text,
           "0 or more");
    return given;
  }

  /// Returns the number of the kind of anti-windup (gain jtc_antiwindup).
  double anti_windup(const std::string& joint) const {
    const PlacedValue* strategy = of_joint(joint, "antiwindup_strategy");
    if (strategy != nullptr && rules_.has_strategies) {
      const auto* const found = std::find(kStrategies.begin(), kStrategies.end(), strategy->text);
      if (found == kStrategies.end())
        fail(strategy->line,
             fmt::format("antiwindup_strategy of {} is {}; expected one of {}", joint, shown(strategy->text),
                         fmt::join(kStrategies, ", ")),
             strategy->text, fmt::format("one of: {}", fmt::join(kStrategies, ", ")));
      return 1.0 + static_cast<double>(found - kStrategies.begin());
    }
    if (controller().ros2) return rules_.has_strategies ? 1.0 : 0.0;
    const PlacedValue* given = of_joint(joint, "antiwindup");
    if (given == nullptr || given->text == "false" || given->text == "False") return 0.0;
    if (given->text == "true" || given->text == "True") return 1.0;
    fail(given->line,
         fmt::format("antiwindup of {} is {}; expected true or false", joint, shown(given->text)),
         given->text, "true or false");
  }

 private:
  const RosRules& rules_ = rules_of(distro_of(controller()));
};

}  // namespace

RosDistro distro_of(const RosController& controller) {
  return controller.distro.value_or(controller.ros2 ? RosDistro::kJazzy : RosDistro::kNoetic);
}

bool jumps_between_points(const RosController& controller) {
  if (controller.layout != GainLayout::kPidByJoint || !controller.ros2 || !controller.parameters)
    return false;
  const PlacedValue* method = controller.parameters->find("interpolation_method");
  return method != nullptr && method->text == "none";
}

Gains joint_trajectory_gains(const RosController& controller, const std::string& file,
                             const std::vector<std::string>& joints) {
  const Reader reader(controller, file);
  reader.refuse_other_joints(joints);
  const std::string kind = reader.kind();
  const auto n = static_cast<Eigen::Index>(joints.size());
  Gains gains;
  change_controller(gains, kind, static_cast<int>(n));
  gains.joint_space_gains_p = gains.joint_space_gains_d = JointVector::Zero(n);
  gains.force_control_gains = JointVector::Zero(n);
  std::optional<double> anti_windup;
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::string& joint = joints[static_cast<std::size_t>(k)];
    for (const char* name : kGainNames) {
      const PlacedValue* value = reader.of_joint(joint, name);
      jtc_gain(gains, name)[k] =
          value == nullptr ? 0.0 : reader.finite(*value, fmt::format("gains/{}/{}", joint, name));
    }
    const auto [upper, lower] = reader.clamps(joint);
    jtc_gain(gains, "i_clamp")[k] = upper;
    jtc_gain(gains, "i_clamp_min")[k] = lower == upper ? 0.0 : lower;
    const PlacedValue* forward = reader.feed_forward(joint);
    jtc_gain(gains, "ff_velocity_scale")[k] =
        forward == nullptr ? 0.0 : reader.finite(*forward, "feed-forward of " + joint);
    jtc_gain(gains, "angle_wraparound")[k] = reader.wraps(joint) ? 1.0 : 0.0;
    std::tie(jtc_gain(gains, "u_clamp_max")[k], jtc_gain(gains, "u_clamp_min")[k]) =
        reader.output_clamps(joint);
    jtc_gain(gains, "tracking_time")[k] = reader.not_negative(joint, "tracking_time_constant");
    jtc_gain(gains, "error_deadband")[k] = reader.not_negative(joint, "error_deadband");
    const double own_anti_windup = reader.anti_windup(joint);
    if (anti_windup && *anti_windup != own_anti_windup) {
      reader.fail(
          controller.parameters->find("gains")->line,
          "not all joints have the same anti-windup; give all joints the same setting, because armtune "
          "cannot simulate a mixture");
    }
    anti_windup = own_anti_windup;
  }
  jtc_gain(gains, "antiwindup")[0] = anti_windup.value_or(1.0);
  jtc_gain(gains, "distro")[0] = static_cast<double>(distro_of(controller));
  return gains;
}

std::vector<PlacedGain> placed_trajectory_gains(const RosController& controller, const std::string& file,
                                                const Gains& gains, const std::vector<std::string>& joints) {
  const JointParameters parameters(controller, file);
  std::vector<PlacedGain> placed;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const std::string& joint = joints[k];
    const auto place = static_cast<Eigen::Index>(k);
    const auto entry = [&](const char* gain) {
      return fmt::format("{}/{}", jtc_name(gains.controller, gain), joint);
    };
    const auto add = [&](const char* key, double value) {
      placed.push_back({parameters.of_joint(joint, key), {key, joint}, value, entry(key)});
    };
    for (const char* name : kGainNames) add(name, jtc_gain(gains, name)[place]);
    const double clamp = jtc_gain(gains, "i_clamp")[place];
    add("i_clamp", clamp);
    add("i_clamp_max", clamp);
    add("i_clamp_min", -jtc_lower_i_clamp(gains, place));
    placed.push_back({parameters.feed_forward(joint),
                      {"feed-forward", joint},
                      jtc_gain(gains, "ff_velocity_scale")[place],
                      entry("ff_velocity_scale")});
  }
  return placed;
}

}  // namespace armtune::internal
