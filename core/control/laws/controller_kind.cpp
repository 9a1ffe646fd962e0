#include "core/control/laws/controller_kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

#include "armtune/error.hpp"
#include "core/common/nearest.hpp"
#include "core/control/laws/adaptive_law.hpp"
#include "core/control/laws/cartesian_impedance_law.hpp"
#include "core/control/laws/computed_torque_law.hpp"
#include "core/control/laws/first_gains.hpp"
#include "core/control/laws/impedance_law.hpp"
#include "core/control/laws/joint_impedance_law.hpp"
#include "core/control/laws/joint_pd_law.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "core/control/laws/position_streaming_law.hpp"

namespace armtune::internal {
namespace {

struct Registered {
  ControllerKind kind;
  std::vector<GainField> fields;  ///< all gains of this kind
};

/// A deque, so that references to its elements stay valid.
using Registry = std::deque<Registered>;

/// Returns values without effect, for the gains that a kind of controller does not have.
Gains without_law() {
  Gains gains;
  gains.interpolation_gain_scale = 1.0;
  gains.adaptation_gain = 0.0;
  return gains;
}

bool is_word(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

const GainField* find_field(const std::vector<GainField>& fields, const std::string& name) {
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const GainField& f) { return f.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

/// Calls `fail` if the default or the search range of a gain cannot be used.
template <typename Fail>
void check_numbers(const GainField& field, const Fail& fail) {
  if (!std::isfinite(field.otherwise) || field.otherwise < 0.0 ||
      (field.strictly_positive && field.otherwise == 0.0)) {
    const std::string limit =
        fmt::format("finite and {}", field.strictly_positive ? "above zero" : "not negative");
    fail(fmt::format("the default of gain '{}' is {}; it must be {}", field.name, field.otherwise, limit),
         fmt::to_string(field.otherwise), limit);
  }
  if (!(field.lower_factor > 0.0 && field.lower_factor < field.upper_factor)) {
    fail(
        fmt::format(
            "the search range of gain '{}' is {} to {} times its start value; the first factor must be above "
            "zero, and the second larger than the first",
            field.name, field.lower_factor, field.upper_factor),
        fmt::format("{} to {}", field.lower_factor, field.upper_factor),
        "a first factor above zero, and a larger second factor");
  }
}

void add(ControllerKind kind, Registry& registry) {
  const auto fail = [&kind](const std::string& what, const std::string& value = {},
                            const std::string& limit = {}) {
    throw InputError(fmt::format("controller '{}': {}", kind.name, what)).with_value(value, limit);
  };
  if (!is_word(kind.name))
    fail("its name must consist of letters, digits and underscores", kind.name,
         "letters, digits and underscores");
  if (!kind.make) fail("it has no law; set ControllerKind::make");
  for (const Registered& r : registry) {
    if (r.kind.name == kind.name)
      fail("this name is registered already; choose another one", kind.name, "another name");
  }
  Registered registered;
  for (const std::string& name : kind.uses) {
    const GainField* field = find_field(gain_fields(), name);
    if (field == nullptr || !field->of_law)
      fail(fmt::format("'{}' in `uses` is not a built-in gain of a control law; declare a new gain in `own`",
                       name),
           name, "a built-in gain of a control law");
  }
  for (const GainField& field : gain_fields()) {
    const auto& uses = kind.uses;
    if (!field.of_law || std::find(uses.begin(), uses.end(), field.name) != uses.end()) {
      registered.fields.push_back(field);
    }
  }
  for (std::size_t place = 0; place < kind.own.size(); ++place) {
    GainField field = kind.own[place];
    auto* own = std::get_if<OwnGain>(&field.member);
    if (own == nullptr)
      fail(fmt::format("gain '{}' in `own` was not made by own_gain(); make it with that function",
                       field.name));
    if (!is_word(field.name) || field.name == std::string("controller")) {
      fail(fmt::format(
               "a gain must not be called '{}'; give it a name of letters, digits and underscores other than "
               "'controller'",
               field.name),
           field.name, "letters, digits and underscores, but not 'controller'");
    }
    if (find_field(gain_fields(), field.name) != nullptr ||
        find_field(registered.fields, field.name) != nullptr) {
      fail(fmt::format("there is a gain called '{}' already; choose another name", field.name), field.name,
           "another name");
    }
    check_numbers(field, fail);
    own->place = place;
    registered.fields.push_back(field);
  }
  registered.kind = std::move(kind);
  registry.push_back(std::move(registered));
}

Registry& registry() {
  static Registry kinds = [] {
    Registry built_in;
    add(adaptive_controller(), built_in);
    add(joint_pd_controller(), built_in);
    add(computed_torque_controller(), built_in);
    add(impedance_controller(), built_in);
    add(joint_impedance_controller(), built_in);
    add(cartesian_impedance_controller(), built_in);
    add(joint_trajectory_controller(), built_in);
    add(joint_trajectory_velocity_controller(), built_in);
    add(position_streaming_controller(), built_in);
    return built_in;
  }();
  return kinds;
}

const Registered& registered(const std::string& name) {
  std::vector<std::string> names;
  for (const Registered& r : registry()) {
    if (r.kind.name == name) return r;
    names.push_back(r.kind.name);
  }
  const std::string known = fmt::format("{}", fmt::join(names, ", "));
  throw InputError(fmt::format("'{}' is not a controller{}; the controllers are: {}", name,
                               suggestion(name, names), known))
      .with_value(name, "one of: " + known);
}

std::size_t place_of(const Gains& gains, const std::string& name) {
  const GainField* field = find_field(fields_of(gains), name);
  const auto* own = field == nullptr ? nullptr : std::get_if<OwnGain>(&field->member);
  if (own == nullptr || own->place >= gains.own.size()) {
    throw InputError(fmt::format("controller '{}' does not declare a gain '{}' in `own`; check the name",
                                 gains.controller, name));
  }
  return own->place;
}

}  // namespace

GainField own_gain(GainShape shape, const char* name, const char* unit, const char* meaning, double otherwise,
                   double lower_factor, double upper_factor) {
  GainField field{name, unit, meaning, OwnGain{shape, 0}, false};
  field.search = SearchRange::kFactor;
  field.lower_factor = lower_factor;
  field.upper_factor = upper_factor;
  field.otherwise = otherwise;
  field.loop = LoopGain::kFactor;
  return field;
}

GainField positive(GainField gain) {
  gain.strictly_positive = true;
  return gain;
}

GainField not_in_loop(GainField gain) {
  gain.loop = LoopGain::kNone;
  return gain;
}

GainField root_in_loop(GainField gain) {
  gain.loop = LoopGain::kRoot;
  return gain;
}

GainField bounded(GainField gain) {
  gain.search = SearchRange::kBounded;
  return gain;
}

GainField not_tuned(GainField gain) {
  gain.search = SearchRange::kNone;
  return not_in_loop(gain);
}

void register_controller(ControllerKind kind) {
  add(std::move(kind), registry());
}

const ControllerKind& controller_kind(const std::string& name) {
  return registered(name).kind;
}

std::vector<const ControllerKind*> controller_kinds() {
  std::vector<const ControllerKind*> kinds;
  for (const Registered& r : registry()) kinds.push_back(&r.kind);
  return kinds;
}

const std::vector<GainField>& fields_of(const ControllerKind& kind) {
  return registered(kind.name).fields;
}

const std::vector<GainField>& fields_of(const Gains& gains) {
  return registered(gains.controller).fields;
}

void scale_loop_gains(Gains& gains, double factor) {
  for (const GainField& field : fields_of(gains)) {
    if (field.loop == LoopGain::kNone) continue;
    const double own_factor = field.loop == LoopGain::kRoot ? std::sqrt(factor) : factor;
    for (double& number : numbers(gains, field)) number *= own_factor;
  }
}

const JointVector& own(const Gains& gains, const std::string& name) {
  return gains.own[place_of(gains, name)];
}

JointVector& own(Gains& gains, const std::string& name) {
  return gains.own[place_of(gains, name)];
}

void change_controller(Gains& gains, const std::string& name, int n) {
  const ControllerKind& kind = controller_kind(name);
  const Gains nothing = without_law();
  gains.controller = name;
  for (const GainField& field : gain_fields()) {
    if (find_field(fields_of(kind), field.name) != nullptr) continue;
    std::visit(
        [&](auto member) {
          if constexpr (!std::is_same_v<decltype(member), OwnGain>) gains.*member = nothing.*member;
        },
        field.member);
  }
  gains.own.clear();
  for (const GainField& field : kind.own) {
    const GainShape shape = std::get<OwnGain>(field.member).shape;
    gains.own.push_back(JointVector::Constant(size_of(shape, n), field.otherwise));
  }
}

Gains convert_gains(const ControllerKind& kind, const Gains& gains, const RobotModel& robot,
                    const JointVector& q) {
  if (kind.name == gains.controller) return gains;
  Gains other = gains;
  change_controller(other, kind.name, robot.n());
  const auto uses = [&kind](const char* name) {
    return std::find(kind.uses.begin(), kind.uses.end(), name) != kind.uses.end();
  };
  // Set the gains that the previous kind did not have.
  if (uses("task_space_gains_p")) first_references(other);
  if (uses("task_space_gains_d") && other.task_space_gains_d.size() == 0) {
    other.task_space_gains_d = kFirstRate * joint_inertia(robot, q);
  }
  if (uses("task_space_gains_i") && !kind.learns) {
    // Without adaptation, the integral must correct the errors of the model.
    const Vec6 enough = kFirstIntegralShare * other.task_space_gains_p.cwiseAbs2();
    other.task_space_gains_i = other.task_space_gains_i.cwiseMax(enough);
  }
  if (kind.start) kind.start(robot, q, other);
  return other;
}

}  // namespace armtune::internal
