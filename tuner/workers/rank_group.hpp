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
  bool told = false;       ///< true if the user was told that rank 0 waits for it
};

class RankGroup {
 public:
  /// transport: null if this process is alone. If rank 0 waits for another rank for more than kSayAfter, it
  /// reports so to `notice`, once for each rank.
  explicit RankGroup(std::unique_ptr<Transport> transport, Notice notice = {});
  ~RankGroup();
  RankGroup(const RankGroup&) = delete;
  RankGroup& operator=(const RankGroup&) = delete;

  bool several() const { return transport_ != nullptr; }
  bool leads() const { return !transport_ || transport_->rank() == 0; }
  int ranks() const { return transport_ ? transport_->size() : 1; }

  /// Compares command line, versions and arithmetic of all ranks. Every process of a run calls it first, with
  /// its own command line. Returns true if the run can begin. If a rank differs, rank 0 throws InputError.
  /// The other ranks then return false after rank 0 has ended, and have nothing left to do.
  bool call_roll(const std::string& command_line);

  /// Begins the work on a plan. Every process of a command calls it once, as soon as it has the plan. Returns
  /// true in the process that leads. In any other process it does jobs until the leader needs no more, and
  /// then returns false: nothing is left to do. threads: of a process that is alone; a rank is one worker. In
  /// rank 0 throws InputError if `threads` is more than 1 among ranks, if a rank could not make its plan, or
  /// if its plan differs. Also throws FailedError if a rank does not answer within kStartSeconds.
  bool begin(RolloutPlan plan, int threads);

  /// Returns unused workers of the plan, for the process that leads. Workers of an earlier call may be used
  /// again, but not at the same time.
  std::unique_ptr<RolloutPool> pool();

  /// Reports what prevented this rank from calling begin(), in any rank but 0. Rank 0 throws it. Returns once
  /// rank 0 has dismissed this rank.
  void fail(const std::string& what);

  /// True once rank 0 has dismissed this rank, in any rank but 0. exit_code() is then that of the run.
  bool left() const { return left_; }
  int exit_code() const { return exit_code_; }

  /// Dismisses the other ranks with the exit code, in rank 0, whether or not the work succeeded. Returns
  /// false if one of them was given up before, with an exception. Throws FailedError if one does not leave.
  /// In both cases call abort() then.
  bool end(int exit_code);
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

/// Tells the user that rank 0 has waited for a peer for kSayAfter, once for each peer. what: the job that it
/// was asked for, if any; limit: time after which rank 0 gives it up [s].
void say_waiting(Peer& peer, double seconds, const std::string& what, double limit, const Notice& notice);

/// Returns the worker for rank 0 that passes jobs to `peer`. All arguments but the number must outlive it.
std::unique_ptr<RolloutWorker> rank_worker(Transport& transport, Peer& peer, std::uint64_t pool,
                                           const RolloutPlan& plan, const Notice& notice);

}  // namespace armtune::internal
