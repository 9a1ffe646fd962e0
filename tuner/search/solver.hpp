#pragma once
// The search algorithm behind a small interface: NLopt's types stay in solver.cpp.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace armtune {

/// Objective and constraints (g <= 0 holds; relative to their limits) at one point; all finite.
struct SolverValue {
  double objective = 0.0;
  std::vector<double> constraints;
};

struct SolverProblem {
  std::vector<double> start;  ///< inside [0, 1]^n
  std::size_t constraint_count = 0;
  /// Called for every point the algorithm asks for. Returns false to end the search.
  std::function<bool(const std::vector<double>& x, SolverValue& value)> evaluate;
};

/// How an algorithm is made to respect constraints.
enum class ConstraintHandling {
  kAuto,        ///< by the algorithm itself if it takes constraints, else kLagrangian
  kLagrangian,  ///< NLopt's augmented Lagrangian around it
  kPenalty      ///< exact penalty: objective + penalty * sum of max(0, g)
};

struct SolverOptions {
  std::string algorithm = "COBYLA";
  double initial_step = 0.1;         ///< of the unit box
  double x_tolerance = 1e-3;         ///< of the unit box
  double objective_tolerance = 0.0;  ///< relative; 0: the gains decide
  ConstraintHandling constraints = ConstraintHandling::kAuto;
  double penalty = 2.0;    ///< of kPenalty, per unit of relative violation
  std::uint64_t seed = 1;  ///< of algorithms that draw random numbers
};

struct SolverOutcome {
  bool converged = false;  ///< the algorithm itself found its end
  bool stopped = false;    ///< `evaluate` returned false
  std::string reason;
};

/// Names of the algorithms offered, with a word on each.
struct AlgorithmInfo {
  const char* name;
  bool takes_constraints;  ///< otherwise an augmented Lagrangian is put around it
  const char* meaning;
};
const std::vector<AlgorithmInfo>& algorithms();

/// Throws InputError that lists the names if the algorithm is not offered.
const AlgorithmInfo& algorithm_from_name(const std::string& name);

/// Searches the unit box. The caller keeps the best point itself.
SolverOutcome minimize(const SolverProblem& problem, const SolverOptions& options);

}  // namespace armtune
