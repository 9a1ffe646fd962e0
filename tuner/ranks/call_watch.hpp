#pragma once
// A timer for a blocking call that has no deadline of its own. MPI_Init, for example, returns only when every
// rank has called it. If the call takes long, the timer first reports that and later gives up:
//
//   const CallWatch watch(10.0, [] { say("still waiting"); }, 120.0, [] { std::_Exit(1); });
//   MPI_Init(nullptr, nullptr);

#include <functional>
#include <thread>

namespace armtune::internal {

class CallWatch {
 public:
  using Action = std::function<void()>;
  /// Starts a thread that calls `say` after `say_after` and `give_up` after `limit` [s]. Each is called once,
  /// unless the timer has been destroyed before. Time in which the process is stopped does not count.
  CallWatch(double say_after, Action say, double limit, Action give_up);

 private:
  std::jthread thread_;
};

}  // namespace armtune::internal
