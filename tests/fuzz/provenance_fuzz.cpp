// Whatever the bytes of a run's run.json: a page of the others, and a line that says why it is not there. A
// record that is read is written and read again without a change.

#include "tests/fuzz/support/run_folder.hpp"
#include "tuner/run/run_record.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const armtune::internal::fuzz::RunFolder folder;
  folder.write(armtune::internal::kRunRecord, armtune::internal::fuzz::text(data, size));
  armtune::internal::fuzz::check_report(folder);
  armtune::internal::fuzz::read_or_refuse([] {
    using namespace armtune::internal;
    const RunRecord run = find_run_record(folder.path()).value();
    fuzz::require(parse_run_record(run_record_json(run), kRunRecord) == run);
  });
  return 0;
}
