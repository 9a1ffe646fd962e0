#pragma once
// Makes the processor flush denormal floating-point numbers to zero during a simulation. They would slow it
// down by up to a factor of two and carry no information here.

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace armtune::internal {

/// A guard that flushes denormals to zero on this thread while it lives. A rollout then gives the same bits
/// on every thread.
class FlushDenormals {
 public:
#if defined(__x86_64__)
  FlushDenormals() : saved_(_mm_getcsr()) {
    _mm_setcsr(saved_ | kFlushToZero | kDenormalsAreZero);
  }
  ~FlushDenormals() {
    _mm_setcsr(saved_);
  }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  static constexpr unsigned kFlushToZero = 0x8000;
  static constexpr unsigned kDenormalsAreZero = 0x0040;
  unsigned saved_;
#endif
};

}  // namespace armtune::internal
