#include "Testing/Cxx/FailingMemory.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>

namespace
{
using Which = galaxy::testing::FailingMemory::Which;

std::atomic<Which> failing{ Which::None };
std::atomic<bool> isCounting{ false };
std::atomic<long> first{ 0 }, asked{ 0 }, held{ 0 };

bool fails()
{
  if (!isCounting)
  {
    return false;
  }
  const long request = ++asked;
  const Which which = failing;
  return which == Which::One ? request == first : which == Which::Rest && request >= first;
}

void* counted(void* block)
{
  if (!block)
  {
    throw std::bad_alloc();
  }
  ++held;
  return block;
}

void release(void* block)
{
  held -= block != nullptr;
  std::free(block);
}
} // namespace

namespace galaxy::testing
{
FailingMemory::FailingMemory(Which which, long request)
{
  asked = 0;
  first = request;
  failing = which;
  isCounting = true;
}

void FailingMemory::end()
{
  isCounting = false;
}

long FailingMemory::requests()
{
  return asked;
}

long FailingMemory::inUse()
{
  return held;
}
} // namespace galaxy::testing

// The linker sends the project's own calls here (--wrap).
extern "C" {
void* __real_realloc(void* block, std::size_t size);
void* __real_aligned_alloc(std::size_t alignment, std::size_t size);
void* __wrap_realloc(void* block, std::size_t size);
void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size);

void* __wrap_realloc(void* block, std::size_t size)
{
  return fails() ? nullptr : __real_realloc(block, size);
}
void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size)
{
  return fails() ? nullptr : __real_aligned_alloc(alignment, size);
}
}

// The forms for arrays and without exceptions call these.
void* operator new(std::size_t size)
{
  return counted(fails() ? nullptr : std::malloc(std::max<std::size_t>(1, size)));
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  const auto unit = static_cast<std::size_t>(alignment);
  const std::size_t units = std::max<std::size_t>(1, (size + unit - 1) / unit);
  return counted(fails() ? nullptr : __real_aligned_alloc(unit, units * unit));
}
void operator delete(void* block) noexcept
{
  release(block);
}
void operator delete(void* block, std::size_t) noexcept
{
  release(block);
}
void operator delete(void* block, std::align_val_t) noexcept
{
  release(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept
{
  release(block);
}
