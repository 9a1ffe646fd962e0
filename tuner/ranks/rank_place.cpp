#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "tuner/ranks/transport.hpp"

namespace armtune::internal {
namespace {

std::optional<int> number(const char* variable) {
  const char* text = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): before any thread
  if (!text) return std::nullopt;
  const std::string_view view(text);
  int value = 0;
  const auto [end, error] = std::from_chars(view.data(), view.data() + view.size(), value);
  if (error != std::errc() || end != view.data() + view.size() || value < 0) return std::nullopt;
  return value;
}

}  // namespace

RankPlace rank_place() {
  // Variables of Open MPI's mpirun, and of srun with PMI-2 and with PMIx. With PMIx the number of tasks is in
  // a variable of Slurm.
  struct Names {
    const char* rank;
    const char* size;
  };
  for (const Names& names : {Names{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                             Names{"PMI_RANK", "PMI_SIZE"}, Names{"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}}) {
    const auto rank = number(names.rank);
    const auto size = number(names.size);
    if (rank && size && *rank < *size) return {*rank, std::max(1, *size)};
  }
  return {};
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown host";
}

int strangers() {
  const auto tasks = number("SLURM_STEP_NUM_TASKS");
  return rank_place().size == 1 && tasks && *tasks > 1 && number("SLURM_PROCID") ? *tasks : 0;
}

}  // namespace armtune::internal
