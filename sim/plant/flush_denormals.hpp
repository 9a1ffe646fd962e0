#pragma once
// Makes the processor flush denormal floating-point numbers to zero during a simulation. Denormal numbers
// carry no information here, and they would slow the simulation down by up to a factor of two.

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace armtune::internal {

/// Flushes denormals to zero on this thread as long as this object lives. A simulated scenario then gives the
/// same bits on every thread.
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
