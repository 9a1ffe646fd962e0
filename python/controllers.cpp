// Binds controllers that are written in Python, for experiments. Each control period calls Python.

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include "armtune/controller.hpp"
#include "armtune/error.hpp"
#include "python/bindings.hpp"

namespace py = pybind11;

namespace armtune::internal::python {
namespace {

using armtune::ControllerKind;
using armtune::Gains;
using armtune::GainShape;
using armtune::LawSetup;

/// Gives Python access to a control period, as long as its control law is being called.
struct Period {
  const LawState* state;

  const LawState& now() const {
    if (state != nullptr) return *state;
    throw std::runtime_error(
        "the values of this ControlPeriod are gone, because its control period is over; copy them during "
        "the call of the control law");
  }
};

using Vector = Eigen::VectorXd;

Vector model_torque(const Period& period, const Vector& v, const Vector& a) {
  Vector tau(period.now().position().size());
  period.now().model_torque(v, a, tau);
  return tau;
}

/// Calls `function` with the GIL held. An exception of the function ends the run, and is raised again by the
/// call that started the run.
template <class Function>
auto told(const std::string& name, Function function) {
  const py::gil_scoped_acquire lock;
  try {
    return function();
  } catch (const py::cast_error&) {
    throw FailedError(
        fmt::format("controller {}: the control law returned something else than a list of numbers; return "
                    "one torque for each joint",
                    name));
  }
}

class PythonLaw final : public Law {
 public:
  PythonLaw(std::string name, py::object function) : name_(std::move(name)), function_(std::move(function)) {}
  ~PythonLaw() override {
    const py::gil_scoped_acquire lock;
    function_ = py::object();
  }

  void torque(const LawState& state, Eigen::Ref<Eigen::VectorXd> tau) override {
    const auto given = told(name_, [&] {
      auto period = std::make_shared<Period>(Period{&state});
      const std::shared_ptr<void> over(nullptr, [&](void*) { period->state = nullptr; });
      return function_(period).cast<Vector>();
    });
    if (given.size() != tau.size())
      throw FailedError(
          fmt::format("controller {}: {} torques were returned, but the arm has {} joints; "
                      "return one torque for each joint",
                      name_, given.size(), tau.size()));
    tau = given;
  }

 private:
  std::string name_;
  py::object function_;
};

GainShape shape_of(const std::string& word) {
  if (word == "scalar") return GainShape::kScalar;
  if (word == "task") return GainShape::kTask;
  if (word == "joints") return GainShape::kJoints;
  throw py::value_error(fmt::format("shape: {}; it must be scalar, task or joints", word));
}

/// Returns a gain's declaration from a dict, whose keys are the names of GainDeclaration's fields.
GainDeclaration declared(const py::dict& given) {
  GainDeclaration gain;
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    if (name == "shape")
      gain.shape = shape_of(value.cast<std::string>());
    else if (name == "name")
      gain.name = value.cast<std::string>();
    else if (name == "unit")
      gain.unit = value.cast<std::string>();
    else if (name == "meaning")
      gain.meaning = value.cast<std::string>();
    else if (name == "otherwise")
      gain.otherwise = value.cast<double>();
    else if (name == "positive")
      gain.positive = value.cast<bool>();
    else if (name == "in_loop")
      gain.in_loop = value.cast<bool>();
    else if (name == "lower_factor")
      gain.lower_factor = value.cast<double>();
    else if (name == "upper_factor")
      gain.upper_factor = value.cast<double>();
    else
      throw py::value_error(fmt::format(
          "register_controller: a gain of 'own' cannot have the key '{}'; see help(armtune.register_controller)",
          name));
  }
  return gain;
}

void register_python(const std::string& name, const py::function& make, const std::vector<py::dict>& own,
                     const std::vector<std::string>& uses, const std::string& meaning,
                     const py::object& start) {
  // Never freed: kinds of controllers live until the process ends, when Python has ended already.
  const auto* maker = new py::function(make);
  ControllerKind kind;
  kind.name = name;
  kind.meaning = meaning;
  kind.uses = uses;
  for (const py::dict& gain : own) kind.own.push_back(declared(gain));
  kind.make = [name, maker](const LawSetup& setup) -> std::unique_ptr<Law> {
    return told(name, [&] {
      return std::make_unique<PythonLaw>(name, (*maker)(setup.robot, setup.gains, setup.period));
    });
  };
  if (!start.is_none()) {
    const auto* starter = new py::object(start);
    kind.start = [name, starter](const Robot& robot, std::span<const double> q, Gains& gains) {
      told(name, [&] {
        const py::object given = py::cast(gains);
        (*starter)(robot, std::vector<double>(q.begin(), q.end()), given);
        gains = given.cast<Gains>();
        return 0;
      });
    };
  }
  register_controller(kind);
}

}  // namespace

void bind_controllers(py::module_& module) {
  const auto vector = [](auto member) {
    return [member](const Period& self) { return Vector((self.now().*member)()); };
  };
  py::class_<Period, std::shared_ptr<Period>>(
      module, "ControlPeriod", made_by_armtune(),
      "The inputs of a control law in one control period, valid only during the call of the control law.")
      .def_property_readonly("position", vector(&LawState::position),
                             "Measured joint positions q (n) [rad, m].")
      .def_property_readonly("velocity", vector(&LawState::velocity),
                             "Measured joint velocities q' (n) [rad/s, m/s].")
      .def_property_readonly("reference_velocity", vector(&LawState::reference_velocity),
                             "Reference joint velocities qr' (n) [rad/s, m/s].")
      .def_property_readonly("reference_acceleration", vector(&LawState::reference_acceleration),
                             "Reference joint accelerations qr'' (n) [rad/s^2, m/s^2].")
      .def_property_readonly("sliding", vector(&LawState::sliding), "Sliding variable S = q' - qr' (n).")
      .def_property_readonly("damping", vector(&LawState::damping),
                             "Damping gains Kd of the active controller state (n).")
      .def_property_readonly(
          "jacobian", [](const Period& self) { return Eigen::MatrixXd(self.now().jacobian()); },
          "Jacobian of the tool, linear rows first, in the base frame (6 x n).")
      .def_property_readonly("state", [](const Period& self) { return self.now().state(); })
      .def_property_readonly("tracks_joints", [](const Period& self) { return self.now().tracks_joints(); })
      .def("model_torque", &model_torque, py::arg("v"), py::arg("a"),
           "Returns M(q) a + C(q, q') v + g(q) + friction(q') (n) from the controller's model of the arm.");
  module.def(
      "register_controller", &register_python, py::arg("name"), py::arg("make"), py::kw_only(),
      py::arg("own") = std::vector<py::dict>(), py::arg("uses") = std::vector<std::string>(),
      py::arg("meaning") = "", py::arg("start") = py::none(),
      "Adds a kind of controller in this process. make(robot, gains, period) returns a function that takes "
      "a ControlPeriod and returns the torques (n) [N m, N]. own: the controller's own gains, each a dict "
      "with the keys shape (scalar, task or joints), name, unit, meaning and otherwise (default value). "
      "Optional keys are positive (True: zero is refused), in_loop (True: the loop gain is proportional to "
      "this gain), lower_factor and upper_factor (default bounds of the search, as factors on the start "
      "value). uses: names of armtune's gains that the controller uses. start(robot, q, gains) sets the "
      "start values of the controller's own gains; q has the joint positions with the tool on its path.");
}

}  // namespace armtune::internal::python
