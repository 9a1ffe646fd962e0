#include "tuner/run/run_folder.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <Eigen/Core>
#include <cerrno>
#include <chrono>
#include <climits>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>

#include "armtune/error.hpp"
#include "core/common/file_name.hpp"
#include "core/common/file_path.hpp"
#include "core/common/input_file.hpp"
#include "core/common/path_state.hpp"
#include "core/common/utf8.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/ranks/transport.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

std::string utc(const char* format) {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  return fmt::format(fmt::runtime(format), fmt::gmtime(std::chrono::system_clock::to_time_t(now)));
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

/// Refuses a path that is too long for the files below it, or that result files could not contain.
void refuse_unusable_path(const std::string& folder) {
  // The longest path below it is "rollouts_<label>/rollout_<scenario>.csv.partial".
  constexpr std::size_t kBelow = 2 * kLongestName + 40;
  if (folder.size() + kBelow > PATH_MAX) {
    throw InputError(InputPlace{folder},
                     fmt::format("the path has {} bytes; choose a path of at most {} bytes", folder.size(),
                                 PATH_MAX - kBelow));
  }
  if (!is_printable(folder)) {
    throw InputError(
        InputPlace{folder},
        "the path contains a control character, a line separator or a byte that is not UTF-8, which "
        "result files cannot hold; choose another folder");
  }
}

}  // namespace

void refuse_used_folder(const std::string& folder) {
  if (is_missing_or_empty(folder)) return;
  throw InputError(InputPlace{folder},
                   "this folder exists and is not empty; name another folder with --out, or delete this one");
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool FolderLock::take() {
  return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
}

FolderLock make_run_folder(const std::string& folder) {
  if (folder.empty()) return {};
  absolute_path(".");  // the run's record needs it: refused now, not when the folder is made
  refuse_unusable_path(absolute_path(folder));
  refuse_used_folder(folder);
  const bool is_new = !is_there(folder);
  make_folder(folder);
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const int reason = errno;
  const auto take_away = [&] {  // only if it is empty
    std::error_code ignored;
    if (is_new) fs::remove(folder, ignored);
  };
  if (descriptor < 0) {
    take_away();
    throw InputError(InputPlace{folder},
                     fmt::format("cannot open this folder: {}; name another one with --out",
                                 std::generic_category().message(reason)));
  }
  FolderLock lock(descriptor);
  // If the file system cannot lock folders, only the contents of the folder show another run.
  if (!lock.take() && errno == EWOULDBLOCK) {
    throw InputError(InputPlace{folder},
                     "another run is about to write into this folder; name another folder with --out");
  }
  try {
    refuse_used_folder(folder);  // a run that has ended meanwhile may have used it
  } catch (const InputError&) {
    take_away();
    throw;
  }
  return lock;
}

std::string default_run_folder(const std::string& name) {
  return fmt::format("runs/{}_{}", name, utc("{:%Y%m%d-%H%M%S}"));
}

std::vector<std::pair<std::string, std::string>> versions() {
  return {{"armtune", ARMTUNE_VERSION},
          {"compiler", ARMTUNE_COMPILER},
          {"build_type", ARMTUNE_BUILD_TYPE},
          {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"simbody", ARMTUNE_SIMBODY_VERSION},
          {"nlopt", ARMTUNE_NLOPT_VERSION},
          {"suitesparse", ARMTUNE_SUITESPARSE_VERSION},
          {"urdfdom", ARMTUNE_URDFDOM_VERSION},
          {"console_bridge", ARMTUNE_CONSOLE_BRIDGE_VERSION},
          {"yaml_cpp", ARMTUNE_YAML_VERSION},
          {"cli11", ARMTUNE_CLI11_VERSION},
          {"nlohmann_json", ARMTUNE_JSON_VERSION},
          {"open_mpi", mpi_version()},
          {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
          {"three_js", ARMTUNE_THREE_VERSION},
          {"uplot", ARMTUNE_UPLOT_VERSION}};
}

void add_inputs(const std::vector<Scenario>& scenarios, std::vector<std::string>& inputs) {
  for (const Scenario& scenario : scenarios) {
    inputs.insert(inputs.end(), scenario.inputs.begin(), scenario.inputs.end());
  }
}

std::vector<std::pair<std::string, std::string>> hashes(const std::vector<std::string>& inputs) {
  std::vector<std::pair<std::string, std::string>> found;
  for (const std::string& file : std::set<std::string>(inputs.begin(), inputs.end())) {
    found.emplace_back(shown_path(file), hash_of_input(file));
  }
  return found;
}

std::string add_columns(const std::string& folder, const FileColumns& columns) {
  const auto path = find_run_file(folder, "columns.csv");
  constexpr std::size_t kMaxBytes = std::size_t{16} << 20;
  if (!path) return {};
  std::istringstream file(read_file(*path, kMaxBytes, "a run's columns.csv"));
  const std::string all = columns_csv({columns});
  const std::size_t header_end = all.find('\n') + 1;
  std::string text;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(columns.file + ",")) text += line + "\n";
  }
  write_text_file(*path, text + all.substr(header_end));
  return *path;
}

std::string utc_time() {
  return utc("{:%Y-%m-%dT%H:%M:%SZ}");
}

MachineFacts this_machine() {
  return {processor(), std::thread::hardware_concurrency()};
}

std::string measured_with() {
  std::string text;
  for (const auto& [library, version] : versions()) text += fmt::format("{} {}\n", library, version);
  return text + fmt::format("processor {}, {} hardware threads\ndate {}\n", processor(),
                            std::thread::hardware_concurrency(), utc("{:%Y-%m-%d}"));
}

}  // namespace armtune::internal
