#include "tuner/gains/gains_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/control/laws/controller_kind.hpp"
#include "sim/scenario/gains_file.hpp"

namespace armtune::internal {
namespace {

/// One number or switch, with its value in every set.
struct Row {
  std::string name;  ///< name of the gain and of its part
  std::string unit;
  std::vector<std::string> text;              ///< the value in each set, as text
  std::vector<std::optional<double>> number;  ///< the value in each set, if it is a number
};

const GainField* find(const Gains& gains, const std::string& name) {
  const auto& fields = fields_of(gains);
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const GainField& f) { return f.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

/// Returns the fields that the controller of any set has, each once.
std::vector<GainField> all_fields(const std::vector<NamedGains>& sets) {
  std::vector<GainField> fields;
  for (const NamedGains& set : sets) {
    for (const GainField& field : fields_of(set.gains)) {
      const auto same = [&](const GainField& f) { return std::string(f.name) == field.name; };
      if (std::none_of(fields.begin(), fields.end(), same)) fields.push_back(field);
    }
  }
  return fields;
}

/// Returns the names of the field's numbers. Gains of forces have two forms with different counts, so the
/// names are from the set that has the most numbers.
std::vector<std::string> parts_of(const GainField& field, const std::vector<NamedGains>& sets,
                                  const std::vector<std::string>& joints) {
  if (!field.is_number()) return {""};
  std::vector<std::string> parts = component_names(field, joints);
  for (const NamedGains& set : sets) {
    auto own = component_names(set.gains, field, joints);
    if (own.size() > parts.size()) parts = std::move(own);
  }
  return parts;
}

/// Returns number `i` of `parts` numbers. If a force gain has one number per point, it counts for each joint.
std::optional<double> number_at(const Gains& gains, const GainField& field, std::size_t i, std::size_t parts,
                                std::size_t joints) {
  const auto values = numbers(gains, field);
  const bool one_per_point =
      std::holds_alternative<ForceGains Gains::*>(field.member) && values.size() == joints && parts > joints;
  const std::size_t place = one_per_point ? i / joints : i;
  return place < values.size() ? std::optional(values[place]) : std::nullopt;
}

void add_rows(const GainField& field, const std::vector<NamedGains>& sets,
              const std::vector<std::string>& joints, std::vector<Row>& rows) {
  const auto parts = parts_of(field, sets, joints);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Row row{parts[i].empty() ? field.name : fmt::format("{}/{}", field.name, parts[i]), field.unit, {}, {}};
    for (const auto& [name, gains] : sets) {
      const GainField* own = find(gains, field.name);
      std::optional<double> number;
      if (own != nullptr && own->is_number()) number = number_at(gains, *own, i, parts.size(), joints.size());
      row.number.push_back(number);
      const bool is_switch = own != nullptr && !own->is_number();
      row.text.push_back(is_switch ? field_text(gains, *own) : number ? fmt::format("{:.6g}", *number) : "-");
    }
    rows.push_back(std::move(row));
  }
}

/// Compares the exact numbers, not the digits shown.
bool is_same(const Row& row) {
  for (std::size_t i = 1; i < row.text.size(); ++i) {
    if (row.number[i] != row.number[0] || row.text[i] != row.text[0]) return false;
  }
  return true;
}

/// Shows all digits if numbers that differ would otherwise look the same.
void tell_apart(Row& row) {
  const auto looks_same = [&row](std::size_t i) {
    return row.number[i] && row.number[0] && row.number[i] != row.number[0] && row.text[i] == row.text[0];
  };
  bool any = false;
  for (std::size_t i = 1; i < row.text.size(); ++i) any = any || looks_same(i);
  if (!any) return;
  for (std::size_t i = 0; i < row.text.size(); ++i) {
    if (row.number[i]) row.text[i] = fmt::format("{}", *row.number[i]);
  }
}

std::string ratio(const Row& row, std::size_t set) {
  if (!row.number[set] || !row.number[0] || *row.number[0] == 0.0) return "";
  const double exact = *row.number[set] / *row.number[0];
  std::string text = fmt::format("{:.4g}", exact);
  return text == "1" && row.number[set] != row.number[0] ? fmt::format("1{:+.1e}", exact - 1.0) : text;
}

}  // namespace

std::string gains_difference(const std::vector<NamedGains>& sets, const std::vector<std::string>& joints) {
  std::vector<Row> rows;
  Row controller{"controller", "", {}, {}};
  for (const NamedGains& set : sets) {
    controller.text.push_back(set.gains.controller);
    controller.number.emplace_back();
  }
  rows.push_back(std::move(controller));
  for (const GainField& field : all_fields(sets)) add_rows(field, sets, joints, rows);
  const auto all = rows.size();
  std::erase_if(rows, is_same);
  for (Row& row : rows) tell_apart(row);
  if (rows.empty()) return fmt::format("all {} values are the same\n", all);

  std::size_t width = 4;
  for (const Row& row : rows) width = std::max(width, row.name.size());
  std::string text = fmt::format("{:<{}}  {:<10}", "gain", width, "unit");
  for (std::size_t i = 0; i < sets.size(); ++i) {
    text += fmt::format("  {:>14}", sets[i].name);
    if (i > 0) text += fmt::format("  {:>9}", "ratio");
  }
  for (const Row& row : rows) {
    text += fmt::format("\n{:<{}}  {:<10}", row.name, width, row.unit);
    for (std::size_t i = 0; i < sets.size(); ++i) {
      text += fmt::format("  {:>14}", row.text[i]);
      if (i > 0) text += fmt::format("  {:>9}", ratio(row, i));
    }
  }
  return text + fmt::format("\n{} of {} values are the same\n", all - rows.size(), all);
}

}  // namespace armtune::internal
