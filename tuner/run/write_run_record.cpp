#include "tuner/run/write_run_record.hpp"

#include <map>
#include <set>

#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/run/arithmetic.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/input_copies.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal {

RunRecord with_circumstances(RunRecord record, const FilesRead& files) {
  record.date = utc_time();
  record.versions.clear();
  for (const auto& [library, version] : versions()) record.versions.push_back({library, version});
  record.machine = this_machine();
  record.arithmetic = {arithmetic().level, arithmetic().fingerprint};
  record.inputs.clear();
  for (const std::string& path : std::set<std::string>(files.inputs.begin(), files.inputs.end()))
    record.inputs.push_back({shown_path(path), hash_of_input(path), {}, is_bundled(path)});
  const std::set<std::pair<std::string, std::string>> streamed(files.streamed.begin(), files.streamed.end());
  for (const auto& [path, hash] : streamed)
    record.inputs.push_back({shown_path(path), hash, {}, is_bundled(path)});
  return record;
}

void write_run_record(const std::string& folder, RunRecord record, const FilesRead& files) {
  RunRecord whole = with_circumstances(std::move(record), files);
  std::map<std::string, std::string> copies;
  for (const auto& [path, copy] : keep_inputs(folder, files.inputs)) copies[path] = copy;
  for (InputFact& input : whole.inputs) {
    if (const auto copy = copies.find(input.path); copy != copies.end()) input.copy = copy->second;
  }
  write_text_file(folder + "/" + kRunRecord, run_record_json(whole));
}

}  // namespace armtune::internal
