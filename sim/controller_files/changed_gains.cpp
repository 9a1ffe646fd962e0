#include "sim/controller_files/changed_gains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <variant>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/controller_files/parameter_file.hpp"
#include "sim/controller_files/parameter_reader.hpp"
#include "sim/yaml/decimal.hpp"

namespace armtune::internal {
namespace {

using yaml::PlacedValue;

/// Returns true if a map is, or contains, the parameters of a controller or of a node of ROS 2.
bool holds_controller(const PlacedValue& value) {
  return std::any_of(value.entries.begin(), value.entries.end(), [](const yaml::PlacedEntry& entry) {
    return entry.key == "type" || entry.key == "gains" || entry.key == "k_gains" ||
           entry.key == "ros__parameters" || (!entry.alias && holds_controller(*entry.value));
  });
}

/// True for an outermost entry with an anchor and without a controller, such as "defaults: &defaults
/// {p: 1.0}". It only defines what aliases and merge keys use.
bool only_defines(const yaml::PlacedEntry& entry) {
  return !entry.alias && entry.value->anchored && !holds_controller(*entry.value);
}

/// Counts the places of the whole file at which a value is used, including aliases and merge keys.
class Uses {
 public:
  explicit Uses(const RosController& controller) {
    const PlacedValue& root = *controller.all;
    visit(root);
    uses_[&root] = 1.0;
    const bool may_define = controller.layout != GainLayout::kMapped;
    // In reverse order, parents come before children.
    for (auto value = order_.rbegin(); value != order_.rend(); ++value) {
      for (const auto* entries : {&(*value)->items, &(*value)->entries}) {
        for (const yaml::PlacedEntry& entry : *entries) {
          if (*value == &root && may_define && only_defines(entry)) continue;
          uses_[entry.value.get()] += uses_[*value];
        }
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

  std::unordered_map<const PlacedValue*, double> uses_;  ///< not integers: nested aliases can make them huge
  std::vector<const PlacedValue*> order_;                ///< children before parents
};

/// A number of the file, and the text that replaces it.
struct Change {
  const PlacedValue* at;
  bool differs;
  double value;
  std::string text;
  std::string gain;  ///< "p of shoulder"
  bool same_place;   ///< see PlacedGain
};

/// Returns the numbers of the file, in its order, each with the text that replaces it.
std::vector<Change> changes_of(const std::vector<PlacedGain>& now, const std::vector<PlacedGain>& wanted) {
  std::vector<Change> changes;
  for (std::size_t k = 0; k < now.size(); ++k) {
    const PlacedValue* at = now[k].at;
    if (at == nullptr || !at->has_place()) continue;
    const bool differs = now[k].value != wanted[k].value;
    changes.push_back({at, differs, wanted[k].value, differs ? yaml::decimal(wanted[k].value) : at->text,
                       words(now[k].name), now[k].same_place});
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.at->begin < b.at->begin; });
  return changes;
}

/// Returns the relative error of gains that are written and read back: the factors of a map round the last
/// digit.
double rounding_of(GainLayout layout) {
  return layout == GainLayout::kMapped ? 4.0 * std::numeric_limits<double>::epsilon() : 0.0;
}

/// Returns true if the changed text reads back as the gains.
bool is_read_back(const JointVector& back, const JointVector& gains, GainLayout layout) {
  return ((back - gains).array().abs() <= rounding_of(layout) * gains.array().abs()).all();
}

/// Throws InputError if the changes of one number, [from, to), are not one and the same, or if they are not
/// all that stands for this number in the file.
void require_one_change(const std::vector<Change>& changes, std::size_t from, std::size_t to,
                        const Uses& uses, const ParameterReader& parameters) {
  const Change& change = changes[from];
  const double rounding = rounding_of(parameters.controller().layout);
  double places = 0.0;
  for (std::size_t k = from; k < to; ++k) {
    places += changes[k].same_place ? 0.0 : 1.0;
    if (std::abs(changes[k].value - change.value) <= rounding * std::abs(change.value)) continue;
    parameters.fail(
        change.at->line,
        fmt::format("the file has one common number for {} and {}, so they cannot become different; "
                    "link them in the study, or give each its own number instead of a YAML alias, "
                    "or of a list of gains in a map",
                    change.gain, changes[k].gain));
  }
  if (change.differs && uses.of(*change.at) != places) {
    parameters.fail(change.at->line,
                    fmt::format("{} cannot change, because an alias elsewhere in the file stands for the "
                                "same number; write a number in place of the alias",
                                change.gain));
  }
}

/// Throws InputError if the changed text does not read back as the gains.
void refuse_what_is_lost(const std::string& changed, const RosController& controller, const std::string& file,
                         const Gains& gains, const std::vector<std::string>& joints) {
  const Gains back = controller_gains(with_text(controller, changed, file), file, joints);
  for (const GainField& field : fields_of(gains)) {
    const auto* own_gain = std::get_if<OwnGain>(&field.member);
    if (own_gain == nullptr) continue;
    const std::size_t place = own_gain->place;
    if (is_read_back(back.own[place], gains.own[place], controller.layout)) continue;
    Eigen::Index k = 0;
    (back.own[place] - gains.own[place]).cwiseAbs().maxCoeff(&k);
    const bool each = own_gain->shape == GainShape::kJoints;
    throw InputError(
        InputPlace{file, 0, field.name},
        fmt::format("{}: {}{} must become {}, but the changed file would still give {}; {}", controller.name,
                    field.name, each ? " of " + joints[static_cast<std::size_t>(k)] : "",
                    yaml::decimal(gains.own[place][k]), yaml::decimal(back.own[place][k]),
                    controller.layout == GainLayout::kMapped
                        ? "bind this gain to a number of the file in the map"
                        : "set this gain in the file by hand"));
  }
}

}  // namespace

std::string with_gains(const std::string& text, const RosController& controller, const std::string& file,
                       const Gains& gains, const std::vector<std::string>& joints) {
  const ParameterReader parameters(controller, file);
  const Gains now = controller_gains(controller, file, joints);
  if (gains.controller != now.controller)
    throw InputError(InputPlace{file}, fmt::format("{} is a {}, but the gains are for a {}", controller.name,
                                                   now.controller, gains.controller));
  const std::vector<Change> changes =
      changes_of(placed_gains(controller, file, now, joints), placed_gains(controller, file, gains, joints));
  const Uses uses(controller);
  std::string changed;
  std::size_t copied = 0;
  for (std::size_t i = 0, next = 0; i < changes.size(); i = next) {
    const Change& change = changes[i];
    while (next < changes.size() && changes[next].at == change.at) ++next;
    require_one_change(changes, i, next, uses, parameters);
    if (!change.differs) continue;
    if (controller.layout == GainLayout::kMapped && change.at->text.find_first_of(".eE") == std::string::npos)
      parameters.fail(
          change.at->line,
          fmt::format("{} is written as the integer {}, but must become {}; write {}.0 if the program "
                      "that reads the file accepts decimals",
                      change.gain, change.at->text, change.text, change.at->text));
    changed += text.substr(copied, change.at->begin - copied) + change.text;
    copied = change.at->end;
  }
  changed += text.substr(copied);
  refuse_what_is_lost(changed, controller, file, gains, joints);
  return changed;
}

}  // namespace armtune::internal
