#include "tuner/rollouts/recording_memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <numeric>
#include <string>

#include "armtune/error.hpp"
#include "sim/rollout/columns.hpp"

namespace armtune::internal {
namespace {

constexpr double kGigabyte = 1e9;
/// Bytes of virtual memory for everything but recordings, such as the stacks of threads that begin later.
constexpr double kReserve = 64e6;
constexpr double kLeast = 1e6;  ///< bytes; what counts as usable at least, to divide by
constexpr double kKept = sizeof(double);
/// Bytes per value while its file is written (Recorder::write_csv): the value, a copy, and its text of up to
/// 24 characters. The text counts twice, because the buffer is copied when it grows.
constexpr double kWritten = 2.0 * sizeof(double) + 50.0;

/// Returns the number in a file of the kernel. It is infinite if the file is missing or contains "max".
double limit_in(const std::string& path) {
  double bytes = 0.0;
  return std::ifstream(path) >> bytes ? bytes : std::numeric_limits<double>::infinity();
}

/// Returns the folder of this process's control group (version 2), as in "0::/user.slice"; empty if none.
std::string control_group() {
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    if (line.starts_with("0::")) return line.substr(3);
  }
  return {};
}

/// Returns the size of this process in virtual memory [bytes]; 0 if the kernel does not tell.
double own_size() {
  double pages = 0.0;
  return std::ifstream("/proc/self/statm") >> pages ? pages * static_cast<double>(::sysconf(_SC_PAGESIZE))
                                                    : 0.0;
}

double rows(const Scenario& scenario, int stride) {
  return std::ceil(scenario.duration / scenario.control_period / stride) + 2.0;
}

}  // namespace

double recording_bytes(const Scenario& scenario, int stride, RecordingUse use) {
  const double values = rows(scenario, stride) * static_cast<double>(rollout_columns(scenario).size());
  return values * (use == RecordingUse::kWritten ? kWritten : kKept);
}

double usable_memory() {
  double bytes =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    bytes = std::min(bytes, std::max(kLeast, static_cast<double>(limit.rlim_cur) - own_size() - kReserve));
  const std::string groups = "/sys/fs/cgroup";
  for (const std::string& file : {groups + control_group() + "/memory.max", groups + "/memory.max",
                                  groups + "/memory/memory.limit_in_bytes"}) {
    bytes = std::min(bytes, limit_in(file));
  }
  return bytes;
}

void require_recording_memory(const std::vector<Scenario>& scenarios, int stride, int workers,
                              RecordingUse use, double usable) {
  std::vector<double> bytes;
  bytes.reserve(scenarios.size());
  for (const Scenario& scenario : scenarios) bytes.push_back(recording_bytes(scenario, stride, use));
  if (bytes.empty()) return;
  const auto longest = static_cast<std::size_t>(std::max_element(bytes.begin(), bytes.end()) - bytes.begin());
  const double largest = bytes[longest];
  std::sort(bytes.begin(), bytes.end(), std::greater<>());
  if (use == RecordingUse::kWritten)
    bytes.resize(std::min(bytes.size(), static_cast<std::size_t>(std::max(1, workers))));
  const double all = std::accumulate(bytes.begin(), bytes.end(), 0.0);
  if (all <= usable) return;
  const Scenario& scenario = scenarios[longest];
  const std::string others =
      bytes.size() > 1
          ? fmt::format(", and the recordings in memory at the same time take {:.3g} GB", all / kGigabyte)
          : std::string();
  throw InputError(
      InputPlace{scenario.source, 0, "duration"},
      fmt::format(
          "the recording of {} takes {:.3g} GB ({:.3g} s, {:.3g} rows){}, but this process may use only "
          "{:.3g} GB. Shorten 'duration'{}, or record only one in {:.0f} control periods (--record-every if the "
          "command has it, record_every in Python)",
          scenario.name, largest / kGigabyte, scenario.duration, rows(scenario, stride), others,
          usable / kGigabyte, bytes.size() > 1 && use == RecordingUse::kWritten ? ", use fewer workers" : "",
          std::ceil(stride * all / usable)))
      .with_value(fmt::format("{:.3g} GB", all / kGigabyte),
                  fmt::format("at most {:.3g} GB", usable / kGigabyte));
}

}  // namespace armtune::internal
