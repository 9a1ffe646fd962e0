#pragma once
// Messages between the processes (ranks) of one run, and where a process stands among them. MPI is behind it,
// where armtune was built with it.

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace armtune::internal {

/// What the launcher (mpirun, srun) says through the environment, before MPI is begun.
struct RankPlace {
  int rank = 0;
  int size = 1;  ///< 1 where nothing launched this process, or launched it alone
};
RankPlace rank_place();
/// How many tasks srun started that know nothing of each other; 0 unless it did.
int strangers();

/// The name of this machine, as messages show it.
std::string host_name();

/// Tells the user something while the work continues. It is called from any thread.
using Notice = std::function<void(const std::string&)>;

// How long rank 0 waits for another rank, without the time in which it is stopped itself. [s]
constexpr double kSayAfter = 10.0;       ///< then it tells the user, once for each rank
constexpr double kStartSeconds = 120.0;  ///< to start and to read a study, from a slow disk too
constexpr double kEndSeconds = 10.0;     ///< to leave

/// Calls come from any thread; none waits for another process, but end().
class Transport {
 public:
  Transport() = default;
  virtual ~Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// Keeps the message until it is taken. Those of one rank to another arrive in order.
  virtual void send(int to, std::string message) = 0;
  /// The next message of a rank, if there is one.
  virtual std::optional<std::string> receive(int from) = 0;
  /// Leaves together with all others. Nothing may be called after it.
  virtual void end() = 0;
  /// Ends the processes of all ranks at once.
  virtual void abort(int exit_code) = 0;
};

/// Begins MPI, once in a process's life; it returns when all ranks have begun. While rank 0 waits for them it
/// says so to `notice`, and no rank waits longer than kStartSeconds and five more: then the process ends with
/// exit code 1. Throws InputError if armtune was built without MPI, or if MPI sees other ranks than the
/// launcher started.
std::unique_ptr<Transport> begin_mpi(const Notice& notice);

/// Version of the MPI library linked, or "not built in".
std::string mpi_version();

}  // namespace armtune::internal
