// Whatever the bytes: a table of which every cell is text and a number or none, a log whose times grow, or a
// line that refuses them.

#include "sim/csv/csv_table.hpp"
#include "tests/fuzz/support/input.hpp"
#include "tuner/identification/log_file.hpp"

namespace armtune::internal::fuzz {
namespace {

void check_table(std::string_view bytes, CsvOrigin origin) {
  read_or_refuse([&] {
    const CsvTable table = CsvTable::parse(std::string(bytes), "input.csv", origin);
    for (std::size_t column = 0; column < table.header().size(); ++column) {
      require(table.find(table.header()[column]) == column);
      for (std::size_t row = 0; row < table.rows(); ++row) {
        require(table.text(row, column).size() <= bytes.size());
      }
      read_or_refuse([&] { require(table.numbers(column).size() == table.rows()); });
    }
  });
}

void check_log(std::string_view bytes) {
  const InputFile file(bytes);
  read_or_refuse([&] {
    LogFile log(file.path(), {{"t"}, {{"q"}}, {{"v"}}, {{"u"}}, true});
    require(log.period() > 0.0);
    double last = -INFINITY;
    while (const auto sample = log.next()) {
      require(sample->time > last && sample->q.allFinite() && sample->torque.allFinite());
      require(sample->qd.size() == (log.has_velocities() ? 1 : 0));
      last = sample->time;
    }
  });
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = armtune::internal::fuzz::text(data, size);
  armtune::internal::fuzz::check_table(bytes, armtune::internal::CsvOrigin::kUser);
  armtune::internal::fuzz::check_table(bytes, armtune::internal::CsvOrigin::kArmtune);
  armtune::internal::fuzz::check_log(bytes);
  return 0;
}
