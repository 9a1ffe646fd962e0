#include "tuner/workers/rank_group.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "tuner/ranks/patience.hpp"
#include "tuner/run/arithmetic.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/workers/lane_worker.hpp"
#include "tuner/workers/leader_jobs.hpp"
#include "tuner/workers/messages.hpp"

namespace armtune::internal {
namespace {

using Facts = std::vector<std::pair<std::string, std::string>>;

/// Returns the facts that must be the same in every process. They are compared before any file is read.
Facts program_facts(const std::string& command_line) {
  Facts facts = {{"command line", command_line}};
  for (const auto& [library, version] : versions()) facts.emplace_back("version of " + library, version);
  facts.emplace_back("arithmetic", arithmetic().level + ", " + arithmetic().fingerprint);
  return facts;
}

/// A fact in which a rank differs from rank 0.
struct Difference {
  std::string text;    ///< clause that follows "the rank"
  std::string theirs;  ///< value of the rank
  std::string ours;    ///< value of rank 0
};

/// Returns the first difference, or nothing if there is none.
std::optional<Difference> difference(const Hello& rank, const Hello& leader) {
  for (std::size_t i = 0; i < rank.facts.size() && i < leader.facts.size(); ++i) {
    const auto& [what, theirs] = rank.facts[i];
    const auto& [expected, ours] = leader.facts[i];
    if (what != expected)
      return Difference{fmt::format("has {} where rank 0 has {}", what, expected), what, expected};
    if (theirs != ours) {
      return Difference{
          fmt::format("has another {}: {}, but rank 0 has {}", what, one_line(theirs), one_line(ours)),
          theirs, ours};
    }
  }
  if (rank.facts.size() == leader.facts.size()) return {};
  const std::string theirs = fmt::to_string(rank.facts.size());
  const std::string ours = fmt::to_string(leader.facts.size());
  return Difference{fmt::format("has {} values to compare, but rank 0 has {}", theirs, ours), theirs, ours};
}

}  // namespace

void say_waiting(Peer& peer, double seconds, const std::string& what, double limit, const Notice& notice) {
  if (seconds < kSayAfter || peer.told || !notice) return;
  peer.told = true;
  notice(fmt::format(
      "waiting for rank {} on {}, which has not answered for {:.0f} s{}; the run fails after {:.0f} s",
      peer.rank, peer.host, seconds, what.empty() ? "" : fmt::format(" ({})", what), limit));
}

RankGroup::RankGroup(std::unique_ptr<Transport> transport, Notice notice)
    : transport_(std::move(transport)), notice_(std::move(notice)), parent_(::getppid()) {
  if (!several() || !leads()) return;
  for (int rank = 1; rank < ranks(); ++rank) peers_.push_back({rank, "an unknown host", 0, false});
}

RankGroup::~RankGroup() = default;

bool RankGroup::call_roll(const std::string& command_line) {
  if (!several()) return true;
  const Hello own{host_name(), {}, program_facts(command_line)};
  if (leads()) {
    compare(own);
    return true;
  }
  transport_->send(0, hello_message(own));
  const std::string answer = next_from_leader();
  if (kind_of(answer) == MessageKind::kGo) return true;
  leave(answer);
  return false;
}

bool RankGroup::begin(RolloutPlan plan, int threads) {
  plan_ = std::make_shared<const RolloutPlan>(std::move(plan));
  threads_ = threads;
  if (!several()) return true;
  const auto own = [this] { return Hello{host_name(), {}, facts_of(*plan_)}; };
  if (!leads()) {
    transport_->send(0, hello_message(own()));
    serve();
    return false;
  }
  if (threads > 1) {
    throw InputError(
        InputPlace{.key = "--workers"},
        fmt::format(
            "{} workers are requested, but each of the {} ranks is one worker; start more ranks instead",
            threads, ranks()))
        .with_value(fmt::to_string(threads), "1");
  }
  compare(own());
  met_ = true;
  return true;
}

std::string RankGroup::hear(Peer& peer, double limit) {
  for (Patience patience;; patience.sleep()) {
    if (auto message = transport_->receive(peer.rank)) return std::move(*message);
    const double seconds = patience.seconds();
    if (seconds > limit) {
      peer.lost = true;
      throw FailedError(
          fmt::format("rank {} on {} has not answered for {} s: it hangs", peer.rank, peer.host, limit));
    }
    say_waiting(peer, seconds, {}, limit, notice_);
  }
}

void RankGroup::compare(const Hello& own) {
  for (Peer& peer : peers_) {
    const Hello hello = read_hello(hear(peer, kStartSeconds));
    peer.host = hello.host;
    const InputPlace place{.key = fmt::format("rank {} on {}", peer.rank, peer.host)};
    if (!hello.failure.empty()) throw InputError(place, hello.failure);
    if (const auto differs = difference(hello, own)) {
      throw InputError(place,
                       fmt::format("this rank {}; start every rank with the same program, command and files",
                                   differs->text))
          .with_value(one_line(differs->theirs), one_line(differs->ours));
    }
  }
  for (const Peer& peer : peers_) transport_->send(peer.rank, plain_message(MessageKind::kGo));
}

std::unique_ptr<RolloutPool> RankGroup::pool() {
  if (!several()) return std::make_unique<RolloutPool>(*plan_, threads_);
  ++pools_;
  std::vector<std::unique_ptr<RolloutWorker>> workers;
  workers.reserve(peers_.size() + 1);
  workers.push_back(std::make_unique<LaneWorker>(*plan_));
  for (Peer& peer : peers_) workers.push_back(rank_worker(*transport_, peer, pools_, *plan_, notice_));
  return std::make_unique<RolloutPool>(plan_, std::move(workers));
}

void RankGroup::fail(const std::string& what) {
  transport_->send(0, hello_message({host_name(), what, {}}));
  serve();
}

void RankGroup::leave(const std::string& bye) {
  exit_code_ = read_bye(bye);
  transport_->send(0, plain_message(MessageKind::kLeaving));
  transport_->end();
  left_ = true;
}

std::string RankGroup::next_from_leader() {
  if (!pending_.empty()) {
    std::string message = std::move(pending_.front());
    pending_.pop_front();
    return message;
  }
  for (Patience patience;; patience.sleep()) {
    if (auto message = transport_->receive(0)) return std::move(*message);
    // The process that started this one has ended, so the run has ended too.
    if (::getppid() != parent_) std::_Exit(EXIT_FAILURE);
  }
}

void RankGroup::serve() {
  for (;;) {
    const std::string message = next_from_leader();
    switch (kind_of(message)) {
      case MessageKind::kGo:
      case MessageKind::kStop:  // its job was done already
        break;
      case MessageKind::kJob:
        work(message);
        break;
      case MessageKind::kBye:
        leave(message);
        return;
      default:
        throw FailedError("rank 0 sent a message of an unexpected kind");
    }
  }
}

void RankGroup::work(const std::string& message) {
  LeaderJobs jobs(*transport_, message, pending_);
  if (!worker_ || jobs.pool() != pool_) worker_ = std::make_unique<LaneWorker>(*plan_);
  pool_ = jobs.pool();
  try {
    worker_->work(jobs);
    jobs.interrupt();
  } catch (const std::exception& e) {
    jobs.fail(e.what());
  }
}

bool RankGroup::end(int exit_code) {
  if (!several()) return true;
  if (std::any_of(peers_.begin(), peers_.end(), [](const Peer& peer) { return peer.lost; })) return false;
  for (const Peer& peer : peers_) transport_->send(peer.rank, bye_message(exit_code));
  for (Peer& peer : peers_) {
    while (kind_of(hear(peer, met_ ? kEndSeconds : kStartSeconds)) != MessageKind::kLeaving) {
    }
  }
  transport_->end();
  return true;
}

}  // namespace armtune::internal
