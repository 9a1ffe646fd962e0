#pragma once
// The record of a run, run.json in its folder: how its results were made, and what it found.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace armtune {

/// An input file of a run.
struct RunInput {
  std::string path = {};  ///< as the run named it; "bundled DIR/NAME" for armtune's own files
  std::string hash = {};  ///< hash of the bytes that were read
  std::string copy = {};  ///< path of its copy below the run folder; empty: there is none
};

/// The facts that every run records.
struct RunRecord {
  std::string kind = {};     ///< name of the command, such as "tune"
  std::string command = {};  ///< repeats the run in a shell
  std::string date = {};     ///< time at which the run ended, UTC, such as "2026-11-26T05:27:03Z"
  double wall_seconds = 0.0;
  std::uint64_t seed = 0;
  int workers = 1;
  std::vector<std::pair<std::string, std::string>> versions = {};  ///< name and version of each library
  std::vector<RunInput> inputs = {};
  std::string json = {};  ///< the text of run.json, with what this kind of run found (docs/file_formats.md)
};

/// Reads the record of a run folder. Throws InputError if there is none, because the run has not ended, or if
/// it cannot be read.
RunRecord run_record(const std::string& folder);

}  // namespace armtune
