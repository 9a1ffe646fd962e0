#include "tuner/run/arithmetic.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "tuner/run/file_hash.hpp"

#if __has_include(<sys/platform/x86.h>)
#ifdef __clang__
#define _Bool bool  // the header is C's
#endif
#include <sys/platform/x86.h>
#undef _Bool
#define ARMTUNE_GLIBC_X86
#endif

namespace armtune::internal {
namespace {

/// True if libm uses only instructions that every x86-64 processor has.
bool at_baseline() {
#ifdef ARMTUNE_GLIBC_X86
  return !CPU_FEATURE_ACTIVE(AVX) && !CPU_FEATURE_ACTIVE(AVX2) && !CPU_FEATURE_ACTIVE(FMA) &&
         !CPU_FEATURE_ACTIVE(FMA4);
#else
  return false;
#endif
}

/// Returns a hash of results of elementary functions. The variants differ in about one result in two
/// thousand, so many arguments are needed to tell them apart.
std::string fingerprint() {
  constexpr int kArguments = 2000;
  Fnv1a hash;
  const auto add = [&hash](double value) { hash.add(std::bit_cast<std::uint64_t>(value)); };
  for (int i = 0; i < kArguments; ++i) {
    const double u = (i + 0.37) / kArguments;  // in (0, 1)
    const double x = 20.0 * u - 10.0;
    add(std::sin(x));
    add(std::cos(x));
    add(std::tan(x));
    add(std::atan2(x, 1.3));
    add(std::acos(2.0 * u - 1.0));
    add(std::asin(2.0 * u - 1.0));
    add(std::exp(x));
    add(std::log(u));
    add(std::pow(20.0 * u, 1.7));
    add(std::sqrt(u));
    add(std::hypot(x, 0.7));
  }
  return hash.text();
}

}  // namespace

const Arithmetic& arithmetic() {
  static const Arithmetic found{at_baseline() ? "baseline x86-64" : "of this processor", fingerprint()};
  return found;
}

std::string baseline_tunables(const std::string& set) {
  const std::string name = "glibc.cpu.hwcaps=";
  const std::string wanted = "-AVX,-AVX2,-FMA,-FMA4";
  if (set.empty()) return name + wanted;
  for (std::size_t at = set.find(name); at != std::string::npos; at = set.find(name, at + 1)) {
    if (at > 0 && set[at - 1] != ':') continue;
    const std::size_t end = std::min(set.find(':', at), set.size());
    return set.substr(0, end) + "," + wanted + set.substr(end);
  }
  return set + ":" + name + wanted;
}

void fix_arithmetic(char** argv) {
#ifdef ARMTUNE_GLIBC_X86
  if (at_baseline()) return;
  // A process keeps its id over an exec. If its own id is found here, an earlier restart had no effect.
  constexpr const char* kTried = "ARMTUNE_ARITHMETIC_TRIED";
  const std::string self = fmt::format("{}", ::getpid());
  const char* tried = std::getenv(kTried);
  if (tried && self == tried) return;
  const char* set = std::getenv("GLIBC_TUNABLES");
  const std::string tunables = baseline_tunables(set ? set : "");
  if (::setenv(kTried, self.c_str(), 1) != 0 || ::setenv("GLIBC_TUNABLES", tunables.c_str(), 1) != 0) return;
  // The program is restarted by its own path, so that the process keeps its name too.
  std::error_code error;
  const std::string program = std::filesystem::read_symlink("/proc/self/exe", error).string();
  if (!error) ::execv(program.c_str(), argv);
  ::execv("/proc/self/exe", argv);
#else
  static_cast<void>(argv);
#endif
}

}  // namespace armtune::internal
