// Ranks as threads of one process: everything but MPI itself.

#include "tuner/workers/rank_group.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <mutex>
#include <thread>

#include "armtune/error.hpp"
#include "sim/lanes/arm_lanes.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tuner/workers/candidate_runner.hpp"
#include "tuner/workers/messages.hpp"

namespace armtune::internal {
namespace rank_group_test {

using test::refused_at;
using testing::AllOf;
using testing::HasSubstr;

constexpr int kRanks = 3;

/// Letter boxes, one per pair of ranks.
struct Post {
  std::mutex mutex;
  std::array<std::array<std::deque<std::string>, kRanks>, kRanks> boxes;  ///< [to][from]
  std::array<int, kRanks> under_way{};  ///< jobs that a rank has not answered
  int most_under_way = 0;
};

class PostTransport final : public Transport {
 public:
  PostTransport(std::shared_ptr<Post> post, int rank) : post_(std::move(post)), rank_(rank) {}
  int rank() const override { return rank_; }
  int size() const override { return kRanks; }
  void send(int to, std::string message) override {
    const std::lock_guard lock(post_->mutex);
    if (kind_of(message) == MessageKind::kJob) {
      post_->most_under_way =
          std::max(post_->most_under_way, ++post_->under_way.at(static_cast<std::size_t>(to)));
    }
    if (kind_of(message) == MessageKind::kResult) --post_->under_way.at(static_cast<std::size_t>(rank_));
    box(to, rank_).push_back(std::move(message));
  }
  std::optional<std::string> receive(int from) override {
    const std::lock_guard lock(post_->mutex);
    auto& letters = box(rank_, from);
    if (letters.empty()) return std::nullopt;
    std::string first = std::move(letters.front());
    letters.pop_front();
    return first;
  }
  void end() override {}
  void abort(int) override { ADD_FAILURE() << "rank " << rank_ << " gave up"; }

 private:
  std::deque<std::string>& box(int to, int from) {
    return post_->boxes[static_cast<std::size_t>(to)][static_cast<std::size_t>(from)];
  }
  std::shared_ptr<Post> post_;
  int rank_;
};

RolloutPlan short_plan() {
  RolloutPlan plan;
  plan.scenarios = {test::scenario_of("moving_target", 3.0),
                    test::scenario_of("realistic_moving_target", 4.0)};
  plan.draw = Draw{};
  return plan;
}

/// plan_of: what a rank begins with, or it throws. Returns the most jobs that a rank had at once.
int among_ranks(const std::function<RolloutPlan(int)>& plan_of, const std::function<void(RankGroup&)>& lead) {
  const auto post = std::make_shared<Post>();
  std::vector<std::jthread> others;
  for (int rank = 1; rank < kRanks; ++rank) {
    others.emplace_back([&plan_of, post, rank] {
      RankGroup team(std::make_unique<PostTransport>(post, rank));
      std::optional<RolloutPlan> plan;
      try {
        plan = plan_of(rank);
      } catch (const InputError& e) {
        team.fail(e.what());
        return;
      }
      EXPECT_FALSE(team.begin(*plan, 1));
    });
  }
  RankGroup team(std::make_unique<PostTransport>(post, 0));
  lead(team);
  EXPECT_TRUE(team.end(0));
  return post->most_under_way;
}

/// Ranks and threads, engine by engine.
class RankGroupOf : public ::testing::TestWithParam<Engine> {};

TEST_P(RankGroupOf, RanksGiveWhatThreadsGive) {
  RolloutPlan plan = short_plan();
  const Gains gains = test::quick_gains(plan.scenarios[0]);
  const std::atomic<bool> never{false};
  SampleSet set;
  set.samples = 3;
  set.seed = plan.draw->seed;
  plan.draw->own = set.samples;
  std::vector<Gains> candidates(2, gains);
  candidates[1].task_space_gains_p *= 1.2;
  candidates[1].gaze_feedforward = true;  // switches travel too
  CandidateRunner threads(plan.scenarios, plan.stepper, 1, set);
  const Conditions conditions{GetParam()};
  const auto expected = threads.run(candidates, never, {}, conditions);
  ASSERT_TRUE(expected.has_value());
  const int at_once = among_ranks([&plan](int) { return RolloutPlan(plan); },
                                  [&](RankGroup& team) {
                                    ASSERT_TRUE(team.begin(plan, 1));
                                    for (int again = 0; again < 2; ++again) {
                                      CandidateRunner ranks(team.pool(), set);
                                      EXPECT_EQ(ranks.count(), kRanks);
                                      const auto found = ranks.run(candidates, never, {}, conditions);
                                      ASSERT_TRUE(found.has_value());
                                      EXPECT_EQ(ranks.rollouts_done(), 16);
                                      for (std::size_t c = 0; c < candidates.size(); ++c) {
                                        for (std::size_t s = 0; s < plan.scenarios.size(); ++s) {
                                          EXPECT_EQ(test::bits((*found)[c][s].metrics),
                                                    test::bits((*expected)[c][s].metrics));
                                          EXPECT_EQ((*found)[c][s].reason, (*expected)[c][s].reason);
                                        }
                                      }
                                    }
                                  });
  // 16 jobs are 5 for each of three, and one more; in Simbody one at a time.
  EXPECT_EQ(at_once, GetParam() == Engine::kNative ? std::min(6, most_lanes(best_processor())) : 1);
}

TEST_P(RankGroupOf, AStopInterruptsTheRollouts) {
  RolloutPlan plan = short_plan();
  for (Scenario& scenario : plan.scenarios) scenario.duration = 10000.0;  // never done within a test
  std::atomic<bool> stop{false};
  among_ranks([&plan](int) { return RolloutPlan(plan); },
              [&](RankGroup& team) {
                ASSERT_TRUE(team.begin(plan, 1));
                const Gains gains = test::quick_gains(plan.scenarios[0]);
                const std::jthread later([&stop] {
                  std::this_thread::sleep_for(std::chrono::milliseconds(100));
                  stop = true;
                });
                team.pool()->run(
                    10,
                    [&gains](std::size_t k) {
                      return RolloutJob{0, k, gains, {}, GetParam()};
                    },
                    stop, [](std::size_t, RolloutResult&&) { ADD_FAILURE() << "a rollout was done"; });
              });
}

TEST_P(RankGroupOf, ARolloutPastItsDeadlineEndsTheRunAndSaysWhere) {
  RolloutPlan plan = short_plan();
  plan.scenarios[1].duration = 10000.0;
  plan.deadline = 0.5;
  const std::atomic<bool> never{false};
  among_ranks([&plan](int) { return RolloutPlan(plan); },
              [&](RankGroup& team) {
                ASSERT_TRUE(team.begin(plan, 1));
                const Gains gains = test::quick_gains(plan.scenarios[0]);
                try {
                  team.pool()->run(
                      3,
                      [&gains](std::size_t k) {
                        return RolloutJob{1, k, gains, {}, GetParam()};
                      },
                      never, [](std::size_t, RolloutResult&&) {});
                  FAIL() << "nothing was thrown";
                } catch (const std::runtime_error& e) {
                  EXPECT_THAT(e.what(),
                              AllOf(HasSubstr("realistic_moving_target, sample"), HasSubstr("of 10000 s"),
                                    HasSubstr("deadline of 0.5 s"), HasSubstr("--rollout-deadline")));
                }
              });
}

INSTANTIATE_TEST_SUITE_P(Every, RankGroupOf, ::testing::Values(Engine::kSimbody, Engine::kNative));

/// What rank 0 says when rank 2 begins with something else.
InputError refused(const std::function<RolloutPlan()>& of_rank_2) {
  InputError error("nothing was refused");
  among_ranks(
      [&](int rank) { return rank == 2 ? of_rank_2() : short_plan(); },
      [&error](RankGroup& team) { error = test::input_error([&team] { team.begin(short_plan(), 1); }); });
  EXPECT_THAT(error, refused_at({.file = "", .key = testing::StartsWith("rank 2 on ")}));
  return error;
}

TEST(RankGroup, ARankWithAnotherPlanIsRefused) {
  EXPECT_THAT(refused([] {
                RolloutPlan other = short_plan();
                other.scenarios[1].duration = 5.0;
                return other;
              }),
              refused_at({.value = testing::StartsWith("5 s, "), .limit = testing::StartsWith("4 s, ")}));
  EXPECT_THAT(refused([] {
                RolloutPlan other = short_plan();
                other.draw->seed = 2;
                return other;
              }),
              refused_at({.value = "2", .limit = "1"}));
  EXPECT_THAT(refused([] {
                RolloutPlan other = short_plan();
                other.draw->perturbation.mass = 0.25;
                return other;
              }),
              refused_at({.value = "0.25", .limit = "0.2"}));
  EXPECT_THAT(refused([]() -> RolloutPlan { throw InputError("study.yaml: cannot be read"); }).what(),
              HasSubstr("study.yaml: cannot be read"));
}

TEST(RankGroup, ARankWithAnotherCommandLineIsRefusedAndAllGetTheExitCode) {
  const auto post = std::make_shared<Post>();
  std::vector<std::jthread> others;
  for (int rank = 1; rank < kRanks; ++rank) {
    others.emplace_back([post, rank] {
      RankGroup team(std::make_unique<PostTransport>(post, rank));
      EXPECT_FALSE(team.call_roll(rank == 2 ? "armtune robustness a" : "armtune tune a"));
      EXPECT_TRUE(team.left());
      EXPECT_EQ(team.exit_code(), 2);
    });
  }
  RankGroup team(std::make_unique<PostTransport>(post, 0));
  EXPECT_THAT([&team] { team.call_roll("armtune tune a"); },
              refused_at({.key = testing::StartsWith("rank 2 on "),
                          .value = "armtune robustness a",
                          .limit = "armtune tune a"}));
  EXPECT_TRUE(team.end(2));
}

TEST(RankGroup, RanksOfOneCommandLineBegin) {
  const auto post = std::make_shared<Post>();
  std::vector<std::jthread> others;
  for (int rank = 1; rank < kRanks; ++rank) {
    others.emplace_back([post, rank] {
      RankGroup team(std::make_unique<PostTransport>(post, rank));
      ASSERT_TRUE(team.call_roll("armtune tune a"));
      EXPECT_FALSE(team.begin(short_plan(), 1));
      EXPECT_EQ(team.exit_code(), 3);
    });
  }
  RankGroup team(std::make_unique<PostTransport>(post, 0));
  EXPECT_TRUE(team.call_roll("armtune tune a"));
  EXPECT_TRUE(team.begin(short_plan(), 1));
  EXPECT_TRUE(team.end(3));
}

TEST(RankGroup, AWaitIsSaidOnceForEachRank) {
  std::vector<std::string> said;
  const Notice notice = [&said](const std::string& what) { said.push_back(what); };
  Peer peer{3, "somewhere", 0, false, false};
  say_waiting(peer, kSayAfter / 2.0, "short", 25.0, notice);
  EXPECT_TRUE(said.empty());
  for (const double seconds : {kSayAfter + 1.0, kSayAfter + 2.0}) {
    say_waiting(peer, seconds, "short", 25.0, notice);
  }
  ASSERT_EQ(said.size(), 1U);
  EXPECT_THAT(said.front(), AllOf(HasSubstr("rank 3 on somewhere"), HasSubstr("11 s"), HasSubstr("short"),
                                  HasSubstr("25 s")));
}

TEST(RankGroup, ThreadsBesideRanksAreRefused) {
  among_ranks([](int) { return short_plan(); },
              [](RankGroup& team) {
                const InputError error = test::input_error([&team] { team.begin(short_plan(), 4); });
                EXPECT_THAT(error, refused_at({.key = "--workers", .value = "4", .limit = "1"}));
                EXPECT_THAT(error.what(), HasSubstr("3 ranks"));
              });
}

}  // namespace rank_group_test
}  // namespace armtune::internal
