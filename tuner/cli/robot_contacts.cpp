#include "tuner/cli/robot_contacts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "sim/cell/clearance_model.hpp"
#include "sim/scenario/plausibility.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/session_printer.hpp"

namespace armtune::internal::cli {
namespace {

/// Warns of collision shapes that are far larger than the arm's reach. The usual cause is a mesh in
/// millimetres, which is read as one in metres.
void warn_of_huge_shapes(const RobotModel& model, const ArmSolids& arm) {
  constexpr double kHuge = 10.0;  // as a multiple of the reach
  std::set<std::string> named;
  for (const ArmSolid& solid : arm.solids) {
    const double size = farthest(solid.placed, solid.placed.p_BS);
    if (size <= kHuge * reach(model) || !named.insert(solid.link).second) continue;
    print_warning(fmt::format(
        "{}: a collision shape extends {:.3g} m, but the reach of the whole arm is {:.3g} m; if the shape is "
        "a mesh in millimetres, add scale=\"0.001 0.001 0.001\" in the URDF",
        solid.link, size, reach(model)));
  }
}

}  // namespace

void show_contacts(const RobotModel& model) {
  const ClearanceModel contacts(std::make_shared<const RobotModel>(model), Cell{});
  std::vector<std::string> unknown = contacts.arm().unknown;
  if (!unknown.empty())
    say(fmt::format("Self-collision is not checked for {}, because shapes are missing or cannot be read.\n",
                    fmt::join(unknown, ", ")));
  warn_of_huge_shapes(model, contacts.arm());
  constexpr std::size_t kMostShown = 3;
  const std::vector<std::string>& unread = contacts.arm().unread;
  for (std::size_t i = 0; i < std::min(kMostShown, unread.size()); ++i) say(fmt::format("  {}\n", unread[i]));
  if (unread.size() > kMostShown) say(fmt::format("  and {} more shapes\n", unread.size() - kMostShown));
  if (contacts.has(Clearance::kSelf))
    say(fmt::format(
        "Self-collision is checked for {} pairs of shapes, between links that are not neighbours.\n",
        contacts.pairs().size()));
  if (const auto drawn = drawn_links(contacts.arm()); !drawn.empty())
    say(fmt::format(
        "Clearances are measured from the drawn (visual) shapes of {}, which have no collision\nshapes. "
        "Give collision shapes with 'shapes' in a robot YAML.\n",
        fmt::join(drawn, ", ")));
  const std::vector<std::string> left_out = contacts.left_out_by_their_make();
  if (!left_out.empty())
    say(
        fmt::format("Self-collision is not checked between links whose shapes touch at nearly every "
                    "position: {}.\n",
                    fmt::join(left_out, "; ")));
}

}  // namespace armtune::internal::cli
