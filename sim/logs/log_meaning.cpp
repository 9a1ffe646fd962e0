#include "sim/logs/log_meaning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/logs/derivative_law.hpp"

namespace armtune::internal {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegrees = 180.0 / kPi;
/// Largest deviation of the factor between a velocity and the derivative of its position. Velocities of
/// drives are filtered and differ by a few percent.
constexpr double kFactorTolerance = 0.15;
/// Smallest correlation of a velocity with the derivative of its position.
constexpr double kCorrelation = 0.9;
/// Smallest correlation of a torque with its current, or of a measured current with its command.
constexpr double kSameSignal = 0.95;
/// Smallest factor between currents [A] and torques [N m]. A smaller one is between a signal and its command.
constexpr double kMultiple = 1.5;
/// Groups of one topic that are compared in pairs, at most.
constexpr std::size_t kMostCompared = 60;

bool follows(const GroupRelation& relation) {
  return relation.correlation >= kCorrelation && relation.deviation <= 2.0 * kFactorTolerance;
}

bool near(double factor, double expected) {
  return std::abs(factor / expected - 1.0) <= kFactorTolerance;
}

GroupMeaning from_names(const TopicSummary& topic, ChannelGroup group) {
  GroupMeaning meaning;
  const ChannelSummary& first = topic.channels[group.channels.front()];
  const ChannelWords words = topic.named ? words_of(first.name, topic.name) : ChannelWords();
  meaning.quantity = words.quantity;
  meaning.role = words.role;
  meaning.unit = first.unit.empty() ? words.unit : first.unit;
  if (const std::string usual = usual_unit(meaning.unit); !usual.empty()) meaning.unit = usual;
  meaning.unit_stated = !meaning.unit.empty();
  if (words.quantity != Quantity::kUnknown) meaning.sureness = Sureness::kLikely;
  if (words.effort) meaning.reasons.emplace_back("some drivers publish motor currents as effort");
  meaning.least = meaning.greatest = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t c : group.channels) {
    const ChannelSummary& channel = topic.channels[c];
    meaning.least = std::fmin(meaning.least, channel.least);
    meaning.greatest = std::fmax(meaning.greatest, channel.greatest);
    meaning.constant += channel.constant() ? 1 : 0;
    if (topic.rows > 0)
      meaning.missing_share = std::max(
          meaning.missing_share, static_cast<double>(channel.missing) / static_cast<double>(topic.rows));
  }
  meaning.group = std::move(group);
  return meaning;
}

/// Two quantities. The second is the derivative of the first.
constexpr std::array kChains = {std::pair{Quantity::kPosition, Quantity::kVelocity},
                                std::pair{Quantity::kVelocity, Quantity::kAcceleration}};

void mark(GroupMeaning& meaning, Quantity quantity) {
  meaning.sureness = meaning.quantity == quantity ? Sureness::kCertain : Sureness::kLikely;
  meaning.quantity = quantity;
}

/// Returns true if `b` is the derivative of `a`, and then says so in both.
bool link(const TopicSummary& topic, GroupMeaning& a, GroupMeaning& b, Quantity quantity,
          Quantity derivative) {
  const auto relation = derivative_relation(topic, a.group, b.group);
  if (!relation || !follows(*relation) || !near(relation->factor, 1.0)) return false;
  mark(a, quantity);
  mark(b, derivative);
  const double off = std::max(std::abs(relation->factor - 1.0), relation->deviation);
  const double percent = std::max(0.1, 100.0 * off);
  b.reasons.push_back(fmt::format("the derivative of {} within {:.1f} %", a.group.name, percent));
  return true;
}

/// Reports velocities that are no derivative of their positions.
void contradict(const TopicSummary& topic, const GroupMeaning& a, GroupMeaning& b) {
  const auto relation = derivative_relation(topic, a.group, b.group);
  if (!relation) return;
  const bool moves = std::any_of(b.group.channels.begin(), b.group.channels.end(),
                                 [&topic](std::size_t c) { return !topic.channels[c].constant(); });
  if (!moves) return;
  b.sureness = Sureness::kDoubtful;
  if (relation->correlation >= kCorrelation || relation->correlation <= -kCorrelation) {
    const char* hint = near(relation->factor, kDegrees)         ? ": deg/s beside rad"
                       : near(relation->factor, 1.0 / kDegrees) ? ": rad/s beside deg"
                       : near(relation->factor, -1.0)           ? ": the sign differs"
                                                                : "";
    b.reasons.push_back(
        fmt::format("{:.4g} times the derivative of {}{}", relation->factor, a.group.name, hint));
  } else {
    b.reasons.push_back(fmt::format("not the derivative of {}{}", a.group.name,
                                    relation->same_order ? "" : ": the joints are in another order"));
  }
}

/// True if a group can have the quantity: its name says so, or it has no name.
bool may_be(const GroupMeaning& meaning, Quantity quantity) {
  return meaning.quantity == quantity || meaning.quantity == Quantity::kUnknown;
}

void apply_derivatives(const TopicSummary& topic, std::vector<GroupMeaning>& meanings) {
  for (const auto& [quantity, derivative] : kChains) {
    for (GroupMeaning& b : meanings) {
      if (!may_be(b, derivative)) continue;
      GroupMeaning* named = nullptr;
      bool linked = false;
      for (GroupMeaning& a : meanings) {
        if (&a == &b || !may_be(a, quantity) || a.role != b.role) continue;
        if (a.group.channels.size() != b.group.channels.size()) continue;
        if (a.quantity == quantity && named == nullptr) named = &a;
        linked = link(topic, a, b, quantity, derivative);
        if (linked) break;
      }
      if (!linked && named != nullptr && b.quantity == derivative) contradict(topic, *named, b);
    }
  }
}

/// Finds torques and currents among groups without names: they have one column for each joint that was found.
void apply_multiples(const TopicSummary& topic, std::vector<GroupMeaning>& meanings) {
  std::size_t joints = 0;
  for (const GroupMeaning& meaning : meanings) {
    if (meaning.quantity == Quantity::kPosition) joints = meaning.group.channels.size();
  }
  std::vector<GroupMeaning*> left;
  for (GroupMeaning& meaning : meanings) {
    if (meaning.quantity == Quantity::kUnknown && joints > 0 && meaning.group.channels.size() == joints)
      left.push_back(&meaning);
  }
  for (GroupMeaning* b : left) {
    if (b->quantity == Quantity::kUnknown) b->quantity = Quantity::kDrive;
    b->sureness = Sureness::kPossible;
    for (GroupMeaning* a : left) {
      const auto relation = a == b ? std::nullopt : multiple_relation(topic, a->group, b->group);
      if (!relation || relation->correlation < kSameSignal || relation->factor < 1.0 / kMultiple) continue;
      if (relation->factor < kMultiple) {
        if (a < b)
          b->reasons.push_back(
              fmt::format("nearly equal to {}: one is probably the command for the other", a->group.name));
      } else {
        b->quantity = Quantity::kTorque;
        a->quantity = Quantity::kCurrent;
        b->reasons.push_back(fmt::format("a constant multiple of {}", a->group.name));
      }
    }
  }
}

void find_unit(const TopicSummary& topic, const std::vector<GroupMeaning>& meanings, GroupMeaning& meaning) {
  if (meaning.unit_stated) return;
  const double size = std::max(std::abs(meaning.least), std::abs(meaning.greatest));
  switch (meaning.quantity) {
    case Quantity::kPosition:
      if (size <= 2.02 * kPi)
        meaning.unit = "rad";
      else if (size <= 363.0)
        meaning.unit = "deg";
      return;
    case Quantity::kVelocity:
    case Quantity::kAcceleration:
      for (const GroupMeaning& other : meanings) {
        if (other.quantity != Quantity::kPosition ||
            other.group.channels.size() != meaning.group.channels.size())
          continue;
        const auto relation = derivative_relation(topic, other.group, meaning.group);
        const bool degrees = (other.unit == "deg") != (relation && (near(relation->factor, kDegrees) ||
                                                                    near(relation->factor, 1.0 / kDegrees)));
        meaning.unit = other.unit.empty() ? "" : degrees ? "deg/s" : "rad/s";
        break;
      }
      if (meaning.quantity == Quantity::kAcceleration && !meaning.unit.empty()) meaning.unit += "^2";
      return;
    case Quantity::kTorque:
      if (meaning.sureness != Sureness::kPossible) meaning.unit = "N m";
      return;
    case Quantity::kCurrent:
      if (meaning.sureness != Sureness::kPossible) meaning.unit = "A";
      return;
    default:
      return;
  }
}

}  // namespace

const char* name(Sureness sureness) {
  constexpr std::array kNames = {"certain", "likely", "possible", "doubtful", ""};
  return kNames[static_cast<std::size_t>(sureness)];
}

std::vector<GroupMeaning> find_meanings(const TopicSummary& topic) {
  std::vector<GroupMeaning> meanings;
  for (ChannelGroup& group : group_channels(topic)) meanings.push_back(from_names(topic, std::move(group)));
  if (meanings.size() <= kMostCompared) {
    apply_derivatives(topic, meanings);
    if (!topic.named) apply_multiples(topic, meanings);
  }
  for (const Quantity quantity : {Quantity::kPosition, Quantity::kVelocity, Quantity::kAcceleration,
                                  Quantity::kTorque, Quantity::kCurrent}) {
    for (GroupMeaning& meaning : meanings) {
      if (meaning.quantity == quantity) find_unit(topic, meanings, meaning);
    }
  }
  return meanings;
}

}  // namespace armtune::internal
