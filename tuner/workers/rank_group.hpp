#pragma once
// The processes that simulate the rollouts of one command together. Either this process works alone, with
// threads, or there are several MPI ranks. With ranks, rank 0 distributes the rollouts and collects the
// results.

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "tuner/ranks/transport.hpp"
#include "tuner/workers/rollout_pool.hpp"

namespace armtune::internal {

class LaneWorker;
struct Hello;

/// Another rank, as seen by rank 0.
struct Peer {
  int rank = 0;
  std::string host;
  std::uint64_t jobs = 0;  ///< number of jobs sent so far
  bool lost = false;       ///< true if it did not answer in time
  bool told = false;       ///< true once the user was told that rank 0 waits for this rank
};

class RankGroup {
 public:
  /// transport: null if this process works alone. If rank 0 waits for another rank for more than kSayAfter
  /// (transport.hpp), it reports this to `notice`, once for each rank.
  explicit RankGroup(std::unique_ptr<Transport> transport, Notice notice = {});
  ~RankGroup();
  RankGroup(const RankGroup&) = delete;
  RankGroup& operator=(const RankGroup&) = delete;

  /// True if there are several MPI ranks.
  bool several() const { return transport_ != nullptr; }
  /// True if this process distributes the rollouts: it works alone, or it is rank 0.
  bool leads() const { return !transport_ || transport_->rank() == 0; }
  int ranks() const { return transport_ ? transport_->size() : 1; }

  /// Compares command line, versions and arithmetic of all ranks. Every process of a run calls it first, with
  /// its own command line. Returns true if the run can begin. If a rank differs, rank 0 throws InputError. In
  /// the other ranks, the function then returns false as soon as rank 0 has dismissed them (see end()).
  bool call_roll(const std::string& command_line);

  /// Begins the work on a plan. Every process of a run calls it once, as soon as it has made the plan. In the
  /// process that leads, it returns true. In any other process it does jobs until rank 0 has no more of them,
  /// and then returns false. threads: number of threads of a process that works alone; each rank is one
  /// worker. Rank 0 throws InputError if `threads` is more than 1 although there are several ranks, if
  /// another rank could not make its plan, or if the plan of another rank differs. Rank 0 throws FailedError
  /// if a rank does not answer within kStartSeconds.
  bool begin(RolloutPlan plan, int threads);

  /// Returns a pool of new workers for the plan. Call it only in the process that leads. Pools of earlier
  /// calls can still be used, but not at the same time as the new one.
  std::unique_ptr<RolloutPool> pool();

  /// Reports to rank 0 why this rank cannot call begin(). Rank 0 then throws InputError with this text. Call
  /// it only in ranks other than 0. Returns as soon as rank 0 has dismissed this rank.
  void fail(const std::string& what);

  /// True if this is not rank 0, and rank 0 has dismissed it. exit_code() is then the exit code of the run.
  bool left() const { return left_; }
  int exit_code() const { return exit_code_; }

  /// Dismisses the other ranks, and sends them the exit code. Call it only in the process that leads, whether
  /// or not the work succeeded. Returns false if a rank failed to answer in time earlier in the run. Throws
  /// FailedError if a rank does not answer this call. In both cases, call abort() afterwards.
  bool end(int exit_code);
  /// Ends the processes of all ranks at once.
  void abort(int exit_code) { transport_->abort(exit_code); }

 private:
  std::string hear(Peer& peer, double limit);
  void compare(const Hello& own);
  void serve();
  void leave(const std::string& bye);
  std::string next_from_leader();
  void work(const std::string& message);

  std::unique_ptr<Transport> transport_;
  Notice notice_;
  int parent_ = 0;  ///< process id of the parent process
  std::shared_ptr<const RolloutPlan> plan_;
  int threads_ = 1;
  std::vector<Peer> peers_;
  bool met_ = false;
  std::uint64_t pools_ = 0;

  // Only in a rank that works for rank 0.
  std::deque<std::string> pending_;  ///< messages that came while jobs were under way
  std::unique_ptr<LaneWorker> worker_;
  std::uint64_t pool_ = 0;
  bool left_ = false;
  int exit_code_ = 0;
};

/// Reports to `notice` that rank 0 waits for a peer. Does nothing before kSayAfter, or if it was reported for
/// this peer before. seconds: duration of the wait [s]; what: the job that the peer does, may be empty;
/// limit: duration after which the run fails [s].
void say_waiting(Peer& peer, double seconds, const std::string& what, double limit, const Notice& notice);

/// Returns a worker in rank 0 that sends its jobs to `peer`. pool: number of its pool. The other arguments
/// must outlive the worker.
std::unique_ptr<RolloutWorker> rank_worker(Transport& transport, Peer& peer, std::uint64_t pool,
                                           const RolloutPlan& plan, const Notice& notice);

}  // namespace armtune::internal
