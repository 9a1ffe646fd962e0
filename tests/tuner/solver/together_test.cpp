#include "tuner/solver/together.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "armtune/error.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace together_test {

using Point = std::vector<double>;

SolverValue valley(const Point& x) {
  return {std::pow(x[0] - 0.7, 2) + 10.0 * std::pow(x[1] - x[0] * x[0], 2), {}};
}

std::vector<JoinedSearch> some_searches() {
  std::vector<JoinedSearch> searches(4);
  const char* algorithms[] = {"COBYLA", "ISRES", "SLSQP", "BOBYQA"};
  for (std::size_t s = 0; s < searches.size(); ++s) {
    searches[s].problem.start = {0.1 + 0.2 * static_cast<double>(s), 0.5};
    searches[s].options.algorithm = algorithms[s];
    searches[s].options.seed = s;
  }
  return searches;
}

struct Joint {
  std::vector<std::vector<Point>> of_search;  ///< what each asked for, in order
  std::vector<std::vector<std::size_t>> rounds;
};

/// Each search gets `budget` points.
Joint run(const std::vector<JoinedSearch>& searches, std::size_t budget) {
  Joint joint;
  joint.of_search.resize(searches.size());
  minimize_together(searches, [&](std::vector<Request>& requests) {
    joint.rounds.emplace_back();
    for (Request& request : requests) {
      joint.rounds.back().push_back(request.search);
      for (const SolverPoint& point : request.points) {
        if (joint.of_search[request.search].size() == budget) break;
        joint.of_search[request.search].push_back(point.x);
        request.values.push_back(valley(point.x));
      }
    }
  });
  return joint;
}

TEST(Together, EverySearchAsksForWhatItAsksForAlone) {
  const auto searches = some_searches();
  const Joint joint = run(searches, 150);
  for (std::size_t s = 0; s < searches.size(); ++s) {
    SolverProblem problem = searches[s].problem;
    std::vector<Point> alone;
    problem.evaluate = [&](const std::vector<SolverPoint>& points, std::vector<SolverValue>& values) {
      for (const SolverPoint& point : points) {
        if (alone.size() == 150) return !values.empty();
        alone.push_back(point.x);
        values.push_back(valley(point.x));
      }
      return true;
    };
    minimize(problem, searches[s].options);
    EXPECT_EQ(joint.of_search[s], alone) << searches[s].options.algorithm;
  }
}

TEST(Together, ItsRoundsHoldAllLiveSearchesInOrderHoweverThreadsAreScheduled) {
  const auto searches = some_searches();
  const Joint first = run(searches, 80);
  EXPECT_THAT(first.rounds.front(), testing::ElementsAre(0, 1, 2, 3));
  for (const auto& round : first.rounds) EXPECT_TRUE(std::is_sorted(round.begin(), round.end()));
  for (int again = 0; again < 5; ++again) EXPECT_EQ(run(searches, 80).rounds, first.rounds);
}

TEST(Together, ASearchThatIsToldToEndLeavesTheOthersGoing) {
  std::vector<std::size_t> asked(4, 0);
  const auto outcomes = minimize_together(some_searches(), [&](std::vector<Request>& requests) {
    for (Request& request : requests) {
      request.go_on = request.search != 1 && asked[request.search]++ < 20;
      for (const SolverPoint& point : request.points) request.values.push_back(valley(point.x));
    }
  });
  ASSERT_EQ(outcomes.size(), 4U);
  EXPECT_TRUE(outcomes[1].stopped);
  EXPECT_EQ(asked[1], 0U);
  EXPECT_GT(asked[0], 5U);
}

TEST(Together, AnExceptionOfTheEvaluationEndsAllAndReachesTheCaller) {
  int rounds = 0;
  const auto fail = [&](std::vector<Request>& requests) {
    if (++rounds == 3) throw InputError("the disk is full");
    for (Request& request : requests) {
      for (const SolverPoint& point : request.points) request.values.push_back(valley(point.x));
    }
  };
  EXPECT_EQ(test::refusal([&] { minimize_together(some_searches(), fail); }), "the disk is full");
  EXPECT_EQ(rounds, 3);
}

TEST(Together, AnExceptionOfASearchEndsAllAndReachesTheCaller) {
  auto searches = some_searches();
  searches[2].options.algorithm = "NONE";
  const auto answer = [](std::vector<Request>& requests) {
    for (Request& request : requests) {
      for (const SolverPoint& point : request.points) request.values.push_back(valley(point.x));
    }
  };
  EXPECT_THAT([&] { minimize_together(searches, answer); }, test::refused_at({.value = "NONE"}));
}

TEST(Together, NoSearchesAreDoneAtOnce) {
  EXPECT_TRUE(minimize_together({}, [](std::vector<Request>&) { FAIL(); }).empty());
}

}  // namespace together_test
}  // namespace armtune::internal
