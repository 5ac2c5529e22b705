// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in front of the C library's calls on files, so that the nth one of a folder can be made to fail.
#include "tests/fault/failing_calls.h"

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

using odo::test::FailingCalls;

namespace {

enum class Kind { Open, OpenToWrite, Make, Write, Sync, Name, Remove, Size, Map, Read };

FailingCalls *calls = nullptr;

bool counts(Kind kind)
{
    switch (calls->error) {
    case ENOSPC:
        return kind == Kind::Make || kind == Kind::Write || kind == Kind::Sync || kind == Kind::Name ||
               kind == Kind::Size;
    case EROFS:
        return kind == Kind::Make || kind == Kind::OpenToWrite || kind == Kind::Write || kind == Kind::Name ||
               kind == Kind::Remove || kind == Kind::Size;
    case EIO:
        return calls->reads || (kind != Kind::Open && kind != Kind::Read);
    default: // killed
        return kind != Kind::Open && kind != Kind::Read && kind != Kind::Map && kind != Kind::OpenToWrite;
    }
}

bool isBelow(const char *path)
{
    const std::size_t length = std::strlen(calls->folder);
    return std::strncmp(path, calls->folder, length) == 0 && (path[length] == '/' || path[length] == '\0');
}

struct Path
{
    char text[PATH_MAX] = {};
};

Path pathOf(int descriptor)
{
    Path path;
    char link[64];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const long length = syscall(SYS_readlink, link, path.text, sizeof path.text - 1);
    path.text[length > 0 ? length : 0] = '\0';
    return path;
}

Path pathOf(int folder, const char *name)
{
    if (name == nullptr)
        return {};
    Path path;
    if (name[0] == '/') {
        std::snprintf(path.text, sizeof path.text, "%s", name);
        return path;
    }
    Path base;
    if (folder == AT_FDCWD)
        syscall(SYS_getcwd, base.text, sizeof base.text);
    else
        base = pathOf(folder);
    std::snprintf(path.text, sizeof path.text, "%.2000s/%.2000s", base.text, name);
    return path;
}

[[noreturn]] void die()
{
    syscall(SYS_kill, syscall(SYS_getpid), SIGKILL);
    std::abort(); // not reached
}

/// What is to become of a call.
enum class Fate { Happens, Fails, HappensHalf };

Fate fateOf(Kind kind, const char *call, const Path &path)
{
    if (!isBelow(path.text) || !counts(kind))
        return Fate::Happens;
    const int number = ++calls->count;
    const bool fromThenOn = calls->how == FailingCalls::How::FromThenOn;
    if (calls->nth == 0 || number < calls->nth || (number > calls->nth && !fromThenOn))
        return Fate::Happens;
    const bool isFirst = calls->failed++ == 0;
    if (isFirst) {
        std::snprintf(calls->call, sizeof calls->call, "%s", call);
        std::snprintf(calls->path, sizeof calls->path, "%.500s", path.text);
    }
    const bool half = kind == Kind::Write && isFirst;
    if (calls->how == FailingCalls::How::KilledHalfway && half)
        return Fate::HappensHalf;
    if (calls->how == FailingCalls::How::Killed || calls->how == FailingCalls::How::KilledHalfway)
        die();
    if (fromThenOn && calls->error == ENOSPC && half)
        return Fate::HappensHalf;
    errno = calls->error;
    return Fate::Fails;
}

Fate fateOf(Kind kind, const char *call, int descriptor)
{
    return calls == nullptr ? Fate::Happens : fateOf(kind, call, pathOf(descriptor));
}

Fate fateOf(Kind kind, const char *call, int folder, const char *name)
{
    return calls == nullptr ? Fate::Happens : fateOf(kind, call, pathOf(folder, name));
}

Kind kindOf(int flags, int folder, const char *name)
{
    if ((flags & O_TMPFILE) == O_TMPFILE)
        return Kind::Make;
    if ((flags & O_CREAT) != 0) {
        struct stat there
        {
        };
        if (syscall(SYS_newfstatat, folder, name, &there, 0) != 0)
            return Kind::Make;
    }
    return (flags & (O_WRONLY | O_RDWR | O_TRUNC)) != 0 ? Kind::OpenToWrite : Kind::Open;
}

int openFile(const char *call, int folder, const char *name, int flags, mode_t mode)
{
    if (calls != nullptr && fateOf(kindOf(flags, folder, name), call, folder, name) == Fate::Fails)
        return -1;
    return static_cast<int>(syscall(SYS_openat, folder, name, flags, mode));
}

template <class Real>
ssize_t writeSome(const char *call, int descriptor, std::size_t bytes, const Real &real)
{
    switch (fateOf(Kind::Write, call, descriptor)) {
    case Fate::Fails:
        return -1;
    case Fate::HappensHalf: {
        const ssize_t written = bytes > 1 ? static_cast<ssize_t>(real(bytes / 2)) : 0;
        if (calls->how == FailingCalls::How::KilledHalfway)
            die();
        if (written > 0)
            return written;
        errno = calls->error;
        return -1;
    }
    case Fate::Happens:
        break;
    }
    return static_cast<ssize_t>(real(bytes));
}

template <class Real>
int unlessItFails(Fate fate, const Real &real)
{
    return fate == Fate::Fails ? -1 : static_cast<int>(real());
}

template <class Function>
Function next(const char *name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// The memory that the environment names, where a program was started under the test.
__attribute__((constructor)) void mapCalls()
{
    const char *file = std::getenv(odo::test::failingCallsVariable);
    if (file == nullptr)
        return;
    const long descriptor = syscall(SYS_openat, AT_FDCWD, file, O_RDWR | O_CLOEXEC, 0);
    const long memory =
        syscall(SYS_mmap, nullptr, sizeof(FailingCalls), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    if (descriptor >= 0 && memory != -1)
        calls = reinterpret_cast<FailingCalls *>(memory);
    syscall(SYS_close, descriptor);
}

mode_t modeOf(int flags, va_list arguments)
{
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

} // namespace

extern "C" {

void odographSetFailingCalls(FailingCalls *set)
{
    calls = set;
}

#define ODOGRAPH_OPEN(name)                                                                                  \
    int name(const char *path, int flags, ...)                                                               \
    {                                                                                                        \
        va_list arguments;                                                                                   \
        va_start(arguments, flags);                                                                          \
        const mode_t mode = modeOf(flags, arguments);                                                        \
        va_end(arguments);                                                                                   \
        return openFile(#name, AT_FDCWD, path, flags, mode);                                                 \
    }
#define ODOGRAPH_OPENAT(name)                                                                                \
    int name(int folder, const char *path, int flags, ...)                                                   \
    {                                                                                                        \
        va_list arguments;                                                                                   \
        va_start(arguments, flags);                                                                          \
        const mode_t mode = modeOf(flags, arguments);                                                        \
        va_end(arguments);                                                                                   \
        return openFile(#name, folder, path, flags, mode);                                                   \
    }
ODOGRAPH_OPEN(open)
ODOGRAPH_OPEN(open64)
ODOGRAPH_OPENAT(openat)
ODOGRAPH_OPENAT(openat64)
int __open_2(const char *path, int flags)
{
    return openFile("open", AT_FDCWD, path, flags, 0);
}
int __open64_2(const char *path, int flags)
{
    return openFile("open", AT_FDCWD, path, flags, 0);
}
int __openat_2(int folder, const char *path, int flags)
{
    return openFile("openat", folder, path, flags, 0);
}
int __openat64_2(int folder, const char *path, int flags)
{
    return openFile("openat", folder, path, flags, 0);
}
int creat(const char *path, mode_t mode)
{
    return openFile("creat", AT_FDCWD, path, O_CREAT | O_WRONLY | O_TRUNC, mode);
}
int creat64(const char *path, mode_t mode)
{
    return openFile("creat", AT_FDCWD, path, O_CREAT | O_WRONLY | O_TRUNC, mode);
}

FILE *fopen(const char *path, const char *mode)
{
    static const auto real = next<FILE *(*)(const char *, const char *)>("fopen");
    const int flags =
        mode[0] == 'r' ? (std::strchr(mode, '+') != nullptr ? O_RDWR : O_RDONLY) : O_CREAT | O_WRONLY;
    if (calls != nullptr && fateOf(kindOf(flags, AT_FDCWD, path), "fopen", AT_FDCWD, path) == Fate::Fails)
        return nullptr;
    return real(path, mode);
}
FILE *fopen64(const char *path, const char *mode)
{
    return fopen(path, mode);
}

ssize_t write(int descriptor, const void *data, size_t bytes)
{
    return writeSome("write", descriptor, bytes,
                     [&](size_t some) { return syscall(SYS_write, descriptor, data, some); });
}
ssize_t pwrite64(int descriptor, const void *data, size_t bytes, off64_t at)
{
    return writeSome("pwrite", descriptor, bytes,
                     [&](size_t some) { return syscall(SYS_pwrite64, descriptor, data, some, at); });
}
ssize_t pwrite(int descriptor, const void *data, size_t bytes, off_t at)
{
    return pwrite64(descriptor, data, bytes, at);
}
ssize_t writev(int descriptor, const iovec *parts, int count)
{
    // Half of it is the first half of its parts.
    return writeSome("writev", descriptor, static_cast<size_t>(count),
                     [&](size_t some) { return syscall(SYS_writev, descriptor, parts, some); });
}

ssize_t read(int descriptor, void *data, size_t bytes)
{
    if (fateOf(Kind::Read, "read", descriptor) == Fate::Fails)
        return -1;
    return syscall(SYS_read, descriptor, data, bytes);
}
ssize_t pread64(int descriptor, void *data, size_t bytes, off64_t at)
{
    if (fateOf(Kind::Read, "pread", descriptor) == Fate::Fails)
        return -1;
    return syscall(SYS_pread64, descriptor, data, bytes, at);
}
ssize_t pread(int descriptor, void *data, size_t bytes, off_t at)
{
    return pread64(descriptor, data, bytes, at);
}
ssize_t __read_chk(int descriptor, void *data, size_t bytes, size_t)
{
    return read(descriptor, data, bytes);
}
ssize_t __pread64_chk(int descriptor, void *data, size_t bytes, off64_t at, size_t)
{
    return pread64(descriptor, data, bytes, at);
}
ssize_t __pread_chk(int descriptor, void *data, size_t bytes, off_t at, size_t)
{
    return pread64(descriptor, data, bytes, at);
}

int fsync(int descriptor)
{
    return unlessItFails(fateOf(Kind::Sync, "fsync", descriptor),
                         [&] { return syscall(SYS_fsync, descriptor); });
}
int fdatasync(int descriptor)
{
    return unlessItFails(fateOf(Kind::Sync, "fdatasync", descriptor),
                         [&] { return syscall(SYS_fdatasync, descriptor); });
}
int ftruncate64(int descriptor, off64_t bytes)
{
    return unlessItFails(fateOf(Kind::Size, "ftruncate", descriptor),
                         [&] { return syscall(SYS_ftruncate, descriptor, bytes); });
}
int ftruncate(int descriptor, off_t bytes)
{
    return ftruncate64(descriptor, bytes);
}
int fallocate64(int descriptor, int mode, off64_t at, off64_t bytes)
{
    return unlessItFails(fateOf(Kind::Size, "fallocate", descriptor),
                         [&] { return syscall(SYS_fallocate, descriptor, mode, at, bytes); });
}
int fallocate(int descriptor, int mode, off_t at, off_t bytes)
{
    return fallocate64(descriptor, mode, at, bytes);
}
int posix_fallocate64(int descriptor, off64_t at, off64_t bytes)
{
    return fallocate64(descriptor, 0, at, bytes) == 0 ? 0 : errno;
}
int posix_fallocate(int descriptor, off_t at, off_t bytes)
{
    return posix_fallocate64(descriptor, at, bytes);
}

int renameat2(int fromFolder, const char *from, int toFolder, const char *to, unsigned flags)
{
    return unlessItFails(fateOf(Kind::Name, "rename", toFolder, to),
                         [&] { return syscall(SYS_renameat2, fromFolder, from, toFolder, to, flags); });
}
int renameat(int fromFolder, const char *from, int toFolder, const char *to)
{
    return renameat2(fromFolder, from, toFolder, to, 0);
}
int rename(const char *from, const char *to)
{
    return renameat2(AT_FDCWD, from, AT_FDCWD, to, 0);
}
int linkat(int fromFolder, const char *from, int toFolder, const char *to, int flags)
{
    return unlessItFails(fateOf(Kind::Name, "link", toFolder, to),
                         [&] { return syscall(SYS_linkat, fromFolder, from, toFolder, to, flags); });
}
int link(const char *from, const char *to)
{
    return linkat(AT_FDCWD, from, AT_FDCWD, to, 0);
}
int unlinkat(int folder, const char *path, int flags)
{
    return unlessItFails(fateOf(Kind::Remove, "unlink", folder, path),
                         [&] { return syscall(SYS_unlinkat, folder, path, flags); });
}
int unlink(const char *path)
{
    return unlinkat(AT_FDCWD, path, 0);
}
int rmdir(const char *path)
{
    return unlinkat(AT_FDCWD, path, AT_REMOVEDIR);
}
int remove(const char *path)
{
    const int removed = unlinkat(AT_FDCWD, path, 0);
    return removed != 0 && errno == EISDIR ? rmdir(path) : removed;
}
int mkdirat(int folder, const char *path, mode_t mode)
{
    struct stat there
    {
    };
    if (calls == nullptr || syscall(SYS_newfstatat, folder, path, &there, 0) == 0)
        return static_cast<int>(syscall(SYS_mkdirat, folder, path, mode));
    return unlessItFails(fateOf(Kind::Make, "mkdir", folder, path),
                         [&] { return syscall(SYS_mkdirat, folder, path, mode); });
}
int mkdir(const char *path, mode_t mode)
{
    return mkdirat(AT_FDCWD, path, mode);
}

void *mmap64(void *address, size_t bytes, int protection, int flags, int descriptor, off64_t at)
{
    if ((flags & MAP_ANONYMOUS) == 0 && fateOf(Kind::Map, "mmap", descriptor) == Fate::Fails)
        return MAP_FAILED;
    return reinterpret_cast<void *>(syscall(SYS_mmap, address, bytes, protection, flags, descriptor, at));
}
void *mmap(void *address, size_t bytes, int protection, int flags, int descriptor, off_t at)
{
    return mmap64(address, bytes, protection, flags, descriptor, at);
}

} // extern "C"
