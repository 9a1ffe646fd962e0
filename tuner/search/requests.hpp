#pragma once
// Passes points between the simulation and several searches that run at once, in lock step. The points that
// the searches request become candidates to simulate. Each search then receives the values of its points.

#include <functional>
#include <optional>
#include <vector>

#include "tuner/evaluation/evaluator.hpp"
#include "tuner/solver/together.hpp"

namespace armtune::internal {

/// Returns the requested points that are not known, each once, in the order of the requests. Points for
/// finite differences have the phase "gradient", all others have `phase`. known: true if a point was
/// simulated before. allowed: called before each candidate; true if the search with this index may have one
/// more evaluation. If not, the remaining points of its request are left out.
std::vector<Candidate> candidates_of(const std::vector<Request>& requests, const char* phase,
                                     const std::function<bool(const SolverPoint&)>& known,
                                     const std::function<bool(std::size_t search)>& allowed);

/// Gives each request the values of its points, up to the first point without a value. go_on: if false, the
/// searches end. value: returns the value of a point for the search with this index, or nothing if the point
/// was not simulated.
void answer(std::vector<Request>& requests, bool go_on,
            const std::function<std::optional<SolverValue>(std::size_t search, const SolverPoint&)>& value);

}  // namespace armtune::internal
