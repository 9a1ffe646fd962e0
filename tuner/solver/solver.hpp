#pragma once
// The search algorithms behind a small interface: NLopt's types stay in solver.cpp.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace armtune::internal {

/// Objective and constraints (g <= 0 holds; relative to their limits) at one point; all finite.
struct SolverValue {
  double objective = 0.0;
  std::vector<double> constraints;
};

struct SolverPoint {
  std::vector<double> x;
  bool difference = false;  ///< asked for to form a derivative, not as a candidate
};

struct SolverProblem {
  std::vector<double> start;  ///< inside the box
  std::vector<double> lower;  ///< of the box; empty: 0
  std::vector<double> upper;  ///< empty: 1
  std::size_t constraint_count = 0;
  /// Called with the points a search wants next: one, or one and all differences around it. `values`
  /// comes empty and takes one per point, in order; fewer end the search as soon as it misses one. Returns
  /// false to end it at once.
  std::function<bool(const std::vector<SolverPoint>& points, std::vector<SolverValue>& values)> evaluate;

  double lower_bound(std::size_t i) const { return lower.empty() ? 0.0 : lower[i]; }
  double upper_bound(std::size_t i) const { return upper.empty() ? 1.0 : upper[i]; }
};

/// How an algorithm is made to respect constraints.
enum class ConstraintHandling {
  kAuto,        ///< by the algorithm itself if it takes constraints, else kLagrangian
  kLagrangian,  ///< NLopt's augmented Lagrangian around it
  kPenalty      ///< exact penalty: objective + penalty * sum of max(0, g)
};

/// How derivatives are formed, for algorithms that use them.
enum class Differences {
  kForward,  ///< one point per coordinate, towards the inside at a bound
  kCentral   ///< two, one at a bound
};

struct SolverOptions {
  std::string algorithm = "COBYLA";
  double initial_step = 0.2;         ///< of the unit box; at most 0.49 of the problem's box
  double x_tolerance = 1e-3;         ///< of the unit box
  double objective_tolerance = 0.0;  ///< relative; 0: the gains decide
  ConstraintHandling constraints = ConstraintHandling::kAuto;
  double penalty = 1.0;    ///< of kPenalty, per unit of relative violation
  std::uint64_t seed = 1;  ///< of algorithms that draw random numbers
  Differences differences = Differences::kForward;
  /// Of the unit box. A maximum over a simulation has kinks, and noise from the integrator: a step as short
  /// as rounding would allow sees those instead of the slope.
  double difference_step = 0.01;
};

struct SolverOutcome {
  bool converged = false;  ///< the algorithm itself found its end
  bool stopped = false;    ///< `evaluate` ended it
  std::string reason;
};

/// Names of the algorithms offered, with a word on each.
struct AlgorithmInfo {
  const char* name;
  bool local;              ///< searches from its start; otherwise it searches the whole box
  bool takes_constraints;  ///< otherwise an augmented Lagrangian is put around it
  bool uses_differences;
  bool draws_random_numbers;
  const char* meaning;
  std::size_t most_parameters = 0;  ///< 0: any number
};
const std::vector<AlgorithmInfo>& algorithms();

/// Throws InputError if the algorithm is not offered: it lists the names, or says what has taken the place of
/// one that was cut.
const AlgorithmInfo& algorithm_from_name(const std::string& name);

/// The same, and InputError if it does not take so many parameters.
const AlgorithmInfo& algorithm_for(const std::string& name, std::size_t parameters);

/// Searches the box. The caller keeps the best point itself. What is asked for, and in which order, is a
/// function of problem and options alone. Throws InputError as algorithm_for does.
SolverOutcome minimize(const SolverProblem& problem, const SolverOptions& options);

/// What an algorithm wants to know at one point.
struct SolverAnswer {
  SolverValue value;
  /// If derivatives were asked for: of the objective (n), and of the constraints (constraint_count rows of
  /// n).
  std::vector<double> gradient;
  std::vector<double> constraint_gradients;
};

/// Answers one point; returns false to end the search.
using Oracle = std::function<bool(const std::vector<double>& x, bool derivatives, SolverAnswer& answer)>;

/// The bare algorithm: one point after the other, `problem.evaluate` left alone.
SolverOutcome run_algorithm(const SolverProblem& problem, const SolverOptions& options, const Oracle& oracle);

}  // namespace armtune::internal
