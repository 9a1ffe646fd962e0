#include "sim/controller_files/ros_nodes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/common/message_text.hpp"
#include "sim/yaml/document.hpp"
#include "sim/yaml/source_text.hpp"

namespace armtune::internal {
namespace {

using yaml::Placed;
using yaml::PlacedEntry;
using yaml::PlacedValue;

constexpr std::string_view kRos2Parameters = "ros__parameters";
constexpr std::string_view kGains = "gains";
constexpr std::string_view kDottedGains = "gains.";
constexpr std::string_view kEveryNode = "/**";

bool is_map(const PlacedValue& value) {
  return value.kind == PlacedValue::Kind::kMap;
}

bool has_dotted_gains(const PlacedValue& parameters) {
  const auto is_dotted = [](const PlacedEntry& entry) { return entry.key.find('.') != std::string::npos; };
  const PlacedValue* gains = parameters.find(kGains);
  return std::any_of(parameters.entries.begin(), parameters.entries.end(),
                     [](const PlacedEntry& entry) { return entry.key.starts_with(kDottedGains); }) ||
         (gains != nullptr && std::any_of(gains->entries.begin(), gains->entries.end(), is_dotted));
}

bool has_controller(const PlacedValue& parameters) {
  return std::any_of(parameters.entries.begin(), parameters.entries.end(), [](const PlacedEntry& entry) {
    return entry.key == kGains || entry.key.starts_with(kDottedGains) || entry.key == "command_interfaces" ||
           entry.key == "k_gains" || entry.key == "d_gains";
  });
}

/// Puts the parameters of several maps together. A later value replaces an earlier one.
class MergedParameters {
 public:
  /// left: number of parameters that may still be added, for all nodes of the file.
  MergedParameters(const std::string& file, int line, std::size_t& left) : file_(file), left_(left) {
    parameters_->kind = PlacedValue::Kind::kMap;
    parameters_->line = line;
  }
  Placed take() const { return parameters_; }

  void add(const PlacedValue& parameters) {
    for (const PlacedEntry& entry : parameters.entries) {
      if (entry.key == kGains && is_map(*entry.value)) {
        gains(entry.value->line);
        for (const PlacedEntry& joint : entry.value->entries) add_gain(joint);
      } else if (entry.key.starts_with(kDottedGains)) {
        add_gain({entry.key.substr(kDottedGains.size()), entry.value, entry.alias});
      } else if (entry.key != kGains || !gains_) {
        put(*parameters_, entry);
      }
    }
  }

 private:
  /// Adds "JOINT: {KEY: VALUE, ...}" or "JOINT.KEY: VALUE". The name of the joint may itself contain dots.
  void add_gain(const PlacedEntry& gain) {
    const int line = gain.value->line;
    const auto dot = gain.key.rfind('.');
    if (is_map(*gain.value)) {
      PlacedValue& own = joint(gain.key, line);
      for (const PlacedEntry& entry : gain.value->entries) put(own, entry);
    } else if (dot != std::string::npos) {
      put(joint(gain.key.substr(0, dot), line), {gain.key.substr(dot + 1), gain.value, gain.alias});
    } else if (!joints_.contains(gain.key)) {
      put(gains(line), gain);
    }
  }

  static std::shared_ptr<PlacedValue> new_map(int line) {
    auto map = std::make_shared<PlacedValue>();
    map->kind = PlacedValue::Kind::kMap;
    map->line = line;
    return map;
  }
  PlacedValue& gains(int line) {
    if (!gains_) put(*parameters_, {std::string(kGains), gains_ = new_map(line)});
    return *gains_;
  }
  PlacedValue& joint(const std::string& name, int line) {
    std::shared_ptr<PlacedValue>& own = joints_[name];
    if (!own) put(gains(line), {name, own = new_map(line)});
    return *own;
  }

  void put(PlacedValue& map, const PlacedEntry& entry) {
    if (left_-- == 0)
      yaml::fail_at(
          file_, entry.value->line, {},
          fmt::format("the wildcards of the file give more than {} parameters to its nodes", yaml::kMaxItems),
          fmt::format("at most {} parameters", yaml::kMaxItems));
    const auto [at, is_new] = places_.emplace(std::pair{&map, entry.key}, map.entries.size());
    if (is_new)
      map.entries.push_back(entry);
    else
      map.entries[at->second] = entry;
  }

  const std::string& file_;
  std::size_t& left_;
  std::shared_ptr<PlacedValue> parameters_ = std::make_shared<PlacedValue>();
  std::shared_ptr<PlacedValue> gains_;
  std::unordered_map<std::string, std::shared_ptr<PlacedValue>> joints_;
  std::map<std::pair<const PlacedValue*, std::string>, std::size_t> places_;  ///< of entries in their maps
};

/// All parameters that the file has below one name.
struct NamedParameters {
  std::string name;         ///< as the file has it
  std::string space, node;  ///< its namespace and the name in it: "/left" and "arm_controller"
  std::vector<Placed> maps;
  bool has_controller = false;
  bool is_received = false;  ///< true: a more specific node receives these parameters

  bool is_for_all() const { return node == "**" || (space == kEveryNode && node == "*"); }
  bool is_wildcard() const { return node == "*" || node == "**" || space == kEveryNode; }
};

class NodeNames {
 public:
  explicit NodeNames(const PlacedValue& root) {
    std::vector<std::string> keys;
    collect(root, keys);
  }
  std::vector<NamedParameters>& all() { return all_; }

  /// Returns the indices of the names whose parameters a node receives, in their order.
  std::vector<std::size_t> received_by(const NamedParameters& node) const {
    std::vector<std::size_t> found;
    for (const std::string& name : {node.space + "/" + node.node, std::string(kEveryNode),
                                    std::string("/**/*"), "/**/" + node.node, node.space + "/*"}) {
      const auto at = places_.find(name);
      if (at != places_.end()) found.push_back(at->second);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  void collect(const PlacedValue& map, std::vector<std::string>& keys) {
    for (const PlacedEntry& entry : map.entries) {
      if (entry.alias || !is_map(*entry.value)) continue;  // aliases are visited where they are written
      if (entry.key == kRos2Parameters) {
        add(fmt::format("{}", fmt::join(keys, "/")), entry.value);
        continue;
      }
      keys.push_back(entry.key);
      collect(*entry.value, keys);
      keys.pop_back();
    }
  }
  void add(const std::string& name, const Placed& parameters) {
    const std::string full = name.starts_with('/') ? name : "/" + name;
    const auto [at, is_new] = places_.emplace(full, all_.size());
    if (is_new) {
      const auto slash = full.rfind('/');
      all_.push_back({one_line(name), full.substr(0, slash), full.substr(slash + 1), {}});
    }
    NamedParameters& own = all_[at->second];
    own.maps.push_back(parameters);
    own.has_controller = own.has_controller || has_controller(*parameters);
  }

  std::vector<NamedParameters> all_;
  std::unordered_map<std::string, std::size_t> places_;  ///< of the names in all_, each with a leading '/'
};

}  // namespace

std::vector<RosNode> ros2_nodes(const PlacedValue& root, const std::string& file) {
  NodeNames names(root);
  std::vector<NamedParameters>& all = names.all();
  std::size_t left = yaml::kMaxItems;
  std::vector<std::pair<std::size_t, RosNode>> found;
  // The most specific names come first: a wildcard is a node only if none of them receives its parameters.
  const std::array<bool (*)(const NamedParameters&), 3> kinds = {
      [](const NamedParameters& named) { return !named.is_wildcard(); },
      [](const NamedParameters& named) { return named.is_wildcard() && !named.is_for_all(); },
      [](const NamedParameters& named) { return named.is_for_all(); }};
  for (const auto& is_of_kind : kinds) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (!is_of_kind(all[k]) || all[k].is_received) continue;
      const std::vector<std::size_t> received = names.received_by(all[k]);
      const bool has_own = std::any_of(received.begin(), received.end(), [&all, k](std::size_t from) {
        return all[from].has_controller && (from == k || !all[from].is_for_all());
      });
      if (!has_own) continue;
      for (const std::size_t from : received) all[from].is_received = true;
      const Placed& own = all[k].maps.front();
      if (received.size() == 1 && all[k].maps.size() == 1 && !has_dotted_gains(*own)) {
        found.emplace_back(k, RosNode{all[k].name, own});
        continue;
      }
      MergedParameters merged(file, own->line, left);
      for (const std::size_t from : received) {
        for (const Placed& map : all[from].maps) merged.add(*map);
      }
      found.emplace_back(k, RosNode{all[k].name, merged.take()});
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<RosNode> nodes;
  nodes.reserve(found.size());
  for (auto& [place, node] : found) nodes.push_back(std::move(node));
  return nodes;
}

}  // namespace armtune::internal
