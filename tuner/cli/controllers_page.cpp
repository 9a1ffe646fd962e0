#include "tuner/cli/controllers_page.hpp"

#include <fmt/format.h>

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal::cli {
namespace {

/// Returns true if only some controllers have this gain.
bool is_of_some(const GainField& field) {
  return field.of_law || std::holds_alternative<OwnGain>(field.member);
}

const char* shape(const GainField& field) {
  if (!field.is_number()) return "switch";
  if (std::holds_alternative<ForceGains Gains::*>(field.member)) return "per point";
  const auto names = component_names(field, {"one", "another"});
  return names.size() == 6 ? "task" : (names.size() == 2 ? "per joint" : "number");
}

bool is_tuned_by_default(const GainField& field) {
  return field.search != SearchRange::kNone && field.search != SearchRange::kBounded;
}

std::string range(const GainField& field) {
  if (field.search == SearchRange::kNone) return "";
  if (field.search == SearchRange::kBounded) return "only up to a given bound";
  if (field.search == SearchRange::kCriticalDamping) return "0 to max(Kp^2/4, 2*start)";
  return fmt::format("{:.3g} to {:.3g} times the start", field.lower_factor, field.upper_factor);
}

void add_rows(const std::vector<GainField>& fields, bool of_some, std::string& text) {
  for (const GainField& field : fields) {
    if (is_of_some(field) != of_some) continue;
    text += fmt::format("{} {:<28} {:<10} {:<26} {}{}\n", is_tuned_by_default(field) ? "*" : " ", field.name,
                        shape(field), range(field), field.meaning,
                        *field.unit ? fmt::format(" [{}]", field.unit) : "");
  }
}

}  // namespace

std::string controllers_text() {
  std::string text = "Gains that every controller has:\n";
  add_rows(gain_fields(), false, text);
  for (const ControllerKind* kind : controller_kinds()) {
    text += fmt::format("\n{}\n  {}\n", kind->name, kind->meaning);
    add_rows(fields_of(*kind), true, text);
  }
  return text +
         "\n* tuned by default, within the range shown. 'start' is the start value of the gain.\n"
         "Kp is the start value of task_space_gains_p for the same axis.\n"
         "'only up to a given bound': tuned only if the key 'upper' of the study, or the option\n"
         "--max-stiffness of armtune tune, gives the largest value.\n"
         "number: one value; per joint: one for each joint; per point: one for each joint origin or link;\n"
         "task: six values, for x y z and for the rotations about x y z; switch: one of two settings.\n"
         "A gains file names its controller with the key 'controller: NAME'; without this key the file is\n"
         "for the adaptive controller.\n"
         "To tune another controller than the one in a study: armtune tune STUDY --controller NAME\n";
}

}  // namespace armtune::internal::cli
