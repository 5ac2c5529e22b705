// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/temporary.h"

#include "core/base/file_system.h"
#include "core/files/file_words.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <new>
#include <string_view>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace odo {

namespace {

constexpr std::string_view nameStart = ".odograph-", nameEnd = ".part",
                           nameLetters = "abcdefghijklmnopqrstuvwxyz234567";
constexpr const char *markName = "temporary folder of Odograph";
constexpr std::size_t lettersOfName = 12;
constexpr const char *nameOfFile = "new";
constexpr std::time_t longestWritingS = 24 * 3600; // where the file system knows no locks

/// Empty, with errno, where the system has no random numbers.
std::string randomName()
{
    const std::string letters = randomLetters(lettersOfName);
    return letters.empty() ? letters : std::string(nameStart) + letters + std::string(nameEnd);
}

void removeAll(const std::filesystem::path &path)
{
    try {
        files::removeAll(path);
    } catch (const std::bad_alloc &) { // it stays, and is swept later
    }
}

/// What marks a folder as one that was made here: a copy of it, or one that was renamed, is somebody's own.
std::string markOf(const std::filesystem::path &folder)
{
    return folder.filename().string() + " is a temporary folder of Odograph, which removes it.\n";
}

bool hasMark(const std::filesystem::path &folder)
{
    const int descriptor =
        ::open((folder / markName).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0)
        return false;
    const std::string mark = markOf(folder);
    std::string text(mark.size() + 1, '\0');
    const ssize_t length = ::pread(descriptor, text.data(), text.size(), 0);
    ::close(descriptor);
    return length == static_cast<ssize_t>(mark.size()) && text.starts_with(mark);
}

/// False, with errno, where it cannot be written.
bool setMark(const std::filesystem::path &folder)
{
    const int descriptor =
        ::open((folder / markName).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (descriptor < 0)
        return false;
    const int failed = writeAll(descriptor, markOf(folder));
    ::close(descriptor);
    errno = failed;
    return failed == 0;
}

void removeIfStray(const std::filesystem::path &path)
{
    struct stat status
    {
    };
    if (::lstat(path.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != ::geteuid())
        return;
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0)
        return;
    const bool isUnlocked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    const bool isUnknown = !isUnlocked && errno != EWOULDBLOCK;
    if ((isUnlocked || (isUnknown && std::time(nullptr) - status.st_mtime > longestWritingS)) &&
        hasMark(path))
        removeAll(path);
    ::close(descriptor);
}

void sweep(const std::filesystem::path &folder)
{
    std::error_code ignored;
    for (const std::string &name : files::namesIn(folder, ignored))
        if (isTemporaryName(name))
            removeIfStray(folder / name);
}

tl::unexpected<Error> cannotMake(const std::filesystem::path &folder, const Message &what, int reason)
{
    if (!files::isFolder(folder))
        return fail(ErrorCode::NotFound, what, noSuchFolder(folder), makeFolderFirst());
    if (reason == ENOSPC || reason == EDQUOT)
        return fail(ErrorCode::Io, what, ODO_TEXT("files.disk_is_full", "the disk is full"),
                    makeRoomOnDisk());
    return fail(ErrorCode::ReadOnly, what,
                ODO_TEXT("files.folder_not_writable", "the folder '%1' cannot be written to (%2)")(
                    Named::file(folder), foreignWords(std::strerror(reason))),
                chooseWritableFolder());
}

/// A new folder under a new name, locked and marked: its path, and what holds its lock.
Result<std::pair<std::filesystem::path, int>> madeIn(const std::filesystem::path &folder, const Message &what)
{
    sweep(folder);
    constexpr int mostAttempts = 100;
    for (int attempt = 0; attempt < mostAttempts; ++attempt) {
        const std::string name = randomName();
        if (name.empty())
            break;
        const std::filesystem::path path = folder / name;
        if (::mkdir(path.c_str(), 0700) != 0) {
            if (errno == EEXIST)
                continue;
            break;
        }
        const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (descriptor >= 0) {
            static_cast<void>(::flock(descriptor, LOCK_EX)); // without locks, its age decides
            if (setMark(path))                               // nobody sweeps it before
                return std::pair(path, descriptor);
        }
        const int failed = errno;
        removeAll(path);
        if (descriptor >= 0)
            ::close(descriptor);
        errno = failed;
        break;
    }
    return cannotMake(folder, what, errno);
}

} // namespace

bool isTemporaryName(const std::filesystem::path &name)
{
    const std::string text = name.string();
    if (text.size() != nameStart.size() + lettersOfName + nameEnd.size() || !text.starts_with(nameStart) ||
        !text.ends_with(nameEnd))
        return false;
    return std::string_view(text).substr(nameStart.size(), lettersOfName).find_first_not_of(nameLetters) ==
           std::string_view::npos;
}

bool syncToDisk(const std::filesystem::path &path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return false;
    const bool written = ::fsync(descriptor) == 0;
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    return written;
}

namespace {

/// The name is made somebody's first, by something that the renaming replaces. 0, or errno.
int takePlace(const std::filesystem::path &from, const std::filesystem::path &to)
{
    const bool isFolder = files::kindOfItself(from) == files::Kind::Folder;
    const int place = isFolder
                          ? ::mkdir(to.c_str(), 0700)
                          : ::open(to.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (place < 0)
        return errno;
    if (!isFolder)
        ::close(place);
    if (::rename(from.c_str(), to.c_str()) == 0)
        return 0;
    const int failed = errno;
    std::remove(to.c_str());
    return failed;
}

} // namespace

int giveFreeName(const std::filesystem::path &from, const std::filesystem::path &to)
{
    // A hard link fails where a file is, unlike a rename. Not every file system (a USB stick's FAT) knows
    // links.
    if (::link(from.c_str(), to.c_str()) == 0) {
        ::unlink(from.c_str());
        return 0;
    }
    if (errno == EEXIST)
        return errno;
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0)
        return 0;
    if (errno != EINVAL && errno != ENOSYS)
        return errno;
    return takePlace(from, to);
}

TemporaryFile::TemporaryFile(std::unique_ptr<TemporaryFolder> folder, int descriptor, Message what)
    : m_folder(std::move(folder)), m_descriptor(descriptor), m_what(std::move(what))
{
}

Result<std::unique_ptr<TemporaryFile>> TemporaryFile::make(const std::filesystem::path &folder,
                                                           const Message &what)
{
    auto made = ODO_TRY(TemporaryFolder::make(folder, what));
    const int descriptor =
        ::open((made->path() / nameOfFile).c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0)
        return cannotMake(folder, what, errno);
    return std::unique_ptr<TemporaryFile>(new TemporaryFile(std::move(made), descriptor, what));
}

TemporaryFile::~TemporaryFile()
{
    ::close(m_descriptor);
}

std::filesystem::path TemporaryFile::path() const
{
    return m_folder->path() / nameOfFile;
}

tl::unexpected<Error> TemporaryFile::failure(int reason) const
{
    if (reason == EEXIST)
        return fail(ErrorCode::AlreadyExists, m_what, isThereAlready(), chooseAnotherNameOrFolder());
    return fail(ErrorCode::Io, m_what, cannotBeWritten(std::strerror(reason)), chooseFolderWithRoom());
}

Result<void> TemporaryFile::sync() const
{
    return ::fsync(m_descriptor) == 0 ? Result<void>() : failure(errno);
}

void TemporaryFile::published(const std::filesystem::path &target)
{
    m_folder.reset();
    // some file systems cannot sync a folder: the file itself is safe already
    syncToDisk(target.parent_path());
}

Result<void> TemporaryFile::replace(const std::filesystem::path &target)
{
    ODO_TRY(sync());
    if (::rename(path().c_str(), target.c_str()) != 0)
        return failure(errno);
    published(target);
    return {};
}

Result<void> TemporaryFile::publish(const std::filesystem::path &target)
{
    ODO_TRY(sync());
    if (const int reason = giveFreeName(path(), target); reason != 0)
        return failure(reason);
    published(target);
    return {};
}

Result<std::unique_ptr<TemporaryFolder>> TemporaryFolder::make(const std::filesystem::path &folder,
                                                               const Message &what)
{
    auto made = ODO_TRY(madeIn(folder, what));
    std::unique_ptr<TemporaryFolder> temporary(new TemporaryFolder(std::move(made.first), made.second));
    if (::mkdir(temporary->path().c_str(), 0700) != 0)
        return cannotMake(folder, what, errno);
    return temporary;
}

TemporaryFolder::~TemporaryFolder()
{
    if (isAt(m_outer, m_descriptor))
        removeAll(m_outer);
    ::close(m_descriptor);
}

bool isAt(const std::filesystem::path &path, int descriptor)
{
    struct stat open
    {
    }, there{};
    return ::fstat(descriptor, &open) == 0 && ::lstat(path.c_str(), &there) == 0 &&
           open.st_ino == there.st_ino && open.st_dev == there.st_dev;
}

int writeAll(int descriptor, std::span<const char> bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            return errno;
        if (written > 0)
            bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

std::string randomLetters(std::size_t count)
{
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz234567";
    std::string text(count, '\0');
    if (::getrandom(text.data(), count, 0) != static_cast<ssize_t>(count))
        return {};
    for (char &character : text)
        character = letters[static_cast<unsigned char>(character) % letters.size()];
    return text;
}

namespace {

constexpr mode_t asTheUserWishes = 0666; // less the umask
constexpr int newFile = O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC | O_NOFOLLOW;

std::error_code systemError(int number)
{
    return {number, std::generic_category()};
}

std::filesystem::path numbered(const std::filesystem::path &folder, const std::string &stem,
                               const std::string &ending, int number)
{
    return folder / (number == 1 ? stem + ending : stem + "_" + std::to_string(number) + ending);
}

/// 0, or why not. Some file systems of a network know no locks: there a name is still nobody else's.
int lock(int descriptor, int how)
{
    int failed = 0;
    do
        failed = ::flock(descriptor, how) == 0 ? 0 : errno;
    while (failed == EINTR);
    return failed == EWOULDBLOCK ? failed : 0;
}

} // namespace

ClaimedFile::ClaimedFile(std::filesystem::path path, int descriptor, Made made)
    : m_path(std::move(path)), m_descriptor(descriptor), m_isOurs(made == Made::Here), m_goes(m_isOurs)
{
}

ClaimedFile::ClaimedFile(ClaimedFile &&other) noexcept
    : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)),
      m_isOurs(other.m_isOurs), m_goes(other.m_goes)
{
}

ClaimedFile &ClaimedFile::operator=(ClaimedFile &&other) noexcept
{
    if (this != &other) {
        close();
        m_path = std::move(other.m_path);
        m_descriptor = std::exchange(other.m_descriptor, -1);
        m_isOurs = other.m_isOurs;
        m_goes = other.m_goes;
    }
    return *this;
}

ClaimedFile::~ClaimedFile()
{
    close();
}

void ClaimedFile::close()
{
    if (m_descriptor < 0)
        return;
    if (m_goes && isAt(m_path, m_descriptor))
        ::unlink(m_path.c_str()); // while it is claimed
    ::close(m_descriptor);
    m_descriptor = -1;
}

void ClaimedFile::remove()
{
    m_goes = m_isOurs;
    close();
}

ClaimedFile::Outcome<ClaimedFile> ClaimedFile::create(const std::filesystem::path &folder,
                                                      const std::string &stem, const std::string &ending)
{
    for (int number = 1;;) {
        const std::filesystem::path path = numbered(folder, stem, ending, number);
        const int descriptor = ::open(path.c_str(), newFile, asTheUserWishes);
        if (descriptor < 0 && errno == EEXIST) {
            ++number;
            continue;
        }
        if (descriptor < 0)
            return tl::unexpected(systemError(errno));
        ClaimedFile file(path, descriptor, Made::Here);
        lock(descriptor, LOCK_EX);  // waits for whoever checks whether it is held
        if (isAt(path, descriptor)) // who removes stray files may have been faster
            return file;
    }
}

ClaimedFile::Outcome<ClaimedFile> ClaimedFile::begin(const std::filesystem::path &folder)
{
    for (;;) {
        const std::string name = randomLetters(6);
        if (name.empty())
            return tl::unexpected(systemError(errno));
        const std::filesystem::path path = folder / (".new-" + name + ".part");
        const int descriptor = ::open(path.c_str(), newFile, asTheUserWishes);
        if (descriptor < 0 && errno == EEXIST)
            continue;
        if (descriptor < 0)
            return tl::unexpected(systemError(errno));
        ClaimedFile file(path, descriptor, Made::Here);
        lock(descriptor, LOCK_EX);
        if (isAt(path, descriptor))
            return file;
    }
}

ClaimedFile::Outcome<ClaimedFile> ClaimedFile::hold(const std::filesystem::path &path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        return tl::unexpected(systemError(errno));
    ClaimedFile file(path, descriptor, Made::Before);
    if (const int held = lock(descriptor, LOCK_SH | LOCK_NB); held != 0)
        return tl::unexpected(systemError(held));
    return file;
}

ClaimedFile::Outcome<std::int64_t> ClaimedFile::bytes() const
{
    struct stat status
    {
    };
    if (::fstat(m_descriptor, &status) != 0)
        return tl::unexpected(systemError(errno));
    return status.st_size;
}

std::error_code ClaimedFile::write(std::span<const char> bytes) const
{
    const int failed = writeAll(m_descriptor, bytes);
    return failed == 0 ? std::error_code() : systemError(failed);
}

std::error_code ClaimedFile::sync() const
{
    return ::fsync(m_descriptor) == 0 ? std::error_code() : systemError(errno);
}

std::error_code ClaimedFile::publish(const std::string &stem, const std::string &ending)
{
    const std::filesystem::path folder = m_path.parent_path();
    for (int number = 1;; ++number) {
        std::filesystem::path path = numbered(folder, stem, ending, number);
        const int failed = giveFreeName(m_path, path);
        if (failed == EEXIST)
            continue;
        if (failed != 0)
            return systemError(failed);
        m_path = std::move(path);
        return {};
    }
}

} // namespace odo
