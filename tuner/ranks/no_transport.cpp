// Replaces mpi_transport.cpp if armtune is built without MPI.

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "tuner/ranks/transport.hpp"

namespace armtune::internal {

std::unique_ptr<Transport> begin_mpi(const Notice& /*notice*/) {
  throw InputError(fmt::format(
      "{} ranks were started, but this armtune was built without MPI (-DARMTUNE_MPI=OFF). Start one process "
      "and set its threads with --workers, or build armtune with MPI",
      rank_place().size));
}

std::string mpi_version() {
  return "not built in";
}

}  // namespace armtune::internal
