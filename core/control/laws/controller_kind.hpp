#pragma once
// The kinds of controllers: name, gains, law. One declaration, from which files, help, search spaces,
// journals and reports are made. A program of its own adds kinds to those that are here with
// register_controller.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/control/gain_fields.hpp"
#include "core/control/laws/arm_law.hpp"
#include "core/control/laws/torque_law.hpp"

namespace armtune::internal {

struct ControllerKind {
  std::string name;     ///< in a gains file: "controller: NAME"
  std::string meaning;  ///< one line
  /// Names of the gains of a law in Gains (GainField::of_law) that this one has.
  std::vector<std::string> uses;
  /// Gains of its own, made by own_gain.
  std::vector<GainField> own;
  std::function<std::unique_ptr<TorqueLaw>(const LawSetup&)> make;
  /// Sets own gains to begin with on an arm without any, at q (n) on its task; where there is none, they are
  /// what own_gain says.
  std::function<void(const RobotModel&, const JointVector& q, Gains&)> start;
  /// True if the law adapts its model of the arm online.
  bool learns = false;
  /// Its law, where it is written for several arms side by side.
  std::optional<ArmLawKind> lanes = {};
};

/// A gain of a kind's own, never negative. otherwise: each of its numbers where nothing else is said. It is
/// searched between lower and upper times its start, unless a study says otherwise, and multiplied where the
/// gain margin is looked for (tuner/robustness).
GainField own_gain(GainShape shape, const char* name, const char* unit, const char* meaning, double otherwise,
                   double lower_factor = 0.2, double upper_factor = 5.0);
/// The same, but zero is refused.
GainField positive(GainField gain);
/// The same, but left alone where the gain margin is looked for: a length, an angle, a scale.
GainField not_in_loop(GainField gain);
/// The same, but left alone by a search as well, unless a study names it.
GainField not_tuned(GainField gain);

/// Adds a kind, before anything is loaded. Throws InputError if its name or that of a gain is taken, or
/// `uses` names what is not a law's.
void register_controller(ControllerKind kind);

/// Throws InputError naming those there are.
const ControllerKind& controller_kind(const std::string& name);

/// In the order they were registered, those of armtune first.
std::vector<const ControllerKind*> controller_kinds();

/// Every gain a kind has, in the order files are written: of Gains, then its own. Lives as long as the
/// program.
const std::vector<GainField>& fields_of(const ControllerKind& kind);
const std::vector<GainField>& fields_of(const Gains& gains);

/// Multiplies every gain that is a factor of the loop's gain (GainField::in_loop).
void scale_loop_gains(Gains& gains, double factor);

/// The numbers of the kind's own gain of that name: 1, 6 or n. Throws InputError if it has none.
const JointVector& own(const Gains& gains, const std::string& name);
JointVector& own(Gains& gains, const std::string& name);

/// Makes them gains of another kind: what that does not have is as if it were not there, and what is its own
/// is what own_gain says, for an arm of n joints.
void become(Gains& gains, const std::string& name, int n);

/// The same gains for another kind: what both have, and a start from the arm's inertia for what it alone has.
/// q (n): on the task.
Gains controlled_by(const ControllerKind& kind, const Gains& gains, const RobotModel& robot,
                    const JointVector& q);

}  // namespace armtune::internal
