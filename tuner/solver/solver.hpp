#pragma once
// Offers a small interface to the optimisation algorithms of the library NLopt, with which armtune searches
// for gains. NLopt's own types are used only in solver.cpp.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace armtune::internal {

/// The values of the objective and of the constraints at one point. All are finite.
struct SolverValue {
  double objective = 0.0;
  std::vector<double> constraints;  ///< violations relative to the limits; zero or less: satisfied
};

struct SolverPoint {
  std::vector<double> x;
  bool difference = false;  ///< true if it is only needed for a derivative, and is not a candidate
};

/// An optimisation problem. The bounds of all coordinates together are called its box.
struct SolverProblem {
  std::vector<double> start;  ///< point where the search starts; inside the box
  std::vector<double> lower;  ///< lower bounds; empty: all are 0
  std::vector<double> upper;  ///< upper bounds; empty: all are 1
  std::size_t constraint_count = 0;
  /// Called with the points that a search needs next: one point, or one point and the points for its
  /// derivatives. `values` is empty on entry, and gets one value per point, in order. If there are fewer
  /// values, the search ends as soon as it needs a missing one. Returns false to end the search at once.
  std::function<bool(const std::vector<SolverPoint>& points, std::vector<SolverValue>& values)> evaluate;

  double lower_bound(std::size_t i) const { return lower.empty() ? 0.0 : lower[i]; }
  double upper_bound(std::size_t i) const { return upper.empty() ? 1.0 : upper[i]; }
};

/// The way in which constraints are handled.
enum class ConstraintHandling {
  kAuto,        ///< the algorithm handles them itself if it can; otherwise as kLagrangian
  kLagrangian,  ///< NLopt's augmented Lagrangian around the algorithm
  kPenalty      ///< exact penalty: minimises objective + penalty * sum of the positive violations
};

/// The way in which derivatives are formed, for algorithms that use them.
enum class Differences {
  kForward,  ///< one further point per coordinate: above x, or below x near an upper bound
  kCentral   ///< two further points per coordinate, or one at a bound
};

/// Options of a search. Lengths are in coordinates for which the range of every parameter is [0, 1].
struct SolverOptions {
  std::string algorithm = "COBYLA";
  double initial_step = 0.2;         ///< length of the first step; at most 0.49 times the width of the box
  double x_tolerance = 1e-3;         ///< the search ends when all coordinates change by less than this
  double objective_tolerance = 0.0;  ///< the same for the relative change of the objective; 0: not used
  ConstraintHandling constraints = ConstraintHandling::kAuto;
  double penalty = 1.0;    ///< cost per unit of relative violation, for kPenalty and sensitivity analyses
  std::uint64_t seed = 1;  ///< for algorithms that use random numbers
  Differences differences = Differences::kForward;
  /// Step of a finite difference. It is much longer than rounding requires. An objective that is a maximum
  /// over a simulation has kinks, and the integrator adds noise. A very short step would measure kinks and
  /// noise instead of the slope.
  double difference_step = 0.01;
};

struct SolverOutcome {
  bool converged = false;  ///< true if the algorithm itself ended the search
  bool stopped = false;    ///< true if SolverProblem::evaluate ended the search
  std::string reason;
};

/// An algorithm that users can choose: its name, its properties, and a short description.
struct AlgorithmInfo {
  const char* name;
  bool local;              ///< true if it searches from its start; false if it searches the whole box
  bool takes_constraints;  ///< false if it needs an augmented Lagrangian around it to handle constraints
  bool uses_differences;   ///< true if it uses derivatives, which are formed by finite differences
  bool draws_random_numbers;
  const char* meaning;
  std::size_t most_parameters = 0;  ///< largest number of parameters; 0: no limit
};
const std::vector<AlgorithmInfo>& algorithms();

/// Returns the algorithm of this name. Throws InputError if there is none. The message lists the names. If
/// the algorithm was removed from armtune, the message names a replacement instead.
const AlgorithmInfo& algorithm_from_name(const std::string& name);

/// Returns the algorithm of this name, as algorithm_from_name() does. Also throws InputError if the algorithm
/// cannot handle so many parameters.
const AlgorithmInfo& algorithm_for(const std::string& name, std::size_t parameters);

/// Searches the box for the point with the smallest objective that satisfies the constraints. The point is
/// not returned, so the caller must record the best point itself. The points that are evaluated, and their
/// order, depend only on the problem and the options. Throws InputError as algorithm_for does, or if the
/// start is not inside the box.
SolverOutcome minimize(const SolverProblem& problem, const SolverOptions& options);

/// The values that an algorithm needs at one point.
struct SolverAnswer {
  SolverValue value;
  /// Derivatives, if they were requested. For n coordinates, `gradient` has n numbers, and
  /// `constraint_gradients` has n numbers for each constraint, constraint by constraint.
  std::vector<double> gradient;
  std::vector<double> constraint_gradients;
};

/// A function that computes the answer at point x, with derivatives if requested. It returns false to end the
/// search.
using Oracle = std::function<bool(const std::vector<double>& x, bool derivatives, SolverAnswer& answer)>;

/// Runs the algorithm itself for minimize(). The algorithm requests one point after the other from `oracle`.
/// `problem.evaluate` is not used.
SolverOutcome run_algorithm(const SolverProblem& problem, const SolverOptions& options, const Oracle& oracle);

}  // namespace armtune::internal
