#pragma once
// What searches in lock step ask for as candidates to simulate, and what they are told of them.

#include <functional>
#include <optional>
#include <vector>

#include "tuner/evaluation/evaluator.hpp"
#include "tuner/solver/together.hpp"

namespace armtune::internal {

/// Points asked for that are not known, each once, in the order of the requests; those for differences are of
/// phase "gradient". known: whether a point was simulated before. allowed: asked before each candidate,
/// whether its search may have one more; where not, the rest of that request is left out.
std::vector<Candidate> candidates_of(const std::vector<Request>& requests, const char* phase,
                                     const std::function<bool(const SolverPoint&)>& known,
                                     const std::function<bool(std::size_t search)>& allowed);

/// Hands each request the values of its points up to the first that has none. value: of a point, as a search
/// is to see it; none if it was not simulated.
void answer(std::vector<Request>& requests, bool go_on,
            const std::function<std::optional<SolverValue>(std::size_t search, const SolverPoint&)>& value);

}  // namespace armtune::internal
