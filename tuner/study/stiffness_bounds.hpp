#pragma once
// The stiffness of an impedance controller in a search. How stiff an arm may become depends on contacts,
// which are not simulated, so only the user can give an upper bound (SearchRange::kBounded).

#include <string>
#include <vector>

#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Adds the stiffness of the study's controller to the tuned gains. The range begins at a share of the start
/// value and ends at `most`. For a stiffness of joints, `most` has one number for all joints, or one for each
/// [N m/rad, N/m]. For a stiffness along the axes of the task, it has two numbers, for translations [N/m] and
/// for rotations [N m/rad, N m], or six. A start value above its bound is lowered to the bound. A stiffness
/// that starts at zero is switched off, and is not tuned. Throws InputError if the controller has no
/// stiffness, if the study tunes it already, or if the count is wrong.
void bound_stiffness(const std::vector<double>& most, Study& study);

/// Returns a sentence for the user if the study leaves the stiffness of its controller unchanged, otherwise
/// an empty text.
std::string note_on_stiffness(const Study& study);

}  // namespace armtune::internal
