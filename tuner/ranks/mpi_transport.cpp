// Implements the transport with MPI's C interface. No other file includes mpi.h.

#include <fmt/format.h>
#include <mpi.h>

#include <cstdlib>
#include <limits>
#include <list>
#include <mutex>
#include <stdexcept>

#include "armtune/error.hpp"
#include "tuner/ranks/call_watch.hpp"
#include "tuner/ranks/transport.hpp"

namespace armtune::internal {
namespace {

constexpr int kTag = 1;

void check(int code, const char* what) {
  if (code != MPI_SUCCESS) throw FailedError(fmt::format("MPI: {} failed with code {}", what, code));
}

/// Watches a call that returns only when all ranks have made it. Rank 0 reports and gives up first. If the
/// launcher does not end another rank then, that rank ends itself.
CallWatch watch_all(const Notice& notice, const std::string& verb, double limit) {
  constexpr double kRankZeroFirst = 5.0;
  const RankPlace place = rank_place();
  const auto say = [notice, verb, place](const std::string& more) {
    notice(fmt::format("rank {} on {} has waited for the other {} ranks to {}: {}", place.rank, host_name(),
                       place.size - 1, verb, more));
  };
  const bool speaks = place.rank == 0;
  const double end = limit + (speaks ? 0.0 : kRankZeroFirst);
  return {
      kSayAfter,
      [say, speaks, end] {
        if (speaks) say(fmt::format("{} s so far; it gives up after {} s", kSayAfter, end));
      },
      end,
      [say, end] {
        say(fmt::format("{} s. One of them hangs, has ended or runs another program, so this run ends", end));
        std::_Exit(EXIT_FAILURE);
      }};
}

/// Makes one MPI call at a time, from any thread (MPI_THREAD_SERIALIZED). Sending and receiving return at
/// once, and a caller that waits sleeps in between, because a blocking receive of Open MPI keeps a processor
/// busy.
class MpiTransport final : public Transport {
 public:
  explicit MpiTransport(Notice notice) : notice_(std::move(notice)) {
    int provided = 0;
    {
      const CallWatch watch = watch_all(notice_, "start", kStartSeconds);
      check(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided), "MPI_Init_thread");
    }
    // Errors are returned as codes, so that the failure is reported before the ranks are ended.
    check(MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
    check(MPI_Comm_rank(MPI_COMM_WORLD, &rank_), "MPI_Comm_rank");
    check(MPI_Comm_size(MPI_COMM_WORLD, &size_), "MPI_Comm_size");
    if (provided < MPI_THREAD_SERIALIZED) {
      throw InputError(
          "MPI does not support MPI_THREAD_SERIALIZED; use an MPI that was built with support for threads");
    }
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  void send(int to, std::string message) override {
    const std::lock_guard lock(mutex_);
    drop_sent();
    if (message.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
      throw FailedError(fmt::format("MPI: a message of {} bytes is too long", message.size()));
    }
    Sent& sent = sent_.emplace_back();
    sent.message = std::move(message);
    check(MPI_Isend(sent.message.data(), static_cast<int>(sent.message.size()), MPI_BYTE, to, kTag,
                    MPI_COMM_WORLD, &sent.request),
          "MPI_Isend");
  }

  std::optional<std::string> receive(int from) override {
    const std::lock_guard lock(mutex_);
    drop_sent();
    int there = 0;
    MPI_Message handle = MPI_MESSAGE_NULL;
    MPI_Status status;
    check(MPI_Improbe(from, kTag, MPI_COMM_WORLD, &there, &handle, &status), "MPI_Improbe");
    if (!there) return std::nullopt;
    int size = 0;
    check(MPI_Get_count(&status, MPI_BYTE, &size), "MPI_Get_count");
    std::string message(static_cast<std::size_t>(size), '\0');
    check(MPI_Mrecv(message.data(), size, MPI_BYTE, &handle, &status), "MPI_Mrecv");
    return message;
  }

  void end() override {
    const std::lock_guard lock(mutex_);
    for (Sent& sent : sent_) MPI_Wait(&sent.request, MPI_STATUS_IGNORE);
    sent_.clear();
    const CallWatch watch = watch_all(notice_, "finish", kStartSeconds);
    MPI_Finalize();
  }

  void abort(int exit_code) override {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::_Exit(exit_code);
  }

 private:
  struct Sent {
    std::string message;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  void drop_sent() {
    for (auto s = sent_.begin(); s != sent_.end();) {
      int done = 0;
      check(MPI_Test(&s->request, &done, MPI_STATUS_IGNORE), "MPI_Test");
      s = done ? sent_.erase(s) : std::next(s);
    }
  }

  Notice notice_;
  int rank_ = 0;
  int size_ = 1;
  std::mutex mutex_;
  std::list<Sent> sent_;  ///< messages that MPI still reads; in a list, so that their addresses stay valid
};

}  // namespace

std::unique_ptr<Transport> begin_mpi(const Notice& notice) {
  auto transport = std::make_unique<MpiTransport>(notice);
  if (transport->size() != rank_place().size) {
    throw InputError(
        fmt::format("the launcher started {} ranks, but MPI sees {}. Use the mpirun of the MPI that armtune "
                    "was built with ({}); with srun, try --mpi=pmix",
                    rank_place().size, transport->size(), mpi_version()));
  }
  return transport;
}

std::string mpi_version() {
  return fmt::format("{}.{}.{}", OMPI_MAJOR_VERSION, OMPI_MINOR_VERSION, OMPI_RELEASE_VERSION);
}

}  // namespace armtune::internal
