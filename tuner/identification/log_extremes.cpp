#include "tuner/identification/log_extremes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "armtune/error.hpp"
#include "tuner/identification/effort_words.hpp"

namespace armtune::internal {
namespace {

constexpr double kShare = 0.05;        ///< share of the instants that may be outside, such as spikes
constexpr double kLeastMotion = 0.01;  ///< smallest range of the position of a joint that moves [rad, m]
constexpr double kOtherUnit = 3.0;     ///< above this multiple of the largest limit, the unit is wrong
constexpr double kRounding = 1e-9;     ///< relative change that filtering makes in a constant torque
constexpr double kOverRange = 0.1;     ///< allowed excess over a position limit, as a share of the range
constexpr double kOverRate = 2.0;      ///< allowed velocity, as a multiple of its limit
constexpr double kOverEffort = 2.0;    ///< allowed torque, as a multiple of its limit
/// If the torques are in another unit, a moving arm needs at least this share of some joint's effort limit
/// once they are converted. Torques that are ten times too large, or those of a stronger arm, give a smaller
/// share.
constexpr double kLeastEffort = 0.05;
constexpr double kDegree = M_PI / 180.0;

struct Unit {
  double scale;
  const char* name;
};

/// Returns the absolute value that a share of kShare of the instants exceeds.
double high_value(const std::vector<LogInstant>& instants,
                  const std::function<double(const LogInstant&)>& value) {
  std::vector<double> sizes;
  sizes.reserve(instants.size());
  for (const LogInstant& at : instants) sizes.push_back(std::abs(value(at)));
  const auto place =
      sizes.begin() + static_cast<std::ptrdiff_t>((1.0 - kShare) * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), place, sizes.end());
  return *place;
}

/// Returns "; if the log is in degrees, set `scale: ...`", with the first unit that brings the value below
/// the limit. Without such a unit, it advises to check the columns.
std::string hint(double value, double limit, std::initializer_list<Unit> units, const char* key) {
  for (const Unit& unit : units) {
    if (value * unit.scale > limit) continue;
    return fmt::format("; if the log is in {}, set `scale: {}` for `{}` in the column map (--columns FILE)",
                       unit.name, unit.scale, key);
  }
  return fmt::format("; check the {} columns, their units, and --robot", key);
}

class LimitCheck {
 public:
  LimitCheck(const RobotModel& model, const std::vector<LogInstant>& instants, const std::string& logs,
             int joint)
      : model_(model),
        info_(model.joints[static_cast<std::size_t>(joint)]),
        effort_(effort_words(model, joint)),
        revolute_(model.chain.motion[static_cast<std::size_t>(joint)] == JointMotion::kRevolute),
        instants_(instants),
        logs_(logs),
        joint_(joint) {}

  void position_unit() const {
    if (!info_.limits.has_position) return;
    const double size = high_value(instants_, [&](const LogInstant& at) { return at.q[joint_]; });
    const double largest = std::max(std::abs(info_.limits.lower), std::abs(info_.limits.upper));
    if (size <= kOtherUnit * largest) return;
    fail("position", {outside(size) + (revolute_ ? hint(size, largest, {{kDegree, "degrees"}}, "position")
                                                 : hint(size, largest, {{1e-3, "millimetres"}}, "position")),
                      shown(size), position_limits()});
  }

  void position() const {
    if (!info_.limits.has_position) return;
    const double center = 0.5 * (info_.limits.lower + info_.limits.upper);
    const double half = 0.5 * (info_.limits.upper - info_.limits.lower);
    const double off = high_value(instants_, [&](const LogInstant& at) { return at.q[joint_] - center; });
    if (off <= half * (1.0 + 2.0 * kOverRange)) return;
    const double size = high_value(instants_, [&](const LogInstant& at) { return at.q[joint_]; });
    fail("position",
         {outside(size) +
              "; check the joint's zero position, the sign and the column of its position, and --robot",
          shown(size), position_limits()});
  }

  void velocity() const {
    const double size = high_value(instants_, [&](const LogInstant& at) { return at.qd[joint_]; });
    const double limit = kOverRate * info_.limits.velocity;
    if (size <= limit) return;
    fail("position",
         {fmt::format("its position changes by {:.4g} {}/s, but its velocity limit in the robot file is "
                      "{:.4g} {}/s",
                      size, unit(), info_.limits.velocity, unit()) +
              (revolute_ ? hint(size, limit, {{kDegree, "degrees"}}, "position")
                         : hint(size, limit, {{1e-3, "millimetres"}}, "position")),
          shown(size), fmt::format("{:.4g} {}/s", info_.limits.velocity, unit())});
  }

  void torque() const {
    const double size = high_value(instants_, [&](const LogInstant& at) { return at.torque[joint_]; });
    const double limit = kOverEffort * info_.limits.effort;
    if (size <= limit) return;
    const double thousandth = some_thousandth_is_felt() ? 1e-3 : 1.0;
    fail("torque", {fmt::format("its {} is {:.4g} {}, but its effort limit in the robot file is {:.4g} {}",
                                effort_.name, size, effort_.unit, info_.limits.effort, effort_.unit) +
                        hint(size, limit, {{thousandth, effort_.thousandth}}, "torque"),
                    shown(size), fmt::format("{:.4g} {}", info_.limits.effort, effort_.unit)});
  }

  void torque_is_there() const {
    const auto [low, high] = range([&](const LogInstant& at) { return at.torque[joint_]; });
    if (low == 0.0 && high == 0.0)
      fail("torque", {fmt::format("its {} is 0 in every row; log this signal, or check the torque columns",
                                  effort_.name),
                      "0"});
    const auto [first, last] = range([&](const LogInstant& at) { return at.q[joint_]; });
    if (high - low > kRounding * std::max(std::abs(low), std::abs(high)) || last - first <= kLeastMotion)
      return;
    fail("torque", {fmt::format("its {} is {:.4g} {} in every row, although the joint moves; the column may "
                                "be frozen, or of another signal",
                                effort_.name, high, effort_.unit),
                    shown(high), "a torque that changes with the motion"});
  }

 private:
  /// Returns the least and the largest value.
  std::pair<double, double> range(const std::function<double(const LogInstant&)>& value) const {
    std::pair<double, double> found = {value(instants_.front()), value(instants_.front())};
    for (const LogInstant& at : instants_)
      found = {std::min(found.first, value(at)), std::max(found.second, value(at))};
    return found;
  }
  std::string outside(double size) const {
    return fmt::format(
        "its position is as large as {:.4g} {}, but its limits in the robot file are {:.4g} and {:.4g} {}",
        size, unit(), info_.limits.lower, info_.limits.upper, unit());
  }
  /// Returns true if a thousandth of some joint's torque would be enough to move an arm of this strength.
  bool some_thousandth_is_felt() const {
    for (int j = 0; j < static_cast<int>(model_.joints.size()); ++j) {
      const double size = high_value(instants_, [j](const LogInstant& at) { return at.torque[j]; });
      if (1e-3 * size > kLeastEffort * model_.joints[static_cast<std::size_t>(j)].limits.effort) return true;
    }
    return false;
  }
  const char* unit() const { return revolute_ ? "rad" : "m"; }
  static std::string shown(double value) { return fmt::format("{:.4g}", value); }
  std::string position_limits() const {
    return fmt::format("{:.4g} to {:.4g} {}", info_.limits.lower, info_.limits.upper, unit());
  }
  /// quantity: position or torque, which with the joint's name is the key of the error.
  [[noreturn]] void fail(const char* quantity, const InputFault& fault) const {
    throw InputError(InputPlace{logs_, 0, fmt::format("{}/{}", info_.name, quantity)},
                     fmt::format("joint {}: {}", info_.name, fault.problem))
        .with_value(fault.value, fault.limit);
  }

  const RobotModel& model_;
  const JointInfo& info_;
  EffortWords effort_;
  bool revolute_;
  const std::vector<LogInstant>& instants_;
  const std::string& logs_;
  int joint_;
};

}  // namespace

void check_motion(const RobotModel& model, const std::vector<LogInstant>& instants, const std::string& logs) {
  if (instants.empty()) return;
  JointVector lowest = instants.front().q;
  JointVector highest = lowest;
  for (const LogInstant& at : instants) {
    lowest = lowest.cwiseMin(at.q);
    highest = highest.cwiseMax(at.q);
  }
  if ((highest - lowest).maxCoeff() > kLeastMotion) return;
  throw InputError(
      InputPlace{logs},
      fmt::format(
          "no joint moves by more than {} rad or m, so that the masses of {} cannot be identified; log a "
          "motion of all joints, for example one from `armtune excite`, or check the position columns",
          kLeastMotion, model.name))
      .with_value(fmt::format("{:.4g}", (highest - lowest).maxCoeff()),
                  fmt::format("above {} rad or m", kLeastMotion));
}

void check_units(const RobotModel& model, const std::vector<LogInstant>& instants, const std::string& logs) {
  if (instants.empty()) return;
  using Check = void (LimitCheck::*)() const;
  // Each check runs over all joints before the next check, because a wrong unit shows in most joints.
  for (const Check check : {&LimitCheck::torque_is_there, &LimitCheck::position_unit, &LimitCheck::velocity,
                            &LimitCheck::torque}) {
    for (int j = 0; j < model.n(); ++j) (LimitCheck(model, instants, logs, j).*check)();
  }
}

void check_positions(const RobotModel& model, const std::vector<LogInstant>& instants,
                     const std::string& logs) {
  for (int j = 0; j < model.n(); ++j) LimitCheck(model, instants, logs, j).position();
}

}  // namespace armtune::internal
