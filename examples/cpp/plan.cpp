// Plans the fastest motion of a task and prints the limits that restrict it:   plan [TASK]
#include <armtune/error.hpp>
#include <armtune/plan.hpp>
#include <iostream>

int main(int argc, char** argv) try {
  const armtune::Plan plan = armtune::plan(argc > 1 ? argv[1] : "ur10_switch");
  std::cout << plan.status << ": " << plan.headline << "\n";
  if (!plan.solved) return 3;
  std::cout << plan.time.size() << " knots over " << plan.duration << " s\n";
  for (const armtune::PlanLimit& limit : plan.limits) {
    if (limit.binds)
      std::cout << limit.limit << ", " << limit.part << ": " << limit.used << " of it is used\n";
  }
} catch (const armtune::Error& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
