// Whatever the bytes of a run's evaluations.csv: a page of the others, and a line that says why it is not
// there.

#include "tests/fuzz/support/run_folder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const armtune::internal::fuzz::RunFolder folder;
  folder.write("evaluations.csv", armtune::internal::fuzz::text(data, size));
  armtune::internal::fuzz::check_report(folder);
  return 0;
}
