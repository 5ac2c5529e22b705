// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in front of the C library's calls with which a database is read and written, and makes each take its
// time, so that what another process sees in between lasts. ODOGRAPH_SLOW_US: microseconds a call.
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

namespace {

void waitAWhile()
{
    static const unsigned microseconds = [] {
        const char *told = std::getenv("ODOGRAPH_SLOW_US");
        return told != nullptr ? static_cast<unsigned>(std::strtoul(told, nullptr, 10)) : 0U;
    }();
    if (microseconds > 0)
        usleep(microseconds);
}

template <class Function>
Function next(const char *name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

ssize_t pwrite64(int descriptor, const void *bytes, size_t size, off64_t offset)
{
    static const auto call = next<ssize_t (*)(int, const void *, size_t, off64_t)>("pwrite64");
    waitAWhile();
    return call(descriptor, bytes, size, offset);
}

ssize_t pread64(int descriptor, void *bytes, size_t size, off64_t offset)
{
    static const auto call = next<ssize_t (*)(int, void *, size_t, off64_t)>("pread64");
    waitAWhile();
    return call(descriptor, bytes, size, offset);
}

int fdatasync(int descriptor)
{
    static const auto call = next<int (*)(int)>("fdatasync");
    waitAWhile();
    return call(descriptor);
}

int fsync(int descriptor)
{
    static const auto call = next<int (*)(int)>("fsync");
    waitAWhile();
    return call(descriptor);
}

int ftruncate64(int descriptor, off64_t size) noexcept
{
    static const auto call = next<int (*)(int, off64_t)>("ftruncate64");
    waitAWhile();
    return call(descriptor, size);
}

int unlink(const char *path) noexcept
{
    static const auto call = next<int (*)(const char *)>("unlink");
    waitAWhile();
    return call(path);
}
}
