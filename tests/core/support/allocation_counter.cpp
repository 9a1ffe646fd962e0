// malloc itself is replaced, not operator new: Eigen's dynamic matrices call malloc directly. glibc keeps its
// own functions under __libc_ names; memory from them is freed by glibc's free as ever.
#include "tests/core/support/allocation_counter.hpp"

#include <cerrno>
#include <cstddef>

#if defined(__has_feature)  // Clang's way to tell
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ARMTUNE_MALLOC_IS_TAKEN 1
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ARMTUNE_MALLOC_IS_TAKEN 1
#endif
#if defined(__GLIBC__) && !defined(ARMTUNE_MALLOC_IS_TAKEN)
#define ARMTUNE_COUNT_ALLOCATIONS 1
#endif

namespace armtune::internal::test {
namespace {

thread_local long count =
    0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): malloc has no caller

}  // namespace

long allocations() {
  return count;
}

#ifdef ARMTUNE_COUNT_ALLOCATIONS
bool allocations_are_counted() {
  return true;
}

extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp): glibc's names
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
// NOLINTEND(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)

void* malloc(std::size_t size) {
  ++count;
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  ++count;
  return __libc_calloc(number, size);
}
void* realloc(void* memory, std::size_t size) {
  ++count;
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++count;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  ++count;
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
}
#else
bool allocations_are_counted() {
  return false;
}
#endif

}  // namespace armtune::internal::test
