#include "tuner/cli/sidecar.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "core/common/file_path.hpp"
#include "core/common/path_state.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/plausibility.hpp"
#include "sim/scenario/urdf_keys.hpp"
#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {
namespace {

/// Writes proposals for the doubtful values of an arm that has no missing values.
void write_proposals(const RobotFile& file, const std::string& urdf, const std::string& path) {
  const std::vector<Doubt> found = doubts_with_proposals(*load_robot(file.path));
  if (found.empty()) {
    say(fmt::format("{} has no missing and no doubtful values; {} was not written\n", file.path, path));
    return;
  }
  refuse_existing(path);
  write_text_file(path, proposals_yaml(urdf, found));
  say(
      fmt::format("{}: no value is missing in {}; the new file lists doubtful values and proposals, as "
                  "comments{}\n",
                  path, file.path, file.root ? ". Add the proposals that you accept to the robot file" : ""));
}

}  // namespace

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
  for (const ImpossibleInertia& link : missing.impossible) impossible.push_back(link.link);
  add("physically possible inertia", impossible);
  return fmt::format("{}", fmt::join(lacks, "; "));
}

void write_sidecar(const RobotFile& file, const MissingData& missing, const std::string& path) {
  const std::string urdf = file.root ? "" : absolute_path(file.urdf);
  if (missing.empty()) return write_proposals(file, urdf, path);
  refuse_existing(path);
  write_text_file(path, missing_yaml(urdf, missing));
  MissingData to_fill_in = missing;
  to_fill_in.impossible.clear();
  say(fmt::format("{}: ", path));
  if (!to_fill_in.empty()) say(fmt::format("fill in {}; ", named(to_fill_in)));
  for (const ImpossibleInertia& link : missing.impossible) {
    say(fmt::format("check the proposed inertia of {}, which differs by {:.2g} % from the URDF; ", link.link,
                    100.0 * link.moved));
  }
  say(file.root ? fmt::format("then add the values to {}\n", file.path)
                : "then use this file as the robot file\n");
}

}  // namespace armtune::internal::cli
