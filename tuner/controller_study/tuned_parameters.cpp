#include "tuner/controller_study/tuned_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "sim/controller_files/changed_gains.hpp"
#include "sim/yaml/quoted.hpp"
#include "tuner/controller_study/shared_numbers.hpp"

namespace armtune::internal {
namespace {

constexpr double kLeastStiffness = 0.2;  // of the start value
constexpr double kMostDamping = 5.0;     // times the damping that fits the arm's inertia

/// Gains that UR robots accept within fixed bounds only.
struct AcceptedRange {
  std::string_view gain;
  double lower, upper;
};
constexpr std::array kAccepted = {AcceptedRange{"servo_gain", 100.0, 2000.0},
                                  AcceptedRange{"servo_lookahead_time", 0.03, 0.2}};

/// Returns false for a number that belongs to a rotation of the tool, if no motion gives its orientation.
bool has_effect(const ControllerInFile& from, const GainField& field, std::size_t k) {
  return from.turns || std::get<OwnGain>(field.member).shape != GainShape::kTask || k < 3;
}

/// Writes the lines of the parameters, field by field.
class ParameterLines {
 public:
  /// first: gains that fit the arm's inertia.
  ParameterLines(const ControllerInFile& from, const std::vector<double>& most_stiffness, const Gains& first)
      : from_(from), most_stiffness_(most_stiffness), gains_(from.gains), first_(first) {}

  void add(const GainField& field) {
    const JointVector& values = values_of(gains_, field);
    if (values.size() == 1 && !is_in_file(from_, field, 0)) return;
    if (is_stiffness(field) && most_stiffness_.empty()) return;
    const std::vector<std::string> parts = component_names(field, from_.joints);
    if (is_tuned_as_a_whole(field, parts.size())) {
      const std::string accepted = accepted_bounds(field, values[0]);
      made_.lines += fmt::format("  - {{name: {}{}}}{}\n", field.name, accepted,
                                 accepted.empty() ? "" : "   # what UR robots accept");
      return;
    }
    for (std::size_t k = 0; k < parts.size(); ++k) add_number(field, k, parts[k]);
  }

  TunedParameters take() {
    // No gain may be named behind the first link.
    made_.lines += links_;
    std::vector<const SharedNumber*> numbers;
    for (const auto& [number, gain] : tuned_) numbers.push_back(number);
    if (!numbers.empty()) made_.note = sharing_note(from_, numbers);
    return std::move(made_);
  }

 private:
  bool is_stiffness(const GainField& field) const {
    return field.name == std::string_view(stiffness_of_controller(from_));
  }
  double value(const GainField& field, std::size_t k) {
    return values_of(gains_, field)[static_cast<Eigen::Index>(k)];
  }
  bool is_tuned(const GainField& field, std::size_t k) {
    return value(field, k) != 0.0 && is_in_file(from_, field, static_cast<Eigen::Index>(k)) &&
           has_effect(from_, field, k);
  }
  bool is_tuned_as_a_whole(const GainField& field, std::size_t count) {
    if (is_stiffness(field) || field.search == SearchRange::kNone) return false;
    for (std::size_t k = 0; k < count; ++k) {
      if (!is_tuned(field, k) || number_of(shared_, field, k) != nullptr) return false;
    }
    return true;
  }

  static std::string accepted_bounds(const GainField& field, double start) {
    const auto* accepted = std::find_if(kAccepted.begin(), kAccepted.end(),
                                        [&field](const AcceptedRange& a) { return a.gain == field.name; });
    if (accepted == kAccepted.end()) return "";
    return fmt::format(", lower: {}, upper: {}", std::min(accepted->lower, start),
                       std::max(accepted->upper, start));
  }

  /// Returns the largest value of a stiffness that keeps every stiffness with the same number within its
  /// bound.
  double most_stiffness(const GainField& field, std::size_t k, const SharedNumber* number) const {
    double most = most_stiffness_[k];
    if (number == nullptr) return most;
    const auto own = std::find_if(number->begin(), number->end(), [k, &field](const SharedGain& g) {
      return g.field == &field && g.component == k;
    });
    for (const SharedGain& other : *number) {
      if (other.field == &field)
        most = std::min(most, most_stiffness_[other.component] * own->factor / other.factor);
    }
    return most;
  }

  std::string bounds(const GainField& field, std::size_t k, const SharedNumber* number) {
    const double start = value(field, k);
    if (is_stiffness(field))
      return fmt::format(", lower: {:.6g}, upper: {:.6g}", kLeastStiffness * start,
                         most_stiffness(field, k, number));
    if (field.search == SearchRange::kNone)
      return fmt::format(", lower: {:.6g}, upper: {:.6g}", field.lower_factor * start,
                         field.upper_factor * start);
    return accepted_bounds(field, start);
  }

  void add_number(const GainField& field, std::size_t k, const std::string& part) {
    const SharedNumber* number = number_of(shared_, field, k);
    if (number != nullptr && is_taken(*number, field)) return;
    if (is_tuned(field, k)) {
      add_line(field, k, part, bounds(field, k, number), number);
    } else if (needs_damping(field, k) && has_room_for_damping(field, k, number)) {
      made_.undamped.push_back(part);
      add_line(field, k, part,
               fmt::format(", lower: 0, upper: {:.4g}, scale: linear",
                           kMostDamping * jtc_gain(first_, "d")[static_cast<Eigen::Index>(k)]),
               number);
    }
  }

  /// True if another gain of the number is tuned already, or if one is a stiffness, which only bounds of its
  /// own may change.
  bool is_taken(const SharedNumber& number, const GainField& field) const {
    return std::any_of(tuned_.begin(), tuned_.end(), [&](const auto& t) { return t.first == &number; }) ||
           (!is_stiffness(field) && std::any_of(number.begin(), number.end(), [this](const SharedGain& gain) {
             return is_stiffness(*gain.field);
           }));
  }

  void add_line(const GainField& field, std::size_t k, const std::string& part, const std::string& bounds,
                const SharedNumber* number) {
    made_.lines += fmt::format("  - {{name: {}{}}}\n", yaml::quoted(entry_name(field, part)), bounds);
    if (number == nullptr) return;
    for (const SharedGain& gain : *number) {
      if (gain.field != &field || gain.component != k) continue;
      tuned_.emplace_back(number, &gain);
      links_ += link_lines(*number, gain);
    }
  }

  /// True for a d of 0 of a joint that is commanded by effort. Drives that follow velocities or positions
  /// have damping of their own.
  bool needs_damping(const GainField& field, std::size_t k) {
    return gains_.controller == kJointTrajectoryController &&
           &values_of(gains_, field) == &jtc_gain(gains_, "d") && value(field, k) == 0.0 &&
           jtc_gain(gains_, "p")[static_cast<Eigen::Index>(k)] != 0.0;
  }

  /// True if the file has a place for the d of joint k and of those that share it.
  bool has_room_for_damping(const GainField& field, std::size_t k, const SharedNumber* number) const {
    Gains damped = from_.gains;
    values_of(damped, field)[static_cast<Eigen::Index>(k)] = 1.0;
    if (number != nullptr) {
      for (const SharedGain& gain : *number)
        values_of(damped, *gain.field)[static_cast<Eigen::Index>(gain.component)] = 1.0;
    }
    try {
      with_gains(from_.text, from_.controller, from_.file, damped, from_.joints);
    } catch (const InputError&) {
      return false;
    }
    return true;
  }

  const ControllerInFile& from_;
  const std::vector<double>& most_stiffness_;
  Gains gains_;
  const Gains& first_;
  std::vector<SharedNumber> shared_ = shared_numbers(from_);
  std::vector<std::pair<const SharedNumber*, const SharedGain*>> tuned_;  ///< each number with its tuned gain
  std::string links_;
  TunedParameters made_;
};

}  // namespace

TunedParameters tuned_parameters(const ControllerInFile& from, const RobotModel& arm, const JointVector& q,
                                 const std::vector<double>& most_stiffness) {
  Gains first = from.gains;
  controller_kind(first.controller).start(arm, q, first);
  ParameterLines lines(from, most_stiffness, first);
  for (const GainField* field : searched_fields(from)) lines.add(*field);
  return lines.take();
}

}  // namespace armtune::internal
