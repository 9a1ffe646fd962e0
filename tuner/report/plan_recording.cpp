#include "tuner/report/plan_recording.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <utility>

#include "armtune/error.hpp"
#include "tuner/record/declaration.hpp"
#include "tuner/record/limit_kind.hpp"
#include "tuner/record/words.hpp"
#include "tuner/report/run_builder.hpp"

namespace armtune::internal::report {
namespace {

/// A quantity of a joint, with its unit for a joint that turns and for one that slides.
struct Quantity {
  const char* name;
  const char* turning;
  const char* sliding;
};
constexpr Quantity kQuantities[] = {{"position", "rad", "m"},
                                    {"velocity", "rad/s", "m/s"},
                                    {"acceleration", "rad/s^2", "m/s^2"},
                                    {"jerk", "rad/s^3", "m/s^3"},
                                    {kept_words::kTorque, "N m", "N"}};

/// Returns a plot such as "joint_torque" or "slide_torque". They are separate because their units differ.
std::string joint_group(bool slides, const std::string& quantity) {
  return (slides ? "slide_" : "joint_") + quantity;
}

bool slides(const Arm* arm, const std::string& joint) {
  if (arm == nullptr) return false;
  const auto found = std::find_if(arm->joints.begin(), arm->joints.end(),
                                  [&joint](const ArmJoint& one) { return one.name == joint; });
  return found != arm->joints.end() && found->prismatic;
}

/// Returns the kind of limit that a word in limits.csv names.
LimitKind kind_of_limit(const std::string& word) {
  const std::vector<std::string> words = record::names_of<LimitKind>();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end())
    throw InputError("limits.csv: '" + word + "' is not a kind of limit; plan the motion again");
  return static_cast<LimitKind>(found - words.begin());
}

/// Sets the plot and the column in which a limit is drawn.
void place(PlanLimit& limit, LimitKind kind, const Arm* arm) {
  if (kind == LimitKind::kToolPath) {
    limit.group = "position_error";
    limit.column = "error/position/" + limit.part;
  } else if (kind == LimitKind::kGaze) {
    limit.group = "gaze";
    limit.column = "gaze/angle";
  } else if (is_distance(kind)) {
    limit.group = "clearance";
    limit.column = kind == LimitKind::kLinks      ? "clearance/self"
                   : kind == LimitKind::kFloor    ? "clearance/floor"
                   : kind == LimitKind::kCellPart ? "clearance/cell"
                                                  : "obstacle/distance";
  } else {
    limit.group = joint_group(slides(arm, limit.part), name(kind));
    limit.column = "joint/" + limit.part + "/" + name(kind);
  }
}

/// Reads time intervals such as "8.01:8.05 8.2:8.21", and counts them from `start`.
std::vector<std::pair<double, double>> stretches(const std::string& text, double start) {
  std::vector<std::pair<double, double>> found;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t colon = word.find(':');
    double ends[2] = {0.0, 0.0};
    const char* const begin = word.data();
    const char* const middle = begin + std::min(colon, word.size());
    const char* const end = begin + word.size();
    const bool first = std::from_chars(begin, middle, ends[0]).ptr == middle && middle != begin;
    const bool second = middle != end && std::from_chars(middle + 1, end, ends[1]).ptr == end;
    if (!first || !second)
      throw InputError("limits.csv: '" + word + "' is not a time interval; expected FROM:TO in seconds");
    found.emplace_back(ends[0] - start, ends[1] - start);
  }
  return found;
}

}  // namespace

std::string limit_words(const std::string& limit, const std::string& part) {
  if (part.empty() || limit == kept_words::kGaze || limit == kept_words::kPathCoordinate)
    return limit;  // there is only one
  return limit + (limit == kept_words::kToolPath ? " along " : " of ") + part;
}

Run plan_run_of(const NumberTable& motion, const SceneScenario* scenario, const Arm* arm,
                const Resolution& resolution) {
  RunBuilder builder(motion, resolution);
  builder.add_task_columns();
  for (const std::string& joint : joints_of(motion)) {
    const std::string prefix = "joint/" + joint + "/";
    const bool sliding = slides(arm, joint);
    for (const Quantity& quantity : kQuantities) {
      const std::string name = prefix + quantity.name;
      if (const auto column = motion.find(name))
        builder.add(name, joint_group(sliding, quantity.name), sliding ? quantity.sliding : quantity.turning,
                    motion.numbers(*column));
    }
    for (const char* ratio : {"velocity_ratio", "torque_ratio"})
      builder.add(prefix + ratio, ratio, "1", motion.numbers(motion.column(prefix + ratio)));
  }
  builder.add_replay(scenario, arm);
  return std::move(builder.run);
}

std::vector<PlanLimit> plan_limits_of(const CsvTable& limits, const Arm* arm, double start) {
  std::vector<PlanLimit> found;
  found.reserve(limits.rows());
  for (std::size_t r = 0; r < limits.rows(); ++r) {
    const auto text = [&](const char* column) { return limits.text(r, limits.column(column)); };
    const auto number = [&](const char* column) { return limits.number(r, limits.column(column)); };
    PlanLimit limit;
    limit.limit = text("limit");
    limit.part = text("part");
    limit.words = limit_words(limit.limit, limit.part);
    limit.unit = text("unit");
    limit.lower = number("lower");
    limit.upper = number("upper");
    limit.from = number("from") - start;
    limit.to = number("to") - start;
    limit.at_knots = number("at_knots");
    limit.between_knots = number("between_knots");
    limit.active = number("active");
    limit.strength = number("strength");
    limit.active_lower = stretches(text("active_lower"), start);
    limit.active_upper = stretches(text("active_upper"), start);
    place(limit, kind_of_limit(text("kind")), arm);
    found.push_back(std::move(limit));
  }
  return found;
}

}  // namespace armtune::internal::report
