// SPDX-License-Identifier: Apache-2.0
#include "faults/refused_heap.h"

#include <dlfcn.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

std::atomic<bool> watched{false}, allLater{false};
std::atomic<size_t> calls{0}, refused{0}, ownBytes{0}, ownLargest{0};
/// Threads of the program that are in a function of this file.
thread_local bool within = false;

enum class Caller { kProgram, kOurs, kOther };

Caller callerOf(void* address) {
  Dl_info info;
  if (dladdr(address, &info) == 0 || !info.dli_fname) return Caller::kOther;
  static const void* const kProgram = [] {
    Dl_info own;
    return dladdr(reinterpret_cast<void*>(&callerOf), &own) ? own.dli_fbase : nullptr;
  }();
  if (info.dli_fbase == kProgram) return Caller::kProgram;
  return std::strstr(info.dli_fname, "libawd.so") || std::strstr(info.dli_fname, "libstdc++")
             ? Caller::kOurs
             : Caller::kOther;
}

/// Whether a call from there may go on.
bool allowed(size_t size, void* address) {
  if (!watched.load(std::memory_order_relaxed) || within) return true;
  within = true;
  const Caller caller = callerOf(address);
  within = false;
  if (caller == Caller::kProgram) return true;
  if (caller == Caller::kOurs) {
    ownBytes += size;
    size_t largest = ownLargest;
    while (size > largest && !ownLargest.compare_exchange_weak(largest, size)) {
    }
  }
  const size_t call = ++calls, bad = refused;
  return bad == 0 || (allLater ? call < bad : call != bad);
}

void* allocate(size_t size, size_t alignment, void* address) {
  if (!allowed(size, address)) return nullptr;
  if (alignment <= alignof(std::max_align_t)) return std::malloc(size > 0 ? size : 1);
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void* allocateOrThrow(size_t size, size_t alignment, void* address) {
  void* ptr = allocate(size, alignment, address);
  if (!ptr) throw std::bad_alloc();
  return ptr;
}

}  // namespace

#define AWD_CALLER __builtin_extract_return_addr(__builtin_return_address(0))

void* operator new(size_t size) { return allocateOrThrow(size, 1, AWD_CALLER); }
void* operator new[](size_t size) { return allocateOrThrow(size, 1, AWD_CALLER); }
void* operator new(size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, 1, AWD_CALLER);
}
void* operator new[](size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, 1, AWD_CALLER);
}
void* operator new(size_t size, std::align_val_t alignment) {
  return allocateOrThrow(size, static_cast<size_t>(alignment), AWD_CALLER);
}
void* operator new[](size_t size, std::align_val_t alignment) {
  return allocateOrThrow(size, static_cast<size_t>(alignment), AWD_CALLER);
}
// Were one of these inlined, gcc would take what it frees for memory of another operator new.
[[gnu::noinline]] void operator delete(void* ptr) noexcept { std::free(ptr); }
[[gnu::noinline]] void operator delete[](void* ptr) noexcept { std::free(ptr); }
[[gnu::noinline]] void operator delete(void* ptr, size_t) noexcept { std::free(ptr); }
[[gnu::noinline]] void operator delete[](void* ptr, size_t) noexcept { std::free(ptr); }
[[gnu::noinline]] void operator delete(void* ptr, std::align_val_t) noexcept { std::free(ptr); }
[[gnu::noinline]] void operator delete[](void* ptr, std::align_val_t) noexcept { std::free(ptr); }
[[gnu::noinline]] void operator delete(void* ptr, size_t, std::align_val_t) noexcept {
  std::free(ptr);
}
[[gnu::noinline]] void operator delete[](void* ptr, size_t, std::align_val_t) noexcept {
  std::free(ptr);
}

/// Not ours: the Embree and OpenEXR of Debian 12 leak what they have begun to make when operator
/// new throws (a device; the attributes of a header). Embree's lies without frames in its library.
extern "C" const char* __lsan_default_suppressions() { return "leak:libembree\nleak:libOpenEXR\n"; }

namespace awdtest {

WatchedHeap::WatchedHeap() {
  refuse(0, false);
  ::ownBytes = ::ownLargest = 0;
  watched = true;
}
WatchedHeap::~WatchedHeap() {
  watched = false;
  ::refused = 0;
}
void WatchedHeap::refuse(size_t call, bool later) {
  ::calls = 0;
  ::refused = call;
  allLater = later;
}
size_t WatchedHeap::calls() { return ::calls; }
size_t WatchedHeap::ownBytes() { return ::ownBytes; }
size_t WatchedHeap::ownLargest() { return ::ownLargest; }

}  // namespace awdtest
