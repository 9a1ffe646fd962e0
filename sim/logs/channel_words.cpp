#include "sim/logs/channel_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace armtune::internal {
namespace {

struct KnownWord {
  std::string_view word;
  Quantity quantity;
};

constexpr KnownWord kQuantities[] = {
    {"q", Quantity::kPosition},          {"position", Quantity::kPosition},
    {"positions", Quantity::kPosition},  {"pos", Quantity::kPosition},
    {"angle", Quantity::kPosition},      {"angles", Quantity::kPosition},
    {"theta", Quantity::kPosition},      {"qd", Quantity::kVelocity},
    {"dq", Quantity::kVelocity},         {"qdot", Quantity::kVelocity},
    {"dtheta", Quantity::kVelocity},     {"velocity", Quantity::kVelocity},
    {"velocities", Quantity::kVelocity}, {"vel", Quantity::kVelocity},
    {"speed", Quantity::kVelocity},      {"speeds", Quantity::kVelocity},
    {"qdd", Quantity::kAcceleration},    {"ddq", Quantity::kAcceleration},
    {"qddot", Quantity::kAcceleration},  {"acceleration", Quantity::kAcceleration},
    {"acc", Quantity::kAcceleration},    {"accelerations", Quantity::kAcceleration},
    {"accel", Quantity::kAcceleration},  {"tau", Quantity::kTorque},
    {"torque", Quantity::kTorque},       {"torques", Quantity::kTorque},
    {"trq", Quantity::kTorque},          {"effort", Quantity::kTorque},
    {"efforts", Quantity::kTorque},      {"moment", Quantity::kTorque},
    {"moments", Quantity::kTorque},      {"current", Quantity::kCurrent},
    {"currents", Quantity::kCurrent},    {"i", Quantity::kCurrent},
    {"iq", Quantity::kCurrent},          {"amps", Quantity::kCurrent},
};

/// Words that make a channel something else, whatever the other words are.
constexpr KnownWord kOthers[] = {
    {"tcp", Quantity::kTool},         {"tool", Quantity::kTool},         {"wrench", Quantity::kTool},
    {"force", Quantity::kTool},       {"pose", Quantity::kTool},         {"ee", Quantity::kTool},
    {"cartesian", Quantity::kTool},   {"twist", Quantity::kTool},        {"transform", Quantity::kTool},
    {"transforms", Quantity::kTool},  {"temperature", Quantity::kOther}, {"temperatures", Quantity::kOther},
    {"temp", Quantity::kOther},       {"voltage", Quantity::kOther},     {"voltages", Quantity::kOther},
    {"error", Quantity::kOther},      {"errors", Quantity::kOther},      {"contact", Quantity::kOther},
    {"collision", Quantity::kOther},  {"dtau", Quantity::kOther},        {"window", Quantity::kOther},
    {"covariance", Quantity::kOther}, {"ext", Quantity::kOther},         {"external", Quantity::kOther},
    {"limit", Quantity::kOther},      {"limits", Quantity::kOther},      {"ratio", Quantity::kOther},
};

constexpr std::array kCommandWords = {"desired",   "des",     "target", "command",   "commands",
                                      "commanded", "cmd",     "ref",    "reference", "setpoint",
                                      "goal",      "control", "output"};

bool is(char c, int (*kind)(int)) {
  return kind(static_cast<unsigned char>(c)) != 0;
}

/// Returns the words of a name in lower case, without units in brackets. A capital letter after a small one
/// begins a word, except after a single letter.
std::vector<std::string> split_words(std::string_view name) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool hump =
        i > 0 && is(c, std::isupper) && is(name[i - 1], std::islower) && words.back().size() > 1;
    if (!is(c, std::isalpha) || hump) words.emplace_back();
    if (is(c, std::isalpha)) words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  std::erase(words, "");
  return words;
}

/// Takes a unit in brackets from the end of a name: "q1 [deg]" or "tau (Nm)".
std::string take_unit(std::string_view& name) {
  if (name.empty() || (name.back() != ']' && name.back() != ')')) return {};
  const std::size_t open = name.find_last_of("[(");
  if (open == std::string_view::npos) return {};
  std::string unit = usual_unit(name.substr(open + 1, name.size() - open - 2));
  if (!unit.empty()) name = name.substr(0, open);
  return unit;
}

/// Returns the unit that the last word of a name states, as in q1_deg.
std::string unit_word(const std::vector<std::string>& words) {
  if (words.size() < 2) return {};
  const std::string& last = words.back();
  const std::string unit = usual_unit(last);
  return unit == "deg" || unit == "rad" || unit == "A" || unit == "mA" || unit == "N m" ? unit
                                                                                        : std::string();
}

Quantity find(const std::vector<std::string>& words) {
  const auto has = [&words](std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  for (const KnownWord& known : kOthers) {
    if (has(known.word)) return known.quantity;
  }
  Quantity best = Quantity::kUnknown;
  bool current = false;
  for (const KnownWord& known : kQuantities) {
    if (!has(known.word)) continue;
    current = current || known.quantity == Quantity::kCurrent;
    if (known.quantity != Quantity::kCurrent && known.quantity > best) best = known.quantity;
  }
  // Beside another quantity the word is an adjective, as in current_position.
  return best == Quantity::kUnknown && current ? Quantity::kCurrent : best;
}

}  // namespace

const char* plural(Quantity quantity) {
  switch (quantity) {
    case Quantity::kPosition:
      return "positions";
    case Quantity::kVelocity:
      return "velocities";
    case Quantity::kAcceleration:
      return "accelerations";
    case Quantity::kTorque:
      return "torques";
    case Quantity::kCurrent:
      return "currents";
    case Quantity::kDrive:
      return "torques or currents";
    case Quantity::kTool:
      return "of the tool";
    case Quantity::kOther:
      return "other";
    default:
      return "unknown";
  }
}

ChannelWords words_of(std::string_view name) {
  ChannelWords found;
  found.unit = take_unit(name);
  const std::vector<std::string> words = split_words(name);
  found.quantity = find(words);
  if (found.unit.empty()) found.unit = unit_word(words);
  const bool known = found.quantity != Quantity::kUnknown;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const bool command = std::find(kCommandWords.begin(), kCommandWords.end(), word) != kCommandWords.end();
    // libfranka and others mark desired values with d at the end: q_d, tau_J_d.
    if (command || (known && i > 0 && i + 1 == words.size() && word == "d")) found.role = Role::kCommand;
    found.effort = found.effort || word == "effort" || word == "efforts";
  }
  return found;
}

ChannelWords words_of(std::string_view name, std::string_view topic) {
  if (!name.starts_with(topic)) return words_of(name);
  ChannelWords field = words_of(name.substr(topic.size()));
  if (field.quantity != Quantity::kUnknown && field.role == Role::kCommand) return field;
  const ChannelWords of_topic = words_of(topic);
  const std::vector<std::string> words = split_words(topic);
  const bool commands = !words.empty() && (words.back().starts_with("command") || words.back() == "cmd" ||
                                           words.back().starts_with("reference"));
  if (field.quantity == Quantity::kUnknown) field.quantity = of_topic.quantity;
  if (commands) field.role = Role::kCommand;
  return field;
}

std::string usual_unit(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (c != ' ' && c != '*' && c != '.' && c != '-' && c != '_')
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  struct Symbol {
    std::string_view text;
    const char* usual;
  };
  constexpr Symbol kSymbols[] = {{"rad", "rad"},
                                 {"radian", "rad"},
                                 {"radians", "rad"},
                                 {"deg", "deg"},
                                 {"degree", "deg"},
                                 {"degrees", "deg"},
                                 {"°", "deg"},
                                 {"rad/s", "rad/s"},
                                 {"deg/s", "deg/s"},
                                 {"°/s", "deg/s"},
                                 {"rad/s^2", "rad/s^2"},
                                 {"rad/s2", "rad/s^2"},
                                 {"deg/s^2", "deg/s^2"},
                                 {"deg/s2", "deg/s^2"},
                                 {"nm", "N m"},
                                 {"n", "N"},
                                 {"a", "A"},
                                 {"ma", "mA"},
                                 {"m", "m"},
                                 {"mm", "mm"},
                                 {"m/s", "m/s"},
                                 {"v", "V"},
                                 {"s", "s"},
                                 {"ms", "ms"},
                                 {"us", "us"},
                                 {"ns", "ns"}};
  for (const Symbol& symbol : kSymbols) {
    if (letters == symbol.text) return symbol.usual;
  }
  return {};
}

}  // namespace armtune::internal
