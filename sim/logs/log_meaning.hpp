#pragma once
// Finds what the channels of a log are (positions, velocities, torques and so on), in which unit, and how
// sure this is. It uses their names, their units, and laws that the values obey.

#include <string>
#include <vector>

#include "sim/logs/channel_groups.hpp"
#include "sim/logs/channel_words.hpp"
#include "sim/logs/log_summary.hpp"

namespace armtune::internal {

enum class Sureness {
  kCertain,   ///< name and values agree, or the type of the message states it
  kLikely,    ///< either the name or a law of the values says so
  kPossible,  ///< only the range or a similarity of the values suggests it
  kDoubtful,  ///< name and values contradict each other
  kNone,      ///< nothing is known
};

/// Returns "certain", "likely", "possible", "doubtful" or "".
const char* name(Sureness sureness);

struct GroupMeaning {
  ChannelGroup group;
  Quantity quantity = Quantity::kUnknown;
  Role role = Role::kMeasured;
  std::string unit;  ///< such as "rad"; empty: not known
  bool unit_stated =
      false;  ///< true if the file or a name states the unit; false: from the range of the values
  Sureness sureness = Sureness::kNone;
  std::vector<std::string> reasons;  ///< each a clause, such as "8..13 is its derivative within 2 %"
  double least = 0.0;                ///< over all of its channels; NaN if they have no numbers
  double greatest = 0.0;
  std::size_t constant = 0;    ///< number of channels that do not change
  double missing_share = 0.0;  ///< largest share of rows without a number in one channel
};

/// Finds what each group of channels is. It uses these laws:
///   - velocities are the derivative of positions, and accelerations that of velocities: the change of the
///     one equals the integral of the other within 15 %, for every joint that moves;
///   - positions of at most 2 pi in size are in rad, larger ones of at most 360 in deg, unless the unit is
///     stated. The unit of velocities follows from that of the positions and from the factor between the two;
///   - in a file without names, further groups with one column for each joint are torques or currents.
///     Torques are a multiple of currents, with one factor for each joint.
/// Returns one entry for each group, in the order of the channels.
std::vector<GroupMeaning> find_meanings(const TopicSummary& topic);

}  // namespace armtune::internal
