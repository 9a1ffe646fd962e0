// Whatever the bytes of any other file of a run: a page of the others. The first byte says which file it is.

#include <array>
#include <memory>

#include "tests/fuzz/support/run_folder.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::fuzz {
namespace {

/// A file, those in whose place it stands in another kind of run, and the kind of that run.
struct Kind {
  const char* file;
  std::array<const char*, 2> without = {};
  RunKind run = RunKind::kTune;
};

constexpr Kind kKinds[] = {{"verdict.yaml"},
                           {"study.yaml"},
                           {"gains.yaml"},
                           {"sensitivity.csv"},
                           {"margins.csv"},
                           {"yardstick.csv"},
                           {"robust_errors.csv"},
                           {"samples.csv", {"evaluations.csv"}, RunKind::kRobustness},
                           {"pareto.csv", {}, RunKind::kPareto},
                           {"errors_one.csv", {"scene.json", "evaluations.csv"}, RunKind::kCompare},
                           {"motion.csv", {"errors.csv", "evaluations.csv"}, RunKind::kPlan},
                           {"limits.csv", {"errors.csv", "evaluations.csv"}, RunKind::kPlan},
                           {"residuals.csv", {"errors.csv", "evaluations.csv"}, RunKind::kValidate},
                           {"horizons.csv", {"errors.csv", "evaluations.csv"}, RunKind::kValidate},
                           {"parameters.csv", {"errors.csv", "evaluations.csv"}, RunKind::kCalibrate},
                           {"held_out.csv", {"errors.csv", "evaluations.csv"}, RunKind::kCalibrate}};

/// Returns a record with the facts that the pages of the other kinds of runs need.
std::string record_of(RunKind kind) {
  RunRecord run;
  run.kind = kind;
  run.compare = {{"one"}};
  run.front = {{"objective", "joint_velocity/max_ratio"}, 2, true, 0.5};
  run.robustness.emplace().limits = {{"gaze/rms", true, 0.1}, {"joint_velocity/max_ratio", true, 1.0}};
  run.plan.emplace().headline = "0.1 s is the least time";
  run.validation.emplace().headline = "the arm matches the log";
  run.calibration.emplace().headline = "the error fell by 80 %";
  return run_record_json(run);
}

std::unique_ptr<RunFolder> folder_of(const Kind& kind) {
  auto folder = std::make_unique<RunFolder>();
  for (const char* name : kind.without) {
    if (name != nullptr) folder->remove(name);
  }
  if (std::string_view(kind.file) == "limits.csv") folder->write("motion.csv", "time\n0\n1\n");
  if (kind.run != RunKind::kTune) folder->write(kRunRecord, record_of(kind.run));
  return folder;
}

void check(std::string_view bytes) {
  if (bytes.empty()) return;
  const Kind& kind = kKinds[static_cast<unsigned char>(bytes.front() - 'a') % std::size(kKinds)];
  // One folder at a time, as its name is the process's.
  static const Kind* last = nullptr;
  static std::unique_ptr<RunFolder> folder;
  if (last != &kind) {
    folder.reset();
    folder = folder_of(kind);
    last = &kind;
  }
  folder->write(kind.file, bytes.substr(1));
  check_report(*folder);
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armtune::internal::fuzz::check(armtune::internal::fuzz::text(data, size));
  return 0;
}
