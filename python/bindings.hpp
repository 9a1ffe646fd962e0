#pragma once
// The parts of the module, each in a file of its own.

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune::python {

/// Gains with the names of the joints that they are for.
struct NamedJoints {
  Gains gains;
  std::vector<std::string> joints;
};

void bind_gains(pybind11::module_& module);
void bind_rollouts(pybind11::module_& module);
void bind_tuning(pybind11::module_& module);

}  // namespace armtune::python
