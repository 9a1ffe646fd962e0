#pragma once
// The bytes of one fuzzed input as a file without a place on any disk, since that is what readers are given.

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "armtune/error.hpp"

namespace armtune::internal::fuzz {

class InputFile {
 public:
  explicit InputFile(std::string_view bytes) : file_(::memfd_create("input", MFD_CLOEXEC)) {
    if (file_ < 0 || ::write(file_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
      std::perror("the machine has no file for the input, which is no finding");
      std::_Exit(2);
    }
  }
  ~InputFile() { ::close(file_); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

inline std::string_view text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};  // bytes as libFuzzer has them
}

/// Aborts if `holds` is false, so that the fuzzer keeps the input, and says where.
inline void require(bool holds, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  if (holds) return;
  std::fprintf(stderr, "%s:%d: a promise does not hold\n", file, line);
  std::abort();
}

/// Reads; what is refused is refused in one line that is no longer than a screen, anything else is a finding.
template <typename Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    require(!message.empty() && message.size() < 20'000 && message.find('\n') == std::string_view::npos);
  }
}

}  // namespace armtune::internal::fuzz
