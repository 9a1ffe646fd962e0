#include "tuner/cli/interrupt.hpp"

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <thread>

#include "tuner/ranks/transport.hpp"

namespace armtune::internal::cli {
namespace {

// A signal handler can only reach globals.
std::atomic<bool> stop{false};              // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<std::int64_t> first_signal{0};  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
static_assert(std::atomic<std::int64_t>::is_always_lock_free);
static_assert(std::atomic<bool>::is_always_lock_free);

/// A launcher may pass one interrupt on twice, to its child and to the process group. Within this time a
/// second signal therefore counts as the same interrupt.
constexpr std::int64_t kOneInterrupt = 500'000'000;  // ns

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);  // safe in a handler
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

void on_signal(int signal) {
  if (!stop.exchange(true)) {
    first_signal = now();
  } else if (now() - first_signal > kOneInterrupt) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

std::atomic<bool>& stop_requested() {
  return stop;
}

void catch_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  // SIGHUP comes when the terminal closes. If it is ignored at the start (nohup), it stays ignored.
  if (std::signal(SIGHUP, on_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

void ignore_interrupts() {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  std::signal(SIGHUP, SIG_IGN);
}

std::vector<std::string>& command_words() {
  static std::vector<std::string> words;
  return words;
}

std::string& command_line() {
  static std::string text;
  return text;
}

std::string& program_name() {
  static std::string name;
  return name;
}

int default_workers() {
  if (rank_place().size > 1) return 1;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace armtune::internal::cli
