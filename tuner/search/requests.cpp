#include "tuner/search/requests.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace armtune {

std::vector<Candidate> candidates_of(const std::vector<Request>& requests, const char* phase,
                                     const std::function<bool(const SolverPoint&)>& known,
                                     const std::function<bool(std::size_t search)>& allowed) {
  std::vector<Candidate> candidates;
  std::map<std::vector<double>, std::size_t> chosen;
  for (const Request& request : requests) {
    for (const SolverPoint& point : request.points) {
      if (known(point)) continue;
      if (const auto same = chosen.find(point.x); same != chosen.end()) {
        double& bar = candidates[same->second].bar;
        bar = std::max(bar, point.bar);
        continue;
      }
      if (!allowed(request.search)) break;
      chosen.emplace(point.x, candidates.size());
      candidates.push_back({point.difference ? "gradient" : phase, point.x, point.bar});
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

}  // namespace armtune
