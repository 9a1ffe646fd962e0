#pragma once
// Reads a CSV file that armtune wrote, and computes the hash of exactly the bytes that were read. run.json
// lists this hash. Thus it describes the data that were used, even if the file is edited afterwards.

#include <string>

#include "sim/csv/csv_table.hpp"

namespace armtune::internal {

struct HashedTable {
  CsvTable table;
  std::string hash;  ///< in the form of run.json
};

/// Reads a file that armtune wrote. Throws InputError as CsvTable::read does.
HashedTable read_hashed_table(const std::string& path);

}  // namespace armtune::internal
