#include "tuner/cli/stiffness_option.hpp"

#include <CLI/CLI.hpp>

#include "core/common/types.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/ranks/transport.hpp"
#include "tuner/study/stiffness_bounds.hpp"

namespace armtune::internal::cli {

void add_stiffness_option(CLI::App& command, std::vector<double>& most) {
  command
      .add_option("--max-stiffness", most,
                  "largest stiffness that an impedance controller may get [N m/rad, N/m]: one number, or one "
                  "for each joint. For a Cartesian impedance controller: two, for translations and "
                  "rotations, or six")
      ->default_str("the stiffness is not tuned")
      ->expected(1, static_cast<int>(kMaxJoints))
      ->check(CLI::PositiveNumber);
}

void apply_stiffness(const std::vector<double>& most, Study& study) {
  if (!most.empty()) bound_stiffness(most, study);
  const std::string note = note_on_stiffness(study);
  if (!note.empty() && rank_place().rank == 0) say("note: " + note + "\n");
}

}  // namespace armtune::internal::cli
