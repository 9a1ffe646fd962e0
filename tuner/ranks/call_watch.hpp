#pragma once
// Watches a blocking call that has no deadline of its own. MPI_Init, for example, returns only when every
// rank has called it. If the call takes long, the watch first calls one function, for example to report the
// wait. Still later it calls a second function, for example to end the process:
//
//   const CallWatch watch(10.0, [] { say("still waiting"); }, 120.0, [] { std::_Exit(1); });
//   MPI_Init(nullptr, nullptr);

#include <functional>
#include <thread>

namespace armtune::internal {

class CallWatch {
 public:
  using Action = std::function<void()>;
  /// Starts a thread that calls `say` after the time `say_after` [s], and `give_up` after the time `limit`
  /// [s]. Each function is called once, unless the object is destroyed earlier. Time in which the process is
  /// stopped (Ctrl-Z, a suspended job) does not count.
  CallWatch(double say_after, Action say, double limit, Action give_up);

 private:
  std::jthread thread_;
};

}  // namespace armtune::internal
