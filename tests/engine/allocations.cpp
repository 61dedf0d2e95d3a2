// The counter takes the place of operator new; alone in its file, so that no caller sees into it.
#include "tests/engine/allocations.h"

#include <cstdlib>
#include <new>

std::atomic<long> vallecula::engine::testing::allocations{0};

void* operator new(std::size_t size) {
  ++vallecula::engine::testing::allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t align) {
  ++vallecula::engine::testing::allocations;
  const std::size_t a = static_cast<std::size_t>(align);
  if (void* p = std::aligned_alloc(a, (size + a - 1) / a * a)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
