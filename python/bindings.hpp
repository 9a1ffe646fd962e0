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

/// Returns the engine with this name, "simbody" or "native". Raises ValueError for any other name.
armtune::Engine engine_of(const std::string& name);

void bind_gains(pybind11::module_& module);
void bind_rollouts(pybind11::module_& module);
void bind_searches(pybind11::module_& module);
void bind_robustness(pybind11::module_& module);
void bind_models(pybind11::module_& module);
void bind_controllers(pybind11::module_& module);

}  // namespace armtune::internal::python
