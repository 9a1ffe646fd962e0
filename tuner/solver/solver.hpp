#pragma once
// A small interface to the optimisation algorithms of NLopt, with which armtune searches for gains. NLopt's
// own types stay in solver.cpp.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace armtune::internal {

/// The objective and the constraints at one point; all finite. A constraint is satisfied if g <= 0, and g is
/// relative to its limit.
struct SolverValue {
  double objective = 0.0;
  std::vector<double> constraints;
};

struct SolverPoint {
  std::vector<double> x;
  bool difference = false;  ///< true if it serves to form a derivative and is no candidate
};

struct SolverProblem {
  std::vector<double> start;  ///< inside the box
  std::vector<double> lower;  ///< lower bounds of the box; empty: 0
  std::vector<double> upper;  ///< upper bounds; empty: 1
  std::size_t constraint_count = 0;
  /// Called with the points that a search needs next: one point, or one point and all differences around it.
  /// `values` is empty on entry and takes one value per point, in order. With fewer values, the search ends
  /// as soon as it needs a missing one. Returns false to end the search at once.
  std::function<bool(const std::vector<SolverPoint>& points, std::vector<SolverValue>& values)> evaluate;

  double lower_bound(std::size_t i) const { return lower.empty() ? 0.0 : lower[i]; }
  double upper_bound(std::size_t i) const { return upper.empty() ? 1.0 : upper[i]; }
};

/// The way in which an algorithm is made to respect constraints.
enum class ConstraintHandling {
  kAuto,        ///< by the algorithm itself if it takes constraints, else kLagrangian
  kLagrangian,  ///< NLopt's augmented Lagrangian around it
  kPenalty      ///< exact penalty: objective + penalty * sum of max(0, g)
};

/// The way in which derivatives are formed, for algorithms that use them.
enum class Differences {
  kForward,  ///< one point per coordinate, towards the inside at a bound
  kCentral   ///< two points, one at a bound
};

struct SolverOptions {
  std::string algorithm = "COBYLA";
  double initial_step = 0.2;         ///< share of the unit box; at most 0.49 of the problem's box
  double x_tolerance = 1e-3;         ///< share of the unit box
  double objective_tolerance = 0.0;  ///< relative; 0: not used, x_tolerance decides
  ConstraintHandling constraints = ConstraintHandling::kAuto;
  double penalty = 1.0;    ///< for kPenalty: cost per unit of relative violation
  std::uint64_t seed = 1;  ///< for algorithms that draw random numbers
  Differences differences = Differences::kForward;
  /// Share of the unit box. A maximum over a simulation has kinks, and noise from the integrator. A step as
  /// short as rounding would allow sees those instead of the slope.
  double difference_step = 0.01;
};

struct SolverOutcome {
  bool converged = false;  ///< true if the algorithm itself ended the search
  bool stopped = false;    ///< true if `evaluate` ended it
  std::string reason;
};

/// An algorithm that is offered: its name, its properties, and a short description.
struct AlgorithmInfo {
  const char* name;
  bool local;              ///< true if it searches from its start; otherwise it searches the whole box
  bool takes_constraints;  ///< otherwise an augmented Lagrangian is put around it
  bool uses_differences;
  bool draws_random_numbers;
  const char* meaning;
  std::size_t most_parameters = 0;  ///< 0: any number
};
const std::vector<AlgorithmInfo>& algorithms();

/// Returns the algorithm of this name. Throws InputError if it is not offered. The message lists the names,
/// or says what to use in place of an algorithm that was removed.
const AlgorithmInfo& algorithm_from_name(const std::string& name);

/// Returns the same. Throws InputError also if the algorithm does not take so many parameters.
const AlgorithmInfo& algorithm_for(const std::string& name, std::size_t parameters);

/// Searches the box. The caller must record the best point itself. The points that are evaluated, and their
/// order, depend on problem and options alone. Throws InputError as algorithm_for does, or if the start is
/// not inside the box.
SolverOutcome minimize(const SolverProblem& problem, const SolverOptions& options);

/// The values that an algorithm needs at one point.
struct SolverAnswer {
  SolverValue value;
  /// If derivatives were requested: those of the objective (n), and of the constraints (constraint_count
  /// rows of n).
  std::vector<double> gradient;
  std::vector<double> constraint_gradients;
};

/// A function that computes the answer at one point; it returns false to end the search.
using Oracle = std::function<bool(const std::vector<double>& x, bool derivatives, SolverAnswer& answer)>;

/// Runs the algorithm itself, which requests one point after the other from `oracle`. `problem.evaluate` is
/// not used.
SolverOutcome run_algorithm(const SolverProblem& problem, const SolverOptions& options, const Oracle& oracle);

}  // namespace armtune::internal
