#include "tuner/cli/compare_gains.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/yaml/joint_values.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/set_labels.hpp"
#include "tuner/gains/gains_difference.hpp"

namespace armtune::internal::cli {

void say_gains_difference(const std::vector<std::string>& sets, const RobotModel& robot, bool guessed) {
  if (sets.size() < 2) throw InputError("--gains compares gain sets with each other; name two or more");
  const std::vector<std::string> labels = set_labels(sets);
  const auto joints = joint_names(robot);
  std::vector<NamedGains> named;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    try {
      named.push_back({labels[i], load_gains(gains_name(sets[i]), joints)});
    } catch (const yaml::OtherJoints& e) {
      if (!guessed) throw;
      throw InputError(
          fmt::format("{}. The gains were read for an arm with {} joints; if they are for another arm, name "
                      "it with --robot",
                      e.what(), joints.size()));
    }
  }
  say(gains_difference(named, joints));
}

}  // namespace armtune::internal::cli
