#include "peer.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <random>

namespace peers {
namespace {

constexpr int kBatches = 15;

/// Returns uniformly distributed states, which are the same with every standard library.
std::vector<State> random_states(std::size_t count) {
  std::mt19937_64 bits(20240229);  // NOLINT: the same states every time are wanted
  const auto uniform = [&bits](double most) {
    return most * (2.0 * static_cast<double>(bits() >> 11) / 9007199254740992.0 - 1.0);
  };
  std::vector<State> states(count);
  for (State& state : states) {
    for (double& x : state.q) x = uniform(3.0);
    for (double& x : state.qd) x = uniform(2.0);
    for (double& x : state.qdd) x = uniform(5.0);
    for (double& x : state.tau) x = uniform(30.0);
  }
  return states;
}

void print_results(const Peer& peer) {
  for (const State& state : random_states(50)) {
    for (const Kernel& kernel : peer.kernels) {
      std::vector<double> numbers;
      kernel.run(state);
      kernel.results(numbers);
      std::printf("%s", kernel.name);
      for (const double number : numbers) std::printf(" %.17g", number);
      std::printf("\n");
    }
  }
}

/// Returns the shortest time per call of several batches, which is that of the least disturbed batch.
double nanoseconds(const Kernel& kernel, const std::vector<State>& states) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kBatch(20);
  for (const State& state : states) kernel.run(state);
  double least = 1e300;
  for (int batch = 0; batch < kBatches; ++batch) {
    std::int64_t calls = 0;
    const auto began = Clock::now();
    auto now = began;
    for (; now - began < kBatch; now = Clock::now()) {
      for (const State& state : states) kernel.run(state);
      calls += static_cast<std::int64_t>(states.size());
    }
    least = std::min(
        least, std::chrono::duration<double, std::nano>(now - began).count() / static_cast<double>(calls));
  }
  return least;
}

}  // namespace

int peer_main(int argc, char** argv, const std::function<Peer(const std::string& urdf)>& load) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s results|time|version URDF\n", argv[0]);
    return 2;
  }
  try {
    const std::string mode = argv[1];
    const Peer peer = load(argv[2]);
    if (mode == "version") {
      std::printf("%s %s\n", peer.name.c_str(), peer.version.c_str());
    } else if (mode == "results") {
      print_results(peer);
    } else if (mode == "time") {
      const auto states = random_states(256);
      for (const Kernel& kernel : peer.kernels)
        std::printf("%s %.1f\n", kernel.name, nanoseconds(kernel, states));
      for (const Period& period : peer.periods) {
        double least = 1e300;
        for (int batch = 0; batch < kBatches; ++batch) least = std::min(least, period.nanoseconds());
        std::printf("%s %.1f\n", period.name, least);
      }
    } else {
      std::fprintf(stderr, "%s: no mode '%s'\n", argv[0], mode.c_str());
      return 2;
    }
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
    return 1;
  }
  return 0;
}

}  // namespace peers
