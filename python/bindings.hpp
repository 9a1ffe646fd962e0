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

/// For classes of which only C++ makes objects. Python's own ways to one that holds nothing, such as
/// Rollout.__new__(Rollout) or copy.copy, raise TypeError, as every use of such an object would be undefined.
pybind11::custom_type_setup made_by_armtune();

void bind_gains(pybind11::module_& module);
void bind_rollouts(pybind11::module_& module);
void bind_tuning(pybind11::module_& module);

}  // namespace armtune::python
