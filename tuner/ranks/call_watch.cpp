#include "tuner/ranks/call_watch.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "tuner/ranks/patience.hpp"

namespace armtune::internal {

CallWatch::CallWatch(double say_after, Action say, double limit, Action give_up)
    : thread_([=, say = std::move(say), give_up = std::move(give_up)](const std::stop_token& stop) {
        constexpr std::chrono::milliseconds kBetween(20);
        std::mutex mutex;
        std::unique_lock lock(mutex);
        std::condition_variable_any ended;
        RunningTime time;
        for (bool said = false; !stop.stop_requested();) {
          const double seconds = time.look();
          if (!said && seconds > say_after) {
            say();
            said = true;
          }
          if (seconds > limit) {
            give_up();
            return;
          }
          ended.wait_for(lock, stop, kBetween, [] { return false; });
        }
      }) {}

}  // namespace armtune::internal
