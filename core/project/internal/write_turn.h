// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>

namespace odo {

/// The turn to write to a project file, held from the beginning of a transaction to its end with whatever
/// SQLite does then: of all connections to a file, of this process and of others, one writes at a time, for
/// before 3.51.3 SQLite can damage a file to whose log two write at once (https://www.sqlite.org/wal.html,
/// "the WAL-reset bug"). Among processes it is a flock(2) on the file's folder, which leaves nothing behind;
/// where the file system knows no such lock, SQLite's own locks remain. May be taken again by the thread that
/// holds it. Any thread.
class WriteTurn
{
public:
    static constexpr std::chrono::milliseconds usualPatience{5000};

    /// One for a file, however its path is written.
    static std::shared_ptr<WriteTurn> of(const std::filesystem::path &file);
    explicit WriteTurn(const std::filesystem::path &file);
    ~WriteTurn();
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
    int m_depth = 0;   ///< of takings, under the mutex
    int m_folder = -1; ///< a descriptor; -1: no lock among processes
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
