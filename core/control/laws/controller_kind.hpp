#pragma once
// Declares the kinds of controllers, each with its name, its gains and its control law. Gains files, help
// texts, search spaces, journals of searches and reports are derived from this one declaration. Programs that
// use armtune add kinds to the built-in ones with register_controller.

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
  /// Names of the members of Gains that this law uses, among those that belong to laws (GainField::of_law).
  std::vector<std::string> uses;
  /// The kind's own gains, which no other kind has. They are made by own_gain.
  std::vector<GainField> own;
  std::function<std::unique_ptr<TorqueLaw>(const LawSetup&)> make;
  /// Sets start values of the own gains if there are none yet. q (n): joint positions of the arm on its task.
  /// If this function is empty, the gains keep the defaults of own_gain.
  std::function<void(const RobotModel&, const JointVector& q, Gains&)> start;
  /// True if the law adapts its model of the arm online.
  bool learns = false;
  /// Template of its law, if the law can compute several arms at once.
  std::optional<ArmLawKind> lanes = {};
};

/// Makes a gain that only one kind of controller has. It is never negative. otherwise: default of each of its
/// values. A search varies the gain between lower_factor and upper_factor times its start value, unless the
/// study (the file that describes the search) gives another range. To find the gain margin, the gain is
/// multiplied by factors (tuner/robustness).
GainField own_gain(GainShape shape, const char* name, const char* unit, const char* meaning, double otherwise,
                   double lower_factor = 0.2, double upper_factor = 5.0);
/// Returns the same gain, but zero is refused.
GainField positive(GainField gain);
/// Returns the same gain, but it is not multiplied to find the gain margin. Use it for lengths, angles and
/// scales.
GainField not_in_loop(GainField gain);
/// Returns the same gain, but to find the gain margin it is multiplied by the square root of the factor for
/// the other gains. This suits a damping ratio, because damping is ratio times sqrt(stiffness).
GainField root_in_loop(GainField gain);
/// Returns the same gain, but a search leaves it unchanged unless the user gives an upper bound
/// (SearchRange::kBounded).
GainField bounded(GainField gain);
/// Returns the same gain, but a search leaves it unchanged unless the study names it, and it is not
/// multiplied to find the gain margin.
GainField not_tuned(GainField gain);

/// Adds a kind. It must be called before any gains, scenario or study is loaded. Throws InputError if the
/// name of the kind or of a gain is taken or not allowed, if the kind has no law, if a gain's default or
/// search factors are out of range, or if `uses` names a gain that does not belong to a law.
void register_controller(ControllerKind kind);

/// Returns a kind by name. Throws InputError with the names of all kinds if there is none.
const ControllerKind& controller_kind(const std::string& name);

/// Returns all kinds in the order of their registration, the built-in ones first.
std::vector<const ControllerKind*> controller_kinds();

/// Returns every gain of a kind in the order of gains files: its members of Gains, then its own gains. The
/// result lives as long as the program.
const std::vector<GainField>& fields_of(const ControllerKind& kind);
const std::vector<GainField>& fields_of(const Gains& gains);

/// Multiplies the gain of the control loop by a factor. For this, each single gain is changed in the way that
/// its GainField::loop states.
void scale_loop_gains(Gains& gains, double factor);

/// Returns the values of the kind's own gain of that name: 1, 6 or n. Throws InputError if it has none.
const JointVector& own(const Gains& gains, const std::string& name);
JointVector& own(Gains& gains, const std::string& name);

/// Changes gains to those of another kind, for an arm of n joints. Gains that the new kind does not have get
/// values without effect, and its own gains get the defaults of own_gain.
void change_controller(Gains& gains, const std::string& name, int n);

/// Returns the gains converted for another kind. Gains that both kinds have are kept. The others get start
/// values for the arm (first_gains.hpp, ControllerKind::start). If the new kind uses Ki and does not adapt
/// its model, Ki is raised to kFirstIntegralShare * Kp^2 where it is smaller. q (n): joint positions on the
/// task.
Gains convert_gains(const ControllerKind& kind, const Gains& gains, const RobotModel& robot,
                    const JointVector& q);

}  // namespace armtune::internal
