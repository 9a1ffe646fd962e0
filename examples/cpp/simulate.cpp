// Simulates a task with gains and prints its errors:   simulate [SCENARIO [GAINS]]
#include <armtune/error.hpp>
#include <armtune/rollout.hpp>
#include <iostream>

int main(int argc, char** argv) {
  try {
    const auto scenario = armtune::Scenario::load(argc > 1 ? argv[1] : "moving_target");
    const auto gains = armtune::Gains::load(argc > 2 ? argv[2] : "published", scenario.robot());
    for (const armtune::Rollout& rollout : armtune::simulate({scenario}, gains).rollouts) {
      std::cout << rollout.scenario() << ": " << rollout.status() << "\n"
                << "largest position error: " << rollout.metric("error/position/max") << " m\n"
                << "largest share of a velocity limit: " << rollout.metric("joint_velocity/max_ratio")
                << "\n";
      for (const std::string& limit : *rollout.broken_limits()) std::cout << limit << "\n";
    }
  } catch (const armtune::Error& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
