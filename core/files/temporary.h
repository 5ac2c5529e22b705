// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/platform/file_handle.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>

namespace odo {

/// What is being written lies in a folder with a name that nobody can foresee, ".odograph-XXXXXXXXXXXX.part",
/// and gets its own name when it is whole. Such folders that a killed program has left are removed when the
/// next one is made beside them: as long as somebody writes to one, it is locked. A file in it with
/// the folder's name shows that it was made here: without that mark it is somebody's own, and stays. Any
/// thread, one at a time.

/// A new folder for what takes several files to make, or is opened by others; removed with all that is in it.
class TemporaryFolder
{
public:
    /// Only this user may read it. Errors as of TemporaryFile.
    static Result<std::unique_ptr<TemporaryFolder>> make(const std::filesystem::path &folder,
                                                         const Message &what);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &operator=(const TemporaryFolder &) = delete;

    /// May be renamed and moved.
    std::filesystem::path path() const { return m_outer / "new"; }

private:
    TemporaryFolder(std::filesystem::path outer, FileHandle handle)
        : m_outer(std::move(outer)), m_handle(std::move(handle))
    {
    }

    /// the lock is on it, and not on the folder within: a project made there locks its folder itself
    const std::filesystem::path m_outer;
    const FileHandle m_handle;
};

/// A new file in the making, in a temporary folder of its own, removed unless it was published.
class TemporaryFile
{
public:
    /// what: for messages. Errors: NotFound (no such folder), Io (the disk is full), ReadOnly (the folder
    /// cannot be written to).
    static Result<std::unique_ptr<TemporaryFile>> make(const std::filesystem::path &folder,
                                                       const Message &what);
    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    const FileHandle &handle() const { return m_handle; } ///< to write to
    std::filesystem::path path() const;                   ///< until it is published
    /// Has all bytes on the disk, then the file under that name, in the folder around, in place of what was
    /// there.
    Result<void> replace(const std::filesystem::path &target);
    /// Likewise, but AlreadyExists where anything has that name.
    Result<void> publish(const std::filesystem::path &target);

private:
    TemporaryFile(std::unique_ptr<TemporaryFolder> folder, FileHandle handle, Message what);
    tl::unexpected<Error> failure(const std::error_code &reason) const;
    Result<void> sync() const;
    void published(const std::filesystem::path &target);

    std::unique_ptr<TemporaryFolder> m_folder;
    const FileHandle m_handle;
    const Message m_what;
};

/// Whether something is called as those folders are.
bool isTemporaryName(const std::filesystem::path &name);

/// A file that nobody else works on: a new one under a name that no file had, or one that is there and is not
/// to go away meanwhile. A name is claimed by giving it to a file, which fails where another one has it,
/// never by asking whether it is free: two programs never get the same. A claim is a lock that
/// ends with this object or its program, however that ends (HeldFile::isHeld reports it). A new file is
/// removed by the destructor unless it is kept: that file, and never another one under its name. Not through
/// links. One thread.
class ClaimedFile
{
public:
    /// A new empty file: STEM + ENDING, STEM_2 + ENDING ..., the first that nobody has, however the file
    /// system compares names.
    static SystemResult<ClaimedFile> create(const std::filesystem::path &folder, const std::string &stem,
                                            const std::string &ending);
    /// A new empty file under a name that nobody can foresee and that says that it is in the making
    /// (".new-XXXXXX.part"); publish() gives it its own.
    static SystemResult<ClaimedFile> begin(const std::filesystem::path &folder);
    /// One that is there. Several may hold it, and none may remove it.
    /// std::errc::resource_unavailable_try_again where somebody writes or removes it.
    static SystemResult<ClaimedFile> hold(const std::filesystem::path &file);

    ClaimedFile() = default; ///< of nothing
    ~ClaimedFile();
    ClaimedFile(ClaimedFile &&other) noexcept = default;
    ClaimedFile &operator=(ClaimedFile &&other) noexcept;

    const std::filesystem::path &path() const { return m_path; }
    /// How many it has, whatever it is called by now.
    SystemResult<std::int64_t> bytes() const;
    /// All of it, behind what was written before.
    std::error_code write(std::span<const char> bytes) const { return m_handle.write(bytes); }
    /// All that was written is on the disk.
    std::error_code sync() const { return m_handle.sync(); }
    /// Of one that was started: from now on it has a name as those of create().
    std::error_code publish(const std::string &stem, const std::string &ending);
    /// The destructor leaves it. It stays claimed.
    void keep() { m_goes = false; }
    /// Now, though it was kept. Of one that was held: only the claim ends.
    void remove();

private:
    enum class Made { Here, Before };
    ClaimedFile(std::filesystem::path path, FileHandle handle, Made made);
    static SystemResult<std::optional<ClaimedFile>> claim(const std::filesystem::path &path);
    void close();

    std::filesystem::path m_path;
    FileHandle m_handle;
    bool m_isOurs = false, m_goes = false;
};

} // namespace odo
