#pragma once
// Gains that share one number of the robot's own parameter file, through a YAML alias or a map of gains. A
// study must give such gains one value, because tuned gains are written back into this file.

#include "tuner/study/study.hpp"

namespace armtune::internal {

/// Throws InputError if two gains share one number of the file with the start gains (sim/controller_files),
/// but the search could give them different values. Does nothing if that file is not a parameter file of the
/// study's controller.
void refuse_split_numbers(const Study& study);

}  // namespace armtune::internal
