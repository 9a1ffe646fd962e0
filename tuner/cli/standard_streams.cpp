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

/// A file descriptor, and the errno of the first failed write to it (0: none has failed).
struct Sink {
  int descriptor;
  std::atomic<int> reason{0};
};

// The C library flushes its streams after all destructors have run, so these objects have no destructors.
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

/// Returns a stream that writes into the sink, or `instead` if there is not enough memory.
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
  // open and dup return the lowest free descriptor, so this fills those of closed standard streams.
  int file = open("/dev/null", O_RDWR);  // NOLINT(cppcoreguidelines-pro-type-vararg)
  while (file >= 0 && file <= STDERR_FILENO) file = dup(file);
  if (file > STDERR_FILENO) close(file);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // writing beyond the file size limit then fails with an error
  // In the GNU C library stdout and stderr are variables, so they can be replaced.
  stdout = stream_into(output, stdout, _IOLBF);  // a log file shows each line at once
  stderr = stream_into(errors, stderr, _IONBF);
}

int flush_standard_output() {
  if (std::fflush(stdout) != 0 && output.reason == 0) return errno;
  return output.reason == EPIPE ? 0 : output.reason.load();
}

}  // namespace armtune::internal::cli
