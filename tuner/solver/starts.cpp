#include "tuner/solver/starts.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace armtune::internal {
namespace {

std::vector<double> first_primes(std::size_t count) {
  std::vector<double> primes;
  primes.reserve(count);
  for (int candidate = 2; primes.size() < count; ++candidate) {
    const bool prime = std::none_of(primes.begin(), primes.end(),
                                    [candidate](double p) { return candidate % static_cast<int>(p) == 0; });
    if (prime) primes.push_back(candidate);
  }
  return primes;
}

}  // namespace

std::vector<std::vector<double>> spread_starts(const SolverProblem& problem, std::size_t count,
                                               std::uint64_t seed) {
  const std::size_t n = problem.start.size();
  const std::vector<double> primes = first_primes(n);
  std::mt19937_64 generator(seed);
  std::vector<double> shift(n);
  for (double& s : shift) s = std::ldexp(static_cast<double>(generator() >> 11U), -53);
  std::vector<std::vector<double>> points(count, std::vector<double>(n));
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      const double u = static_cast<double>(k) * std::sqrt(primes[i]) + shift[i];
      points[k][i] = std::lerp(problem.lower_bound(i), problem.upper_bound(i), u - std::floor(u));
    }
  }
  return points;
}

}  // namespace armtune::internal
