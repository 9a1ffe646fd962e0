#include "tuner/study/evaluation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace armtune::internal {
namespace evaluation_test {

Evaluation evaluation(bool feasible, double violation, double objective) {
  Evaluation e;
  e.feasible = feasible;
  e.violation = violation;
  e.objective = objective;
  return e;
}

TEST(Better, IsFeasibleThenLessViolatedThenSmaller) {
  // From best to worst; no two are equal.
  const std::vector<Evaluation> order = {evaluation(true, 0.0, 0.5),   evaluation(true, 0.0, 2.0),
                                         evaluation(true, 0.0, 30.0),  evaluation(false, 0.01, 0.9),
                                         evaluation(false, 0.01, 1.0), evaluation(false, 0.3, 0.1),
                                         evaluation(false, 2.0, 0.1),  evaluation(false, 2.0, 0.2)};
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = 0; j < order.size(); ++j) {
      EXPECT_EQ(better(order[i], order[j]), i < j) << i << " and " << j;
    }
  }
}

TEST(Better, IsAStrictWeakOrdering) {
  std::mt19937 generator(2);
  std::uniform_int_distribution<int> few(0, 2);  // so that equals occur
  const auto random = [&] {
    const bool feasible = few(generator) > 0;
    return evaluation(feasible, feasible ? 0.0 : 0.5 + few(generator), few(generator));
  };
  for (int i = 0; i < 20000; ++i) {
    const Evaluation a = random(), b = random(), c = random();
    ASSERT_FALSE(better(a, a));
    ASSERT_FALSE(better(a, b) && better(b, a));
    if (better(a, b) && better(b, c)) {
      ASSERT_TRUE(better(a, c));
    }
    const auto equal = [](const Evaluation& x, const Evaluation& y) {
      return !better(x, y) && !better(y, x);
    };
    if (equal(a, b) && equal(b, c)) {
      ASSERT_TRUE(equal(a, c));
    }
  }
}

}  // namespace evaluation_test
}  // namespace armtune::internal
