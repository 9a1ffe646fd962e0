#include "core/robot/urdf_tree.hpp"

#include <fmt/format.h>

#include <set>

#include "armtune/error.hpp"

namespace armtune::internal {

void require_tree(const UrdfTree& tree, const std::string& source) {
  std::set<std::string> reached{tree.root};
  std::vector<std::string> open{tree.root};
  while (!open.empty()) {
    const UrdfLink& link = tree.links.at(open.back());
    open.pop_back();
    for (const std::string& name : link.joints) {
      const std::string& child = tree.joints.at(name).child;
      if (!reached.insert(child).second) {
        throw InputError(
            InputPlace{source, 0, child},
            fmt::format("link '{}' has a second parent joint, '{}'; links and joints must form a tree", child,
                        name))
            .with_value(name, "one parent joint");
      }
      open.push_back(child);
    }
  }
  for (const auto& [name, link] : tree.links) {
    if (reached.contains(name)) continue;
    throw InputError(
        InputPlace{source, 0, name},
        fmt::format("link '{}': no joints lead to it from the root link '{}'; is it part of a loop?", name,
                    tree.root));
  }
}

}  // namespace armtune::internal
