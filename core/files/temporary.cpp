// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/temporary.h"

#include "core/base/file_system.h"
#include "core/base/platform/file_names.h"
#include "core/base/platform/process.h"
#include "core/files/file_words.h"

#include <chrono>
#include <new>
#include <string_view>
#include <utility>

namespace odo {

namespace {

constexpr std::string_view nameStart = ".odograph-", nameEnd = ".part",
                           nameLetters = "abcdefghijklmnopqrstuvwxyz234567";
constexpr const char *markName = "temporary folder of Odograph";
constexpr std::size_t lettersOfName = 12;
constexpr const char *nameOfFile = "new";
constexpr std::chrono::hours longestWriting(24); // where the file system knows no locks

/// So many letters and digits that nobody can foresee.
SystemResult<std::string> randomLetters(std::size_t count)
{
    std::string text(count, '\0');
    if (const std::error_code problem = fillWithRandom(std::as_writable_bytes(std::span(text))))
        return tl::unexpected(problem);
    for (char &character : text)
        character = nameLetters[static_cast<unsigned char>(character) % nameLetters.size()];
    return text;
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
    const auto file = FileHandle::openToRead(folder / markName, FileHandle::Links::Refused);
    const std::string mark = markOf(folder);
    std::string text(mark.size() + 1, '\0');
    return file && file->readStart(text) == mark.size() && text.starts_with(mark);
}

std::error_code setMark(const std::filesystem::path &folder)
{
    const auto file = FileHandle::create(folder / markName, FileHandle::Permissions::OwnerAlone);
    return file ? file->write(markOf(folder)) : file.error();
}

void removeIfStray(const std::filesystem::path &path)
{
    const auto status = statusOfItself(path);
    if (!status || status->kind != files::Kind::Folder || !status->isOwn)
        return;
    const auto folder = FileHandle::openFolder(path, FileHandle::Links::Refused);
    if (!folder)
        return;
    const std::error_code problem = folder->tryLock(FileHandle::Lock::Exclusive);
    const bool isUnknown = problem && problem != std::errc::operation_would_block;
    const auto longAgo = std::chrono::system_clock::now().time_since_epoch() - longestWriting;
    if ((!problem || (isUnknown && Nanoseconds(status->modifiedNs) < longAgo)) && hasMark(path))
        removeAll(path);
}

void sweep(const std::filesystem::path &folder)
{
    std::error_code ignored;
    for (const std::string &name : files::namesIn(folder, ignored))
        if (isTemporaryName(name))
            removeIfStray(folder / name);
}

tl::unexpected<Error> cannotMake(const std::filesystem::path &folder, const Message &what,
                                 const std::error_code &reason)
{
    if (!files::isFolder(folder))
        return fail(ErrorCode::NotFound, what, noSuchFolder(folder), makeFolderFirst());
    if (isDiskFull(reason))
        return fail(ErrorCode::Io, what, ODO_TEXT("files.disk_is_full", "the disk is full"), freeDiskSpace());
    return fail(ErrorCode::ReadOnly, what,
                ODO_TEXT("files.folder_not_writable", "the folder '%1' cannot be written to (%2)")(
                    Named::file(folder), foreignWords(reason.message())),
                chooseWritableFolder());
}

/// A new folder under a new name, locked and marked: its path, and what holds its lock.
Result<std::pair<std::filesystem::path, FileHandle>> madeIn(const std::filesystem::path &folder,
                                                            const Message &what)
{
    sweep(folder);
    constexpr int mostAttempts = 100;
    std::error_code problem;
    for (int attempt = 0; attempt < mostAttempts; ++attempt) {
        const auto letters = randomLetters(lettersOfName);
        if (!letters)
            return cannotMake(folder, what, letters.error());
        const std::filesystem::path path =
            folder / (std::string(nameStart) + *letters + std::string(nameEnd));
        problem = makeOwnFolder(path);
        if (problem == std::errc::file_exists)
            continue;
        if (problem)
            break;
        auto handle = FileHandle::openFolder(path, FileHandle::Links::Refused);
        if (handle) {
            static_cast<void>(handle->lock(FileHandle::Lock::Exclusive)); // without locks its age decides
            problem = setMark(path);                                      // nobody sweeps it before
            if (!problem)
                return std::pair(path, std::move(*handle));
        }
        removeAll(path);
        return cannotMake(folder, what, handle ? problem : handle.error());
    }
    return cannotMake(folder, what, problem);
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

TemporaryFile::TemporaryFile(std::unique_ptr<TemporaryFolder> folder, FileHandle handle, Message what)
    : m_folder(std::move(folder)), m_handle(std::move(handle)), m_what(std::move(what))
{
}

Result<std::unique_ptr<TemporaryFile>> TemporaryFile::make(const std::filesystem::path &folder,
                                                           const Message &what)
{
    auto made = ODO_TRY(TemporaryFolder::make(folder, what));
    auto handle = FileHandle::create(made->path() / nameOfFile, FileHandle::Permissions::UserDefault);
    if (!handle)
        return cannotMake(folder, what, handle.error());
    return std::unique_ptr<TemporaryFile>(new TemporaryFile(std::move(made), std::move(*handle), what));
}

std::filesystem::path TemporaryFile::path() const
{
    return m_folder->path() / nameOfFile;
}

tl::unexpected<Error> TemporaryFile::failure(const std::error_code &reason) const
{
    if (reason == std::errc::file_exists)
        return fail(ErrorCode::AlreadyExists, m_what, isThereAlready(), chooseAnotherNameOrFolder());
    return fail(ErrorCode::Io, m_what, cannotBeWritten(reason.message()), chooseFolderWithSpace());
}

Result<void> TemporaryFile::sync() const
{
    const std::error_code problem = m_handle.sync();
    return problem ? failure(problem) : Result<void>();
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
    std::error_code problem;
    files::rename(path(), target, problem);
    if (problem)
        return failure(problem);
    published(target);
    return {};
}

Result<void> TemporaryFile::publish(const std::filesystem::path &target)
{
    ODO_TRY(sync());
    if (const std::error_code problem = giveFreeName(path(), target))
        return failure(problem);
    published(target);
    return {};
}

Result<std::unique_ptr<TemporaryFolder>> TemporaryFolder::make(const std::filesystem::path &folder,
                                                               const Message &what)
{
    auto made = ODO_TRY(madeIn(folder, what));
    std::unique_ptr<TemporaryFolder> temporary(
        new TemporaryFolder(std::move(made.first), std::move(made.second)));
    if (const std::error_code problem = makeOwnFolder(temporary->path()))
        return cannotMake(folder, what, problem);
    return temporary;
}

TemporaryFolder::~TemporaryFolder()
{
    if (m_handle.isAt(m_outer))
        removeAll(m_outer);
}

namespace {

std::filesystem::path numbered(const std::filesystem::path &folder, const std::string &stem,
                               const std::string &ending, int number)
{
    return folder / (number == 1 ? stem + ending : stem + "_" + std::to_string(number) + ending);
}

} // namespace

ClaimedFile::ClaimedFile(std::filesystem::path path, FileHandle handle, Made made)
    : m_path(std::move(path)), m_handle(std::move(handle)), m_isOurs(made == Made::Here), m_goes(m_isOurs)
{
}

ClaimedFile &ClaimedFile::operator=(ClaimedFile &&other) noexcept
{
    if (this != &other) {
        close();
        m_path = std::move(other.m_path);
        m_handle = std::move(other.m_handle);
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
    if (m_goes && m_handle.isAt(m_path))
        static_cast<void>(removeFile(m_path)); // while it is claimed
    m_handle = {};
}

void ClaimedFile::remove()
{
    m_goes = m_isOurs;
    close();
}

/// A new file of that name; nothing where who removes stray files was faster.
SystemResult<std::optional<ClaimedFile>> ClaimedFile::claim(const std::filesystem::path &path)
{
    auto handle = FileHandle::create(path, FileHandle::Permissions::UserDefault);
    if (!handle)
        return tl::unexpected(handle.error());
    ClaimedFile file(path, std::move(*handle), Made::Here);
    static_cast<void>(file.m_handle.lock(FileHandle::Lock::Exclusive)); // waits for who looks at it
    return file.m_handle.isAt(path) ? std::optional(std::move(file)) : std::nullopt;
}

SystemResult<ClaimedFile> ClaimedFile::create(const std::filesystem::path &folder, const std::string &stem,
                                              const std::string &ending)
{
    for (int number = 1;;) {
        auto file = claim(numbered(folder, stem, ending, number));
        if (file && *file)
            return std::move(**file);
        if (!file && file.error() != std::errc::file_exists)
            return tl::unexpected(file.error());
        number += file ? 0 : 1;
    }
}

SystemResult<ClaimedFile> ClaimedFile::begin(const std::filesystem::path &folder)
{
    for (;;) {
        const auto name = randomLetters(6);
        if (!name)
            return tl::unexpected(name.error());
        auto file = claim(folder / (".new-" + *name + ".part"));
        if (file && *file)
            return std::move(**file);
        if (!file && file.error() != std::errc::file_exists)
            return tl::unexpected(file.error());
    }
}

SystemResult<ClaimedFile> ClaimedFile::hold(const std::filesystem::path &path)
{
    auto handle = FileHandle::openToRead(path, FileHandle::Links::Followed);
    if (!handle)
        return tl::unexpected(handle.error());
    ClaimedFile file(path, std::move(*handle), Made::Before);
    // Some file systems of a network know no locks: there a name is still nobody else's.
    const std::error_code problem = file.m_handle.tryLock(FileHandle::Lock::Shared);
    if (problem == std::errc::operation_would_block)
        return tl::unexpected(problem);
    return file;
}

SystemResult<std::int64_t> ClaimedFile::bytes() const
{
    return m_handle.status().map([](const FileStatus &status) { return status.bytes; });
}

std::error_code ClaimedFile::publish(const std::string &stem, const std::string &ending)
{
    const std::filesystem::path folder = m_path.parent_path();
    for (int number = 1;; ++number) {
        std::filesystem::path path = numbered(folder, stem, ending, number);
        const std::error_code problem = giveFreeName(m_path, path);
        if (problem == std::errc::file_exists)
            continue;
        if (!problem)
            m_path = std::move(path);
        return problem;
    }
}

} // namespace odo
