#include "tuner/solver/together.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace armtune::internal {
namespace {

/// Synchronises the threads of the searches with the caller's thread. NLopt cannot be suspended and resumed,
/// so a search waits inside its callback.
class Rounds {
 public:
  explicit Rounds(std::size_t searches) : places_(searches) {}

  /// Called in a search's thread. Requests the values of points, and waits for them. Returns false if the
  /// search must end at once.
  bool ask(std::size_t search, const std::vector<SolverPoint>& points, std::vector<SolverValue>& values);
  /// Called in a search's thread when the search has ended.
  void end(std::size_t search, SolverOutcome outcome, std::exception_ptr error);

  /// Called in the caller's thread. Serves the requests until all searches have ended.
  void run(const std::function<void(std::vector<Request>&)>& evaluate);
  std::vector<SolverOutcome> outcomes() const;

 private:
  enum class State { kSearching, kAsking, kEnded };
  struct Place {
    State state = State::kSearching;
    Request request;
    SolverOutcome outcome;
    std::exception_ptr error;
  };
  bool all(State state) const {
    return std::all_of(places_.begin(), places_.end(), [state](const Place& p) { return p.state == state; });
  }
  bool none(State state) const {
    return std::none_of(places_.begin(), places_.end(), [state](const Place& p) { return p.state == state; });
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Place> places_;
};

bool Rounds::ask(std::size_t search, const std::vector<SolverPoint>& points,
                 std::vector<SolverValue>& values) {
  std::unique_lock lock(mutex_);
  Place& place = places_[search];
  place.request = {search, points, {}, true};
  place.state = State::kAsking;
  changed_.notify_all();
  changed_.wait(lock, [&place] { return place.state == State::kSearching; });
  values = std::move(place.request.values);
  return place.request.go_on;
}

void Rounds::end(std::size_t search, SolverOutcome outcome, std::exception_ptr error) {
  const std::lock_guard lock(mutex_);
  Place& place = places_[search];
  place.outcome = std::move(outcome);
  place.error = std::move(error);
  place.state = State::kEnded;
  changed_.notify_all();
}

void Rounds::run(const std::function<void(std::vector<Request>&)>& evaluate) {
  std::exception_ptr failure;
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return none(State::kSearching); });
    for (const Place& place : places_) {
      if (place.error && !failure) failure = place.error;
    }
    if (all(State::kEnded)) break;
    std::vector<Request> requests;
    for (Place& place : places_) {
      if (place.state == State::kAsking) requests.push_back(std::move(place.request));
    }
    if (!failure) {
      lock.unlock();
      try {
        evaluate(requests);
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
    }
    for (Request& request : requests) {
      if (failure) request.go_on = false;
      Place& place = places_[request.search];
      place.request = std::move(request);
      place.state = State::kSearching;
    }
    changed_.notify_all();
  }
  if (failure) std::rethrow_exception(failure);
}

std::vector<SolverOutcome> Rounds::outcomes() const {
  std::vector<SolverOutcome> outcomes;
  outcomes.reserve(places_.size());
  for (const Place& place : places_) outcomes.push_back(place.outcome);
  return outcomes;
}

}  // namespace

std::vector<SolverOutcome> minimize_together(const std::vector<JoinedSearch>& searches,
                                             const std::function<void(std::vector<Request>&)>& evaluate) {
  Rounds rounds(searches.size());
  const auto search = [&](std::size_t s) {
    SolverOutcome outcome;
    std::exception_ptr error;
    try {
      SolverProblem problem = searches[s].problem;
      problem.evaluate = [&rounds, s](const std::vector<SolverPoint>& points,
                                      std::vector<SolverValue>& values) {
        return rounds.ask(s, points, values);
      };
      outcome = minimize(problem, searches[s].options);
    } catch (...) {
      error = std::current_exception();
    }
    rounds.end(s, std::move(outcome), std::move(error));
  };
  std::vector<std::jthread> threads;
  threads.reserve(searches.size());
  for (std::size_t s = 0; s < searches.size(); ++s) {
    try {
      threads.emplace_back(search, s);
    } catch (...) {  // no more threads: the searches that already wait must still end
      rounds.end(s, {}, std::current_exception());
    }
  }
  rounds.run(evaluate);
  return rounds.outcomes();
}

}  // namespace armtune::internal
