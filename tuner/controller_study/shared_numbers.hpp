#pragma once
// Finds gains that all take their value from one and the same number in the user's file. A study links such
// gains, so that this number gets a single value.

#include <string>
#include <vector>

#include "sim/controller_files/placed_gain.hpp"
#include "tuner/controller_study/controller_in_file.hpp"

namespace armtune::internal {

/// A gain that shares its number in the file with other gains.
struct SharedGain {
  const GainField* field;
  std::size_t component;  ///< index in the field
  std::string entry;      ///< name in the study: "jtc_p/elbow"
  GainName name;          ///< for messages
  double factor;          ///< the gain is this factor times the number in the file
};
using SharedNumber = std::vector<SharedGain>;

/// Returns the numbers of the file that stand for two or more of searched_fields(), through YAML aliases or
/// through lists of gains in a map.
std::vector<SharedNumber> shared_numbers(const ControllerInFile& from);

/// Returns the number that a gain shares, or null if it shares none.
const SharedNumber* number_of(const std::vector<SharedNumber>& shared, const GainField& field, std::size_t k);

/// Returns the lines of a study's `parameters` that link all gains that share a number to `tuned`, which is
/// one of these gains.
std::string link_lines(const SharedNumber& number, const SharedGain& tuned);

/// Returns a sentence that says which gains share numbers of the file, and how to separate them.
std::string sharing_note(const ControllerInFile& from, const std::vector<const SharedNumber*>& shared);

}  // namespace armtune::internal
