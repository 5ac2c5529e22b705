// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/write_turn.h"

#include "core/base/file_system.h"

#include <cerrno>
#include <fcntl.h>
#include <map>
#include <sys/file.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

namespace odo {

std::shared_ptr<WriteTurn> WriteTurn::of(const std::filesystem::path &file)
{
    static std::mutex mutex;
    static std::map<std::filesystem::path, std::weak_ptr<WriteTurn>> turns;
    const std::filesystem::path whole = files::realPath(file);
    const std::lock_guard lock(mutex);
    std::erase_if(turns, [](const auto &turn) { return turn.second.expired(); });
    std::weak_ptr<WriteTurn> &known = turns[whole];
    auto turn = known.lock();
    if (!turn)
        known = turn = std::make_shared<WriteTurn>(whole);
    return turn;
}

WriteTurn::WriteTurn(const std::filesystem::path &file)
{
    if (file.has_parent_path()) // a database in memory has no folder
        m_folder = ::open(file.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

WriteTurn::~WriteTurn()
{
    if (m_folder >= 0)
        ::close(m_folder);
}

bool WriteTurn::take(std::chrono::milliseconds patience)
{
    m_mutex.lock();
    return takeFromOthers(patience);
}

/// With the mutex held, which it gives back where it fails.
bool WriteTurn::takeFromOthers(std::chrono::milliseconds patience)
{
    if (m_depth++ > 0 || m_folder < 0)
        return true;
    const auto end = std::chrono::steady_clock::now() + patience;
    for (std::chrono::milliseconds pause{1}; ::flock(m_folder, LOCK_EX | LOCK_NB) != 0;
         pause = std::min(pause * 2, std::chrono::milliseconds(20))) {
        if (errno != EWOULDBLOCK && errno != EINTR)
            return true; // no such locks here
        if (std::chrono::steady_clock::now() >= end) {
            --m_depth;
            m_mutex.unlock();
            return false;
        }
        std::this_thread::sleep_for(pause);
    }
    return true;
}

void WriteTurn::give()
{
    if (--m_depth == 0 && m_folder >= 0)
        ::flock(m_folder, LOCK_UN);
    m_mutex.unlock();
}

HeldTurn::HeldTurn(WriteTurn &turn, std::chrono::milliseconds patience)
    : m_turn(turn.take(patience) ? &turn : nullptr)
{
}

HeldTurn HeldTurn::ifFree(WriteTurn &turn)
{
    HeldTurn held;
    if (turn.m_mutex.try_lock() && turn.takeFromOthers(std::chrono::milliseconds(0)))
        held.m_turn = &turn;
    return held;
}

HeldTurn::HeldTurn(HeldTurn &&other) noexcept : m_turn(std::exchange(other.m_turn, nullptr)) {}

HeldTurn &HeldTurn::operator=(HeldTurn &&other) noexcept
{
    if (this != &other) {
        giveUp();
        m_turn = std::exchange(other.m_turn, nullptr);
    }
    return *this;
}

void HeldTurn::giveUp()
{
    if (WriteTurn *turn = std::exchange(m_turn, nullptr))
        turn->give();
}

} // namespace odo
