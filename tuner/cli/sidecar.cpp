#include "tuner/cli/sidecar.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "core/common/file_path.hpp"
#include "core/common/path_state.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/plausibility.hpp"
#include "sim/scenario/sidecar_text.hpp"
#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {

std::string named(const MissingData& missing) {
  std::vector<std::string> lacks;
  const auto add = [&lacks](const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) lacks.push_back(fmt::format("{} of {}", what, fmt::join(names, ", ")));
  };
  add("position limits", missing.position);
  add("velocity limit", missing.velocity);
  add("effort limit", missing.effort);
  add("inertia", missing.inertia);
  std::vector<std::string> impossible;
  for (const ImpossibleInertia& link : missing.impossible)
    impossible.push_back(fmt::format("{} ({})", link.link, link.fault));
  add("physically possible inertia", impossible);
  return fmt::format("{}", fmt::join(lacks, "; "));
}

MissingData to_fill_in(const MissingData& missing) {
  MissingData left = missing;
  std::erase_if(left.impossible, [](const ImpossibleInertia& link) { return link.is_complete(); });
  return left;
}

void write_sidecar(const RobotFile& file, const std::string& path) {
  MissingData missing;
  const auto robot = load_robot(file, &missing);
  const std::vector<Doubt> found = doubts_with_proposals(*robot, missing);
  if (missing.empty() && found.empty()) {
    say(fmt::format("{} has no missing and no doubtful values; {} was not written\n", file.path, path));
    return;
  }
  refuse_existing(path);
  write_text_file(path, sidecar_yaml(file.root ? "" : absolute_path(file.urdf), missing, found));
  if (missing.empty()) {
    say(fmt::format(
        "{}: no value is missing in {}; the new file lists doubtful values and proposals, as comments{}\n",
        path, file.path, file.root ? ". Add the proposals that you accept to the robot file" : ""));
    return;
  }
  say(fmt::format("{}: ", path));
  if (const MissingData left = to_fill_in(missing); !left.empty())
    say(fmt::format("fill in {}; ", named(left)));
  for (const ImpossibleInertia& link : missing.impossible) {
    if (link.is_complete())
      say(fmt::format("check the proposed inertia of {}, which differs by {:.2g} % from the URDF; ",
                      link.link, 100.0 * link.moved));
  }
  if (!found.empty()) say("look at the doubtful values and proposals, which are comments; ");
  say(file.root ? fmt::format("then add the values to {}\n", file.path)
                : "then use this file as the robot file\n");
}

}  // namespace armtune::internal::cli
