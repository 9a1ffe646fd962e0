#include "tuner/search/requests.hpp"

#include <set>
#include <utility>

namespace armtune::internal {

std::vector<Candidate> candidates_of(const std::vector<Request>& requests, const char* phase,
                                     const std::function<bool(const SolverPoint&)>& known,
                                     const std::function<bool(std::size_t search)>& allowed) {
  std::vector<Candidate> candidates;
  std::set<std::vector<double>> chosen;
  for (const Request& request : requests) {
    for (const SolverPoint& point : request.points) {
      if (known(point) || chosen.contains(point.x)) continue;
      if (!allowed(request.search)) break;
      chosen.insert(point.x);
      candidates.push_back({point.difference ? "gradient" : phase, point.x});
    }
  }
  return candidates;
}

void answer(std::vector<Request>& requests, bool go_on,
            const std::function<std::optional<SolverValue>(std::size_t search, const SolverPoint&)>& value) {
  for (Request& request : requests) {
    request.go_on = go_on;
    for (const SolverPoint& point : request.points) {
      auto known = value(request.search, point);
      if (!known) break;
      request.values.push_back(std::move(*known));
    }
  }
}

}  // namespace armtune::internal
