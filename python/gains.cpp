// Binds Gains, which give access to each gain by name, as a NumPy array without a copy.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "armtune/gains.hpp"
#include "armtune/scenario.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/gains/gains_formats.hpp"

namespace py = pybind11;

namespace armtune::internal::python {
namespace {

const GainField& field_of(const Gains& gains, const std::string& name) {
  for (const GainField& field : fields_of(gains)) {
    if (field.name == name) return field;
  }
  throw py::key_error(fmt::format("{}: the controller {} has no gain of this name", name, gains.controller));
}

std::vector<std::string> names(const armtune::Gains& self) {
  std::vector<std::string> all;
  for (const GainField& field : fields_of(self.inside())) all.emplace_back(field.name);
  return all;
}

/// Returns numbers as an array that shares their memory, and switches as True, False or a word.
py::object get(const py::object& self, const std::string& name) {
  auto& gains = self.cast<armtune::Gains&>().inside();
  const GainField& field = field_of(gains, name);
  if (field.is_number()) {
    const auto values = numbers(gains, field);
    const py::array flat = view(values.data(), values.size(), 1, self, true);
    const auto n = self.cast<armtune::Gains&>().joints().size();
    const auto* forces = std::get_if<ForceGains Gains::*>(&field.member);
    if (forces == nullptr || !is_per_joint(gains.**forces, static_cast<int>(n))) return flat;
    return flat.attr("reshape")(n, n);  // shares the memory
  }
  const std::string text = field_text(gains, field);
  if (std::holds_alternative<bool Gains::*>(field.member)) return py::bool_(text == "true");
  return py::str(text);
}

/// Converts one number for each of n force points, or n rows of n numbers, one row for each force point.
ForceGains force_gains_of(const std::string& name, const py::object& value, py::ssize_t n) {
  const auto given = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
  if (!given) {
    PyErr_Clear();
    throw py::cast_error();
  }
  const bool points = given.ndim() == 1 && given.size() == n;
  const bool rows = given.ndim() == 2 && given.shape(0) == n && given.shape(1) == n;
  if (!points && !rows)
    throw InputError(
        fmt::format("{}: {} numbers are given; give {}, one for each joint origin or link, or {} lists of "
                    "{}",
                    name, given.size(), n, n, n));
  return Eigen::Map<const Eigen::VectorXd>(given.data(), given.size());
}

void assign(armtune::Gains& self, const std::string& name, const py::object& value) {
  const GainField& field = field_of(self.inside(), name);
  if (const auto* flag = std::get_if<bool Gains::*>(&field.member)) {
    self.inside().** flag = value.cast<bool>();
  } else if (const auto* reference = std::get_if<SlerpReference Gains::*>(&field.member)) {
    const auto word = value.cast<std::string>();
    if (word != "start" && word != "current")
      throw InputError(fmt::format("{}: '{}' is not valid; give start or current", name, word));
    self.inside().** reference = word == "start" ? SlerpReference::kStart : SlerpReference::kCurrent;
  } else {
    const auto values = numbers(self.inside(), field);
    if (!py::isinstance<py::sequence>(value) && !py::isinstance<py::array>(value)) {
      std::fill(values.begin(), values.end(), value.cast<double>());
      return;
    }
    if (const auto* forces = std::get_if<ForceGains Gains::*>(&field.member)) {
      self.inside().** forces = force_gains_of(name, value, static_cast<py::ssize_t>(self.joints().size()));
      return;
    }
    const auto given = value.cast<std::vector<double>>();
    if (given.size() != values.size())
      throw InputError(fmt::format("{}: {} numbers are given; give {}", name, given.size(), values.size()));
    std::copy(given.begin(), given.end(), values.begin());
  }
}

void set(armtune::Gains& self, const std::string& name, const py::object& value) {
  try {
    assign(self, name, value);
  } catch (const py::cast_error&) {
    const GainField& field = field_of(self.inside(), name);
    const char* kind = field.is_number()                                     ? "numbers"
                       : std::holds_alternative<bool Gains::*>(field.member) ? "True or False"
                                                                             : "a string";
    throw py::type_error(
        fmt::format("{}: {} is not valid; give {}", name, py::repr(value).cast<std::string>(), kind));
  }
}

armtune::GainsFormat format_of(const std::string& name) {
  switch (internal::gains_format_from_name(name)) {
    case internal::GainsFormat::kYaml:
      return armtune::GainsFormat::kYaml;
    case internal::GainsFormat::kRos1:
      return armtune::GainsFormat::kRos1;
    case internal::GainsFormat::kRos2:
      break;
  }
  return armtune::GainsFormat::kRos2;
}

}  // namespace

void bind_gains(py::module_& module) {
  py::class_<armtune::Gains>(module, "Gains", made_by_armtune(),
                             "The gains of a controller for one arm, by the names in a gains file.")
      .def_property_readonly("joints", &armtune::Gains::joints,
                             "Names of the arm's joints, in the order of joint vectors.")
      .def_property_readonly("controller",
                             [](const armtune::Gains& self) { return self.inside().controller; })
      .def("keys", &names, "Returns the names of the gains.")
      .def("__getitem__", &get, py::arg("name"),
           "Returns the numbers of a gain as a NumPy array. Writing into the array changes the gains. "
           "Switches and words are returned as bool and str. force_control_gains is n x n if each joint "
           "origin or link has a gain for every joint.")
      .def("__setitem__", &set, py::arg("name"), py::arg("value"))
      .def("__iter__", [](const armtune::Gains& self) { return py::iter(py::cast(names(self))); })
      .def("__contains__",
           [](const armtune::Gains& self, const std::string& name) {
             const auto all = names(self);
             return std::find(all.begin(), all.end(), name) != all.end();
           })
      .def("__len__", [](const armtune::Gains& self) { return names(self).size(); })
      .def("copy", [](const armtune::Gains& self) { return armtune::Gains(self); })
      .def("__copy__", [](const armtune::Gains& self) { return armtune::Gains(self); })
      .def("__deepcopy__", [](const armtune::Gains& self, const py::dict&) { return armtune::Gains(self); })
      .def(
          "text",
          [](const armtune::Gains& self, const std::string& format) { return self.text(format_of(format)); },
          py::arg("format") = "yaml", "Returns the text of a gains file in the format yaml, ros1 or ros2.")
      .def(
          "save",
          [](const armtune::Gains& self, const std::filesystem::path& path, const std::string& format) {
            self.save(path.string(), format_of(format));
          },
          py::arg("path"), py::arg("format") = "yaml",
          "Writes a gains file. After an error there is no partial file.")
      .def("__repr__", [](const armtune::Gains& self) {
        return fmt::format("<armtune.Gains of {} for {} joints>", self.inside().controller,
                           self.joints().size());
      });
  module.def(
      "load_gains",
      [](const std::filesystem::path& name, const armtune::Scenario& scenario) {
        return armtune::Gains::load(name.string(), scenario.robot());
      },
      py::arg("name"), py::arg("scenario"),
      "Loads bundled gains by name, or a gains file by path, for the arm of a scenario.");
}

}  // namespace armtune::internal::python
