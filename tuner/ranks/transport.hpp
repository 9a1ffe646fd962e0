#pragma once
// Exchanges messages between the processes (MPI ranks) of one run, and finds out which rank this process is.
// A run on several ranks needs an armtune that was built with MPI.

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace armtune::internal {

/// The place of a process as the launcher (mpirun, srun) gives it in the environment, before MPI is started.
struct RankPlace {
  int rank = 0;
  int size = 1;  ///< 1 if nothing launched this process, or launched it alone
};
RankPlace rank_place();
/// Returns the number of tasks that srun started without connecting them as ranks; 0 unless it did.
int strangers();

/// Returns the name of this machine, as messages show it.
std::string host_name();

/// A function that shows the user a message while the work continues. It is called from any thread.
using Notice = std::function<void(const std::string&)>;

// How long rank 0 waits for another rank, without the time in which it is stopped itself. [s]
constexpr double kSayAfter = 10.0;       ///< after this it tells the user, once for each rank
constexpr double kStartSeconds = 120.0;  ///< to start and to read a study, also from a slow disk
constexpr double kEndSeconds = 10.0;     ///< to end

/// A connection to the other ranks. It can be called from any thread. Only end() waits for another process.
class Transport {
 public:
  Transport() = default;
  virtual ~Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// Sends a message. It is kept until it is received. Messages from one rank to another arrive in order.
  virtual void send(int to, std::string message) = 0;
  /// Returns the next message of a rank, if there is one.
  virtual std::optional<std::string> receive(int from) = 0;
  /// Ends MPI together with all other ranks. No call may follow.
  virtual void end() = 0;
  /// Ends the processes of all ranks at once.
  virtual void abort(int exit_code) = 0;
};

/// Starts MPI, once in the life of a process, and returns when all ranks have started. While rank 0 waits for
/// them it reports so to `notice`. No rank waits longer than kStartSeconds and five more; then the process
/// ends with exit code 1. Throws InputError if armtune was built without MPI, or if MPI sees other ranks than
/// the launcher started.
std::unique_ptr<Transport> begin_mpi(const Notice& notice);

/// Returns the version of the linked MPI library, or "not built in".
std::string mpi_version();

}  // namespace armtune::internal
