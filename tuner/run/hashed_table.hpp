#pragma once
// A CSV file of a run with the hash of the bytes that were read. Therefore run.yaml is right about it even if
// the file is edited meanwhile.

#include <string>

#include "sim/csv/csv_table.hpp"

namespace armtune::internal {

struct HashedTable {
  CsvTable table;
  std::string hash;  ///< in the form of run.yaml
};

/// Reads a file that armtune wrote. Throws InputError as CsvTable::read does.
HashedTable read_hashed_table(const std::string& path);

}  // namespace armtune::internal
