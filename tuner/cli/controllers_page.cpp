#include "tuner/cli/controllers_page.hpp"

#include <fmt/format.h>

#include "core/control/laws/controller_kind.hpp"

namespace armtune::cli {
namespace {

constexpr const char* kMarkdownHead = R"(# Controllers and their gains

Made by `armtune controllers --markdown` from the declarations that files, `--help`, search spaces, journals and reports are
made from. A gains file names its controller (`controller: NAME`; without it, `adaptive`). In it numbers of a task are x y z,
then rotation about x y z, in the base frame; per joint they stand in a list in the arm's order, or by the joints' names.

States, references, gaze, return, obstacle avoidance and limits are the same for every controller. A controller of your own
in C++ is added with `register_controller` (core/control/laws/controller_kind.hpp); examples/controller is a project that
does.
)";

/// One that only some controllers have.
bool is_of_some(const GainField& field) {
  return field.of_law || std::holds_alternative<OwnGain>(field.member);
}

const char* shape(const GainField& field) {
  if (!field.is_number()) return "switch";
  if (std::holds_alternative<ForceGains Gains::*>(field.member))
    return "per force point: one, or a list per joint";
  const auto names = component_names(field, {"one", "another"});
  return names.size() == 6 ? "task" : (names.size() == 2 ? "per joint" : "number");
}

std::string range(const GainField& field) {
  if (field.search == SearchRange::kNone) return "";
  if (field.search == SearchRange::kCriticalDamping) return "0 to Kp^2 / 4";
  return fmt::format("{:.3g} to {:.3g} times the start", field.lower_factor, field.upper_factor);
}

std::string table(const std::vector<GainField>& fields, bool of_some) {
  std::string text = "\n| gain | unit | | tuned by default | meaning |\n|---|---|---|---|---|\n";
  for (const GainField& field : fields) {
    if (is_of_some(field) != of_some) continue;
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", field.name, field.unit, shape(field), range(field),
                        field.meaning);
  }
  return text;
}

}  // namespace

std::string controllers_markdown() {
  std::string text = fmt::format("{}\n## Every controller\n{}", kMarkdownHead, table(gain_fields(), false));
  for (const ControllerKind* kind : controller_kinds()) {
    text += fmt::format("\n## {}\n\n{}\n{}", kind->name, kind->meaning, table(fields_of(*kind), true));
  }
  return text;
}

std::string controllers_text() {
  std::string text;
  for (const ControllerKind* kind : controller_kinds()) {
    text += fmt::format("{}\n  {}\n", kind->name, kind->meaning);
    for (const GainField& field : fields_of(*kind)) {
      if (!is_of_some(field)) continue;
      text += fmt::format("  {} {:<28}{}{}\n", field.search != SearchRange::kNone ? "*" : " ", field.name,
                          field.meaning, *field.unit ? fmt::format(" [{}]", field.unit) : "");
    }
  }
  return text +
         "\n* tuned by default. Gains that every controller has: armtune tune --help.\n"
         "To tune one: armtune tune STUDY --controller NAME\n";
}

}  // namespace armtune::cli
