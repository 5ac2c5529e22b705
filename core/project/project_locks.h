// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/platform/file_handle.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace odo {

/// A file that this object holds as long as it lives, so that others know. The system gives it up when the
/// program ends, however it ends: the file by itself means nothing. Held by a lock (FileHandle), which two
/// objects of one program do not share either.
class HeldFile
{
public:
    /// Whether the file stays when it is given up.
    enum class Afterwards { Stays, Goes };

    /// Makes the file where it is not there. words: what it says to those who find it held, on one line.
    /// nullptr where somebody holds it. Io where it cannot be written to. A file that has another name too,
    /// or holds what no lock does, is somebody's own: it is held, but neither written to nor removed.
    static Result<std::unique_ptr<HeldFile>> take(const std::filesystem::path &file, Afterwards afterwards,
                                                  const std::string &words = {});
    static bool isHeld(const std::filesystem::path &file);
    /// What its holder says; empty where it cannot be read, or is no lock.
    static std::string wordsOf(const std::filesystem::path &file);
    ~HeldFile();
    HeldFile(const HeldFile &) = delete;
    HeldFile &operator=(const HeldFile &) = delete;

private:
    HeldFile(std::filesystem::path file, Afterwards afterwards, FileHandle handle);

    const std::filesystem::path m_file;
    Afterwards m_afterwards;
    const FileHandle m_handle;
};

/// Held by who records into a project, so that no other program takes the trial for one that was cut off:
/// `recording.lock` in the media folder.
class RecordingLock
{
public:
    /// Makes the media folder. AlreadyExists while somebody else holds it; Io where the folder cannot be
    /// written to.
    static Result<std::unique_ptr<RecordingLock>> take(const std::filesystem::path &mediaFolder);
    /// What is held; it means nothing by itself.
    static std::filesystem::path fileIn(const std::filesystem::path &mediaFolder);
    /// Whether somebody, this program too, holds it now.
    static bool isHeld(const std::filesystem::path &mediaFolder);

private:
    explicit RecordingLock(std::unique_ptr<HeldFile> file) : m_file(std::move(file)) {}
    const std::unique_ptr<HeldFile> m_file;
};

/// Held by the window that changes a project, so that a second one shows it for reading only:
/// `<name>.odo.lock` beside the file, gone when the window is. Subcommands do not ask for it: each of their
/// changes is a transaction of its own.
class WindowLock
{
public:
    /// AlreadyExists, with who holds it, while another window does; Io where the folder cannot be written to.
    static Result<std::unique_ptr<WindowLock>> take(const std::filesystem::path &project);

private:
    explicit WindowLock(std::unique_ptr<HeldFile> file) : m_file(std::move(file)) {}
    const std::unique_ptr<HeldFile> m_file;
};

/// The turn to write to a project file, held from the beginning of a transaction to its end with whatever
/// SQLite does then: of all connections to a file, of this process and of others, one writes at a time, for
/// before 3.51.3 SQLite can damage a file to whose log two write at once (https://www.sqlite.org/wal.html,
/// "the WAL-reset bug"). Among processes it is a lock on the file's folder, which leaves nothing behind;
/// where the file system knows no such lock, SQLite's own locks remain. May be taken again by the thread that
/// holds it. Any thread.
class WriteTurn
{
public:
    static constexpr std::chrono::milliseconds usualPatience{5000};

    /// One for a file, however its path is written.
    static std::shared_ptr<WriteTurn> of(const std::filesystem::path &file);
    explicit WriteTurn(const std::filesystem::path &file);
    WriteTurn(const WriteTurn &) = delete;
    WriteTurn &operator=(const WriteTurn &) = delete;

    /// How many changes the connections of this process have stored.
    std::uint64_t changesHere() const { return m_changes; }
    void countChange() { ++m_changes; }

private:
    friend class HeldTurn;
    bool take(std::chrono::milliseconds patience);
    bool takeFromOthers(std::chrono::milliseconds patience);
    void give();

    std::recursive_mutex m_mutex;
    int m_depth = 0;     ///< of takings, under the mutex
    FileHandle m_folder; ///< of nothing: no lock among processes
    std::atomic<std::uint64_t> m_changes = 0;
};

/// Holds a turn as long as it lives. Waits for this process's other threads without an end, for other
/// processes as long as patience.
class HeldTurn
{
public:
    HeldTurn() = default;
    explicit HeldTurn(WriteTurn &turn, std::chrono::milliseconds patience = WriteTurn::usualPatience);
    ~HeldTurn() { giveUp(); }
    /// Without waiting.
    static HeldTurn ifFree(WriteTurn &turn);
    HeldTurn(HeldTurn &&other) noexcept;
    HeldTurn &operator=(HeldTurn &&other) noexcept;

    /// False: another process had it all the time.
    bool isHeld() const { return m_turn != nullptr; }
    void giveUp();

private:
    WriteTurn *m_turn = nullptr;
};

} // namespace odo
