// Identifies an arm from logs of its motion and prints how well the result explains them.
// Usage:   identify ROBOT LOG...
#include <armtune/error.hpp>
#include <armtune/identify.hpp>
#include <iostream>

int main(int argc, char** argv) try {
  if (argc < 3) throw armtune::InputError("usage: identify ROBOT LOG...");
  const auto robot = armtune::Robot::load(argv[1]);
  const armtune::Identified found = armtune::identify(robot, {argv + 2, argv + argc});
  for (std::size_t i = 0; i < robot.joints().size(); ++i) {
    std::cout << robot.joints()[i] << ": torque " << found.held_out.torque[i] << " RMS, unexplained "
              << found.held_out.by_theta[i] << ", with the robot as given " << found.held_out.by_file[i]
              << "\n";
  }
  for (const std::string& doubt : found.doubts) std::cout << "doubt: " << doubt << "\n";
  return found.doubts.empty() ? 0 : 3;
} catch (const armtune::Error& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
