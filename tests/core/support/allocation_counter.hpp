#pragma once
// Counts heap allocations of the calling thread, for the laws that forbid them.

namespace armtune::internal::test {

/// Whether this build can count: not under a sanitizer that owns malloc, nor without glibc.
bool allocations_are_counted();

/// Allocations of this thread so far: malloc, calloc, realloc and aligned_alloc, operator new through them.
long allocations();

}  // namespace armtune::internal::test
