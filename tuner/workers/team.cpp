#include "tuner/workers/team.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

#include "core/common/error.hpp"
#include "tuner/run/arithmetic.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/workers/lane_worker.hpp"
#include "tuner/workers/leader_jobs.hpp"
#include "tuner/workers/messages.hpp"
#include "tuner/workers/patience.hpp"

namespace armtune {
namespace {

constexpr double kStartSeconds = 120.0;  ///< to read a study, from a slow disk too
constexpr double kEndSeconds = 10.0;

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown host";
}

Hello hello_of(const RolloutPlan& plan) {
  Hello hello;
  hello.host = host_name();
  for (const auto& [library, version] : versions())
    hello.facts.emplace_back("version of " + library, version);
  hello.facts.emplace_back("arithmetic", arithmetic().level + ", " + arithmetic().fingerprint);
  for (const auto& fact : facts_of(plan)) hello.facts.push_back(fact);
  return hello;
}

/// The first difference, or empty.
std::string difference(const Hello& rank, const Hello& leader) {
  for (std::size_t i = 0; i < rank.facts.size() && i < leader.facts.size(); ++i) {
    const auto& [what, theirs] = rank.facts[i];
    const auto& [expected, ours] = leader.facts[i];
    if (what != expected) return fmt::format("has {} where rank 0 has {}", what, expected);
    if (theirs != ours) return fmt::format("has another {}: {}, rank 0 has {}", what, theirs, ours);
  }
  if (rank.facts.size() == leader.facts.size()) return {};
  return fmt::format("has {} facts, rank 0 has {}", rank.facts.size(), leader.facts.size());
}

}  // namespace

Team::Team(std::unique_ptr<Transport> transport) : transport_(std::move(transport)), parent_(::getppid()) {
  if (!several() || !leads()) return;
  for (int rank = 1; rank < ranks(); ++rank) peers_.push_back({rank, "an unknown host", 0, false});
}

Team::~Team() = default;

bool Team::begin(RolloutPlan plan, int threads) {
  plan_ = std::make_shared<const RolloutPlan>(std::move(plan));
  threads_ = threads;
  if (!several()) return true;
  if (!leads()) {
    transport_->send(0, hello_message(hello_of(*plan_)));
    serve();
    return false;
  }
  if (threads > 1) {
    throw InputError(
        fmt::format("--workers is {}, but each of the {} ranks is one worker: start more ranks instead",
                    threads, ranks()));
  }
  meet();
  return true;
}

void Team::meet() {
  const Hello own = hello_of(*plan_);
  Patience patience;
  for (Peer& peer : peers_) {
    std::optional<std::string> message;
    while (!(message = transport_->receive(peer.rank))) {
      if (patience.seconds() > kStartSeconds) {
        peer.lost = true;
        throw std::runtime_error(fmt::format("rank {} has said nothing for {} s: it hangs, or never started",
                                             peer.rank, kStartSeconds));
      }
      patience.sleep();
    }
    const Hello hello = read_hello(*message);
    peer.host = hello.host;
    if (!hello.failure.empty()) {
      throw InputError(fmt::format("rank {} on {}: {}", peer.rank, peer.host, hello.failure));
    }
    const std::string differs = difference(hello, own);
    if (!differs.empty()) {
      throw InputError(
          fmt::format("rank {} on {} {}; start every rank with the same program, command and files",
                      peer.rank, peer.host, differs));
    }
  }
  for (const Peer& peer : peers_) transport_->send(peer.rank, plain_message(MessageKind::kGo));
  met_ = true;
}

std::unique_ptr<Crew> Team::crew() {
  if (!several()) return std::make_unique<Crew>(*plan_, threads_);
  ++crews_;
  std::vector<std::unique_ptr<Worker>> workers;
  workers.reserve(peers_.size() + 1);
  workers.push_back(std::make_unique<LaneWorker>(*plan_));
  for (Peer& peer : peers_) workers.push_back(rank_worker(*transport_, peer, crews_, *plan_));
  return std::make_unique<Crew>(plan_, std::move(workers));
}

void Team::fail(const std::string& what) {
  Hello hello;
  hello.host = host_name();
  hello.failure = what;
  transport_->send(0, hello_message(hello));
  serve();
}

std::string Team::next_from_leader() {
  if (!pending_.empty()) {
    std::string message = std::move(pending_.front());
    pending_.pop_front();
    return message;
  }
  for (Patience patience;; patience.sleep()) {
    if (auto message = transport_->receive(0)) return std::move(*message);
    // What started this process is gone: so is the run.
    if (::getppid() != parent_) std::_Exit(EXIT_FAILURE);
  }
}

void Team::serve() {
  for (;;) {
    const std::string message = next_from_leader();
    switch (kind_of(message)) {
      case MessageKind::kGo:
      case MessageKind::kStop:  // of a job that was done before it came
        break;
      case MessageKind::kJob:
        work(message);
        break;
      case MessageKind::kBye:
        transport_->send(0, plain_message(MessageKind::kLeaving));
        transport_->end();
        return;
      default:
        throw std::runtime_error("rank 0 sent a message that is none of its own kinds");
    }
  }
}

void Team::work(const std::string& message) {
  LeaderJobs jobs(*transport_, message, pending_);
  if (!worker_ || jobs.crew() != crew_) worker_ = std::make_unique<LaneWorker>(*plan_);
  crew_ = jobs.crew();
  try {
    worker_->work(jobs);
    jobs.interrupt();
  } catch (const std::exception& e) {
    jobs.fail(e.what());
  }
}

bool Team::end() {
  if (!several()) return true;
  if (std::any_of(peers_.begin(), peers_.end(), [](const Peer& peer) { return peer.lost; })) return false;
  for (const Peer& peer : peers_) {
    transport_->send(peer.rank, plain_message(MessageKind::kBye));
  }
  Patience patience;
  for (const Peer& peer : peers_) {
    for (bool leaving = false; !leaving; patience.sleep()) {
      const auto message = transport_->receive(peer.rank);
      leaving = message && kind_of(*message) == MessageKind::kLeaving;
      if (!leaving && patience.seconds() > (met_ ? kEndSeconds : kStartSeconds)) {
        throw std::runtime_error(fmt::format("rank {} on {} does not leave: it hangs", peer.rank, peer.host));
      }
    }
  }
  transport_->end();
  return true;
}

}  // namespace armtune
