#include "tuner/cli/stiffness_option.hpp"

#include "tuner/cli/say.hpp"
#include "tuner/ranks/transport.hpp"
#include "tuner/study/stiffness_bounds.hpp"

namespace armtune::internal::cli {

void apply_stiffness(const std::vector<double>& most, Study& study) {
  if (!most.empty()) bound_stiffness(most, study);
  const std::string note = note_on_stiffness(study);
  if (!note.empty() && rank_place().rank == 0) say("note: " + note + "\n");
}

}  // namespace armtune::internal::cli
