#include "tuner/run/run_record.hpp"

#include <fmt/format.h>

#include "sim/yaml/document.hpp"
#include "tuner/record/json_lines.hpp"
#include "tuner/record/json_reader.hpp"
#include "tuner/record/json_writer.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::internal {
namespace {

/// Refuses another format with one message, instead of one about the first key that differs.
void require_known_format(const yaml::Node& root) {
  const yaml::Node* format = root.find("format");
  if (format == nullptr || format->as_integer() == RunRecord::kFormat) return;
  format->fail(fmt::format("format {} is not known; read this run with the armtune version that made it",
                           format->as_integer()),
               fmt::format("{}", RunRecord::kFormat));
}

RunRecord record_of(const yaml::Node& root) {
  require_known_format(root);
  RunRecord record;
  record::read(root, record);
  return record;
}

}  // namespace

std::string run_record_json(const RunRecord& record) {
  constexpr int kNested = 2;  // a line for each member of the record and of its parts, and for each input
  return record::in_lines(record::json_of(record), kNested) + '\n';
}

RunRecord parse_run_record(const std::string& text, const std::string& file) {
  return record_of(yaml::parse_text(text, file));
}

std::optional<RunRecord> find_run_record(const std::string& folder) {
  const auto path = find_run_file(folder, kRunRecord);
  if (!path) return std::nullopt;
  // Read from the disk, because this process may have written it again.
  return record_of(yaml::parse_file(*path, yaml::kMaxBytes));
}

std::string armtune_version(const RunRecord& record) {
  for (const ComponentVersion& one : record.versions) {
    if (one.name == "armtune") return one.version;
  }
  return {};
}

}  // namespace armtune::internal
