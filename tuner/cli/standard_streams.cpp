#include "tuner/cli/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include "core/common/write_all.hpp"

namespace armtune::internal::cli {
namespace {

/// A descriptor, and why the first text was lost that it did not take.
struct Sink {
  int descriptor;
  std::atomic<int> reason{0};
};

// The C library flushes its streams after all destructors, so these have none.
Sink output{STDOUT_FILENO};  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
Sink errors{STDERR_FILENO};  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// Writes all of a text, or drops the rest of it. It always reports success, because a stream that has failed
/// makes fmt::print throw.
ssize_t write_or_drop(void* cookie, const char* text, std::size_t size) {
  Sink& sink = *static_cast<Sink*>(cookie);
  if (!write_all(sink.descriptor, {text, size})) {
    int none = 0;
    sink.reason.compare_exchange_strong(none, errno);
  }
  return static_cast<ssize_t>(size);
}

/// A stream into the sink; the one given where memory is short.
std::FILE* stream_into(Sink& sink, std::FILE* instead, int buffering) {
  cookie_io_functions_t functions{};
  functions.write = write_or_drop;
  std::FILE* stream = ::fopencookie(&sink, "w", functions);
  if (stream == nullptr) return instead;
  std::setvbuf(stream, nullptr, buffering, BUFSIZ);
  return stream;
}

}  // namespace

void open_standard_streams() {
  // The lowest number that is free is given out first.
  int file = open("/dev/null", O_RDWR);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  while (file >= 0 && file <= STDERR_FILENO) file = dup(file);
  if (file > STDERR_FILENO) close(file);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows beyond its limit is an error of writing, which is told
  // The GNU C library's names of the streams are variables.
  stdout = stream_into(output, stdout, _IOLBF);  // a log file shows at once what is done
  stderr = stream_into(errors, stderr, _IONBF);
}

int flush_standard_output() {
  if (std::fflush(stdout) != 0 && output.reason == 0) return errno;
  return output.reason == EPIPE ? 0 : output.reason.load();
}

}  // namespace armtune::internal::cli
