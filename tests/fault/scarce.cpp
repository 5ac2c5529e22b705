// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fault/scarce.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <link.h>
#include <malloc.h>
#include <new>
#include <pthread.h>

namespace {

using odo::test::Scarce;

struct Code
{
    std::uintptr_t from = 0, to = 0;
    bool holds(const void *address) const
    {
        const auto at = reinterpret_cast<std::uintptr_t>(address);
        return at >= from && at < to;
    }
};

std::atomic<bool> watches = false;
std::atomic<int> watched = 0;
std::atomic<std::uint64_t> asked = 0, failing = 0;
std::array<Code, 2> ours; ///< this program, and the standard library that works for it

/// Notes the program's own code (which comes first, without a name) and libstdc++'s.
int noteCode(dl_phdr_info *info, std::size_t, void *isFirst)
{
    auto &first = *static_cast<bool *>(isFirst);
    const bool isStandard = std::strstr(info->dlpi_name, "libstdc++") != nullptr;
    if (first || isStandard) {
        Code &code = ours[first ? 0 : 1];
        for (int i = 0; i < info->dlpi_phnum; ++i) {
            const auto &part = info->dlpi_phdr[i];
            if (part.p_type == PT_LOAD && (part.p_flags & PF_X) != 0)
                code = {info->dlpi_addr + part.p_vaddr, info->dlpi_addr + part.p_vaddr + part.p_memsz};
        }
    }
    first = false;
    return 0;
}

bool isToFail(Scarce what)
{
    return watches && watched == static_cast<int>(what) && ++asked == failing;
}

// What new and delete are made of here. NOLINTBEGIN(cppcoreguidelines-no-malloc)
void *allocated(std::size_t size, std::size_t alignment, const void *caller)
{
    const bool isOurs = watches && (ours[0].holds(caller) || ours[1].holds(caller));
    if (isOurs && isToFail(Scarce::Memory))
        throw std::bad_alloc();
    const std::size_t bytes = size > 0 ? size : 1;
    void *memory = alignment > alignof(std::max_align_t)
                       ? std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment)
                       : std::malloc(bytes);
    if (!memory)
        throw std::bad_alloc();
    return memory;
}

} // namespace

namespace odo::test {

FailingRequest::FailingRequest(Scarce what, std::uint64_t n)
{
    bool isFirst = true;
    dl_iterate_phdr(noteCode, &isFirst);
    watched = static_cast<int>(what);
    asked = 0;
    failing = n;
    watches = true;
}

FailingRequest::~FailingRequest()
{
    watches = false;
}

std::uint64_t FailingRequest::requests() const
{
    return asked;
}

bool FailingRequest::hasFailed() const
{
    return failing > 0 && asked >= failing;
}

} // namespace odo::test

void *operator new(std::size_t size)
{
    return allocated(size, 0, __builtin_return_address(0));
}
void *operator new[](std::size_t size)
{
    return allocated(size, 0, __builtin_return_address(0));
}
void *operator new(std::size_t size, std::align_val_t alignment)
{
    return allocated(size, static_cast<std::size_t>(alignment), __builtin_return_address(0));
}
// Who asks so can do without. Ours, because the sanitizer's are not to be given back to malloc.
void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
    return std::malloc(size > 0 ? size : 1);
}
void *operator new[](std::size_t size, const std::nothrow_t &) noexcept
{
    return std::malloc(size > 0 ? size : 1);
}
void operator delete(void *memory) noexcept
{
    std::free(memory);
}
void operator delete[](void *memory) noexcept
{
    std::free(memory);
}
void operator delete(void *memory, std::size_t) noexcept
{
    std::free(memory);
}
void operator delete[](void *memory, std::size_t) noexcept
{
    std::free(memory);
}
void operator delete(void *memory, std::align_val_t) noexcept
{
    std::free(memory);
}
void operator delete(void *memory, std::size_t, std::align_val_t) noexcept
{
    std::free(memory);
}
// NOLINTEND(cppcoreguidelines-no-malloc)

/// libav's only way to memory.
extern "C" int posix_memalign(void **memory, std::size_t alignment, std::size_t size) noexcept
{
    if (isToFail(Scarce::VideoMemory))
        return ENOMEM;
    *memory = ::memalign(alignment, size);
    return *memory || size == 0 ? 0 : ENOMEM;
}

extern "C" int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*work)(void *),
                              void *of) noexcept
{
    using Create = int (*)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);
    static const auto next = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
    return isToFail(Scarce::Threads) ? EAGAIN : next(thread, attributes, work, of);
}
