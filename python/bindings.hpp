#pragma once
// Declares the functions that add classes and functions to the Python module, each defined in a file of its
// own, and helpers that these files share.

#include <pybind11/pybind11.h>

#include <filesystem>
#include <optional>
#include <string>

#include "armtune/rollout.hpp"

namespace armtune::internal::python {

/// Returns the setup for classes whose objects only C++ creates. With it, Python calls such as
/// Rollout.__new__(Rollout) or copy.copy raise TypeError. They would otherwise create an object without
/// content, whose use is undefined behaviour.
pybind11::custom_type_setup made_by_armtune();

/// A path that may be left out: None in Python. text_of converts it to text, which is empty if there is no
/// path.
using MaybePath = std::optional<std::filesystem::path>;
inline std::string text_of(const MaybePath& path) {
  return path ? path->string() : std::string();
}

/// Lets Python use objects of a class like the list that is their attribute `items`.
template <class Class>
void act_as_list(pybind11::class_<Class>& type, const char* items) {
  namespace py = pybind11;
  type.def("__len__", [items](const py::object& self) { return py::len(self.attr(items)); })
      .def("__iter__", [items](const py::object& self) { return py::iter(self.attr(items)); })
      .def(
          "__getitem__",
          [items](const py::object& self, const py::object& index) {
            return py::object(self.attr(items)[index]);
          },
          py::arg("index"));
}

/// Returns the engine with this name, "simbody" or "native". Raises ValueError for any other name.
armtune::Engine engine_of(const std::string& name);

void bind_gains(pybind11::module_& module);
void bind_rollouts(pybind11::module_& module);
void bind_studies(pybind11::module_& module);
void bind_searches(pybind11::module_& module);
void bind_robustness(pybind11::module_& module);
void bind_models(pybind11::module_& module);
void bind_controllers(pybind11::module_& module);

}  // namespace armtune::internal::python
