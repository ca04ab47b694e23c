// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <atomic>
#include <cerrno>
#include <cstddef>

/** Every allocation of the program, operator new and Eigen's aligned memory included,
 * comes from these functions of the C library: they count, and glibc does the work. To be
 * included once in a program. */
namespace {

std::atomic<std::size_t> allocations{0};
/** The value of \a allocations with which one fails. */
std::atomic<std::size_t> failing_allocation{0};

[[maybe_unused]] bool
allocationFails ()
{
  return ++allocations == failing_allocation;
}

} // namespace

// Sanitizers have such functions of their own.
#ifdef __has_feature
#define HAS_SANITIZER                                                                  \
  (__has_feature (address_sanitizer) || __has_feature (thread_sanitizer))
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAS_SANITIZER 1
#endif
#if !HAS_SANITIZER
extern "C" {
void*
__libc_malloc (std::size_t size);
void*
__libc_calloc (std::size_t number, std::size_t size);
void*
__libc_realloc (void* memory, std::size_t size);
void*
__libc_memalign (std::size_t alignment, std::size_t size);

void*
malloc (std::size_t size) noexcept
{
  return allocationFails() ? nullptr : __libc_malloc (size);
}

void*
calloc (std::size_t number, std::size_t size) noexcept
{
  return allocationFails() ? nullptr : __libc_calloc (number, size);
}

void*
realloc (void* memory, std::size_t size) noexcept
{
  return allocationFails() ? nullptr : __libc_realloc (memory, size);
}

void*
aligned_alloc (std::size_t alignment, std::size_t size) noexcept
{
  return allocationFails() ? nullptr : __libc_memalign (alignment, size);
}

int
posix_memalign (void** memory, std::size_t alignment, std::size_t size) noexcept
{
  *memory = allocationFails() ? nullptr : __libc_memalign (alignment, size);
  return *memory || size == 0 ? 0 : ENOMEM;
}
}
#endif
