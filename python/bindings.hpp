#pragma once
// The parts of the module, each in a file of its own.

#include <pybind11/pybind11.h>

#include <filesystem>
#include <optional>
#include <string>

#include "armtune/rollout.hpp"

namespace armtune::internal::python {

/// For classes whose objects only C++ makes. Python's own ways to one that holds nothing, such as
/// Rollout.__new__(Rollout) or copy.copy, raise TypeError, as every use of such an object would be undefined.
pybind11::custom_type_setup made_by_armtune();

/// What None stands for where a path may be left out.
using MaybePath = std::optional<std::filesystem::path>;
inline std::string text_of(const MaybePath& path) {
  return path ? path->string() : std::string();
}

/// Raises ValueError for a word that is none.
armtune::Engine engine_of(const std::string& name);

void bind_gains(pybind11::module_& module);
void bind_rollouts(pybind11::module_& module);
void bind_searches(pybind11::module_& module);
void bind_robustness(pybind11::module_& module);
void bind_models(pybind11::module_& module);
void bind_controllers(pybind11::module_& module);

}  // namespace armtune::internal::python
