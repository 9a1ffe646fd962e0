#pragma once
// The processes that do one command's rollouts together: this one alone, with threads, or ranks, of which
// rank 0 leads and the others work for it.

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "tuner/ranks/transport.hpp"
#include "tuner/workers/rollout_pool.hpp"

namespace armtune::internal {

class LaneWorker;
struct Hello;

/// Another rank, as rank 0 knows it.
struct Peer {
  int rank = 0;
  std::string host;
  std::uint64_t jobs = 0;  ///< sent so far
  bool lost = false;       ///< it gave no answer in time
  bool told = false;       ///< the user knows that rank 0 waits for it
};

class RankGroup {
 public:
  /// transport: none where this process is alone. While rank 0 waits for another rank for more than
  /// kSayAfter, it says so to `notice`, once for each rank.
  explicit RankGroup(std::unique_ptr<Transport> transport, Notice notice = {});
  ~RankGroup();
  RankGroup(const RankGroup&) = delete;
  RankGroup& operator=(const RankGroup&) = delete;

  bool several() const { return transport_ != nullptr; }
  bool leads() const { return !transport_ || transport_->rank() == 0; }
  int ranks() const { return transport_ ? transport_->size() : 1; }

  /// Every process of a run calls it first, with its own command line. True if the run can begin: every rank
  /// has the same command line, versions and arithmetic. Where they differ, rank 0 throws InputError, and the
  /// others return false once rank 0 has ended: nothing is left to do.
  bool call_roll(const std::string& command_line);

  /// Every process of a command calls it once, as soon as it knows the plan. True in the one that leads. In
  /// any other it does jobs until the leader needs no more, and is false then: nothing is left to do.
  /// threads: of a process that is alone; every rank is one worker. Throws InputError in rank 0 if that is
  /// more than 1 among ranks, if a rank could not make its plan, or if it has another plan. Throws
  /// FailedError if a rank says nothing for kStartSeconds.
  bool begin(RolloutPlan plan, int threads);

  /// Workers of the plan that have done nothing yet, for the process that leads. Those of an earlier call
  /// may be used again, but not at the same time.
  std::unique_ptr<RolloutPool> pool();

  /// In any rank but 0: what kept it from calling begin(). Rank 0 throws it; here it returns once the leader
  /// has heard it.
  void fail(const std::string& what);

  /// In any rank but 0: true once rank 0 has sent it home, and the exit code of the run.
  bool left() const { return left_; }
  int exit_code() const { return exit_code_; }

  /// In rank 0, whatever became of the work: sends the others home with the exit code. False if one of them
  /// was given up before, with an exception; throws FailedError if one does not leave. What is left
  /// then is abort().
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
  int parent_ = 0;  ///< process id of what started this one
  std::shared_ptr<const RolloutPlan> plan_;
  int threads_ = 1;
  std::vector<Peer> peers_;
  bool met_ = false;
  std::uint64_t pools_ = 0;

  // Of a rank that works.
  std::deque<std::string> pending_;  ///< came while jobs were under way
  std::unique_ptr<LaneWorker> worker_;
  std::uint64_t pool_ = 0;
  bool left_ = false;
  int exit_code_ = 0;
};

/// Tells the user, once for each peer, that rank 0 has waited for it for kSayAfter. what: it was asked
/// for, if anything; limit: after which rank 0 gives it up [s].
void say_waiting(Peer& peer, double seconds, const std::string& what, double limit, const Notice& notice);

/// In rank 0: the worker that is `peer`. All but the number outlive it.
std::unique_ptr<RolloutWorker> rank_worker(Transport& transport, Peer& peer, std::uint64_t pool,
                                           const RolloutPlan& plan, const Notice& notice);

}  // namespace armtune::internal
