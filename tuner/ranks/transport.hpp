#pragma once
// Exchanges messages between the processes (MPI ranks) of one run, and finds out which rank this process is.
// A run on several ranks needs an armtune that was built with MPI.

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace armtune::internal {

/// The rank of this process and the number of ranks. The launcher (mpirun, srun) passes both in environment
/// variables, so they can be read before MPI is started.
struct RankPlace {
  int rank = 0;
  int size = 1;  ///< number of ranks; 1 if there is no launcher, or if it started one process only
};
RankPlace rank_place();
/// Returns the number of tasks if srun started several tasks but did not connect them as ranks; otherwise 0.
int strangers();

/// Returns the name of this machine, as messages show it.
std::string host_name();

/// A function that shows the user a message while the work continues. It is called from any thread.
using Notice = std::function<void(const std::string&)>;

// Times for which rank 0 waits for another rank [s]. Time in which rank 0 itself is stopped does not count.
constexpr double kSayAfter = 10.0;       ///< wait after which the user gets a message, once per rank
constexpr double kStartSeconds = 120.0;  ///< longest wait until a rank has started and read the study
constexpr double kEndSeconds = 10.0;     ///< longest wait until a rank has ended its work

/// A connection to the other ranks. It can be called from any thread. Only end() waits for another process.
class Transport {
 public:
  Transport() = default;
  virtual ~Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// Sends a message to the rank `to` without waiting. The message is kept until that rank receives it.
  /// Messages from one rank to another arrive in order.
  virtual void send(int to, std::string message) = 0;
  /// Returns the next message from the rank `from`, or nothing if none has arrived.
  virtual std::optional<std::string> receive(int from) = 0;
  /// Ends MPI in this process. Every rank must call it; no other call may follow.
  virtual void end() = 0;
  /// Ends the processes of all ranks at once.
  virtual void abort(int exit_code) = 0;
};

/// Starts MPI and returns when all ranks have started. Call it at most once in a process. If rank 0 has
/// waited for kSayAfter, it reports this to `notice`. Rank 0 waits at most kStartSeconds, the other ranks 5 s
/// longer. Then the process ends with exit code 1. Throws InputError if armtune was built without MPI, or if
/// the number of ranks in MPI differs from the number that the launcher started.
std::unique_ptr<Transport> begin_mpi(const Notice& notice);

/// Returns the version of the linked MPI library, or "not built in".
std::string mpi_version();

}  // namespace armtune::internal
