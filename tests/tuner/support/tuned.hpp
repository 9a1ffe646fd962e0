#pragma once
// Studies that are run with a journal beside them.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/evaluation/evaluations_file.hpp"
#include "tuner/search/tune.hpp"

namespace armtune::internal::test {

struct Tuned {
  TuneResult result;
  std::string journal;  ///< text of evaluations.csv
  std::vector<Evaluation> evaluations;
  double simulated = 0.0;  ///< by all rollouts together [s]
};

/// Runs the study with a journal, looking at the file after every callback.
inline Tuned run(const Study& study, int workers, const std::string& journal_path,
                 std::atomic<bool>* stop = nullptr, long stop_after = 0) {
  std::atomic<bool> never{false};
  std::atomic<bool>& flag = stop != nullptr ? *stop : never;
  CandidateRunner pool(study.scenarios, study.stepper, workers);
  std::unique_ptr<EvaluationsFile> journal;
  Tuned tuned;
  TuneCallbacks callbacks;
  callbacks.begin = [&](const Objective&) {
    journal = std::make_unique<EvaluationsFile>(journal_path, study);
  };
  callbacks.evaluated = [&](const char* phase, const Evaluation& e) {
    journal->append(phase, e);
    tuned.evaluations.push_back(e);
    const std::string text = read_text(journal_path);
    const auto rows = std::count(text.begin(), text.end(), '\n') - 1;
    EXPECT_EQ(static_cast<std::size_t>(rows), tuned.evaluations.size()) << "the row is on disk at once";
    if (stop_after > 0 && static_cast<long>(tuned.evaluations.size()) == stop_after) flag = true;
  };
  tuned.result = tune(study, pool, flag, callbacks);
  tuned.journal = read_text(journal_path);
  tuned.simulated = pool.simulated();
  return tuned;
}

/// The text without the last column of each line: the times.
inline std::string without_times(const std::string& text) {
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);) out += line.substr(0, line.rfind(',')) + "\n";
  return out;
}

}  // namespace armtune::internal::test
