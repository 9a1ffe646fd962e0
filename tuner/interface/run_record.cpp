#include "armtune/run_record.hpp"

#include "armtune/error.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune {

RunRecord run_record(const std::string& folder) {
  const auto inside = internal::find_run_record(folder);
  if (!inside)
    throw InputError(InputPlace{folder},
                     "there is no run.json; give the folder of a run that has ended, or resume the run");
  RunRecord record;
  record.kind = internal::name(inside->kind);
  record.command = inside->command;
  record.date = inside->date;
  record.wall_seconds = inside->wall_seconds;
  record.seed = inside->seed;
  record.workers = inside->workers;
  for (const internal::ComponentVersion& one : inside->versions)
    record.versions.emplace_back(one.name, one.version);
  for (const internal::InputFact& input : inside->inputs)
    record.inputs.push_back({input.path, input.hash, input.copy});
  record.json = internal::run_record_json(*inside);
  return record;
}

}  // namespace armtune
