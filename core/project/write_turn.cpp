// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/write_turn.h"

#include "core/base/file_system.h"

#include <map>
#include <system_error>

namespace odo {

std::shared_ptr<std::recursive_mutex> writeTurnOf(const std::filesystem::path &file)
{
    static std::mutex mutex;
    static std::map<std::filesystem::path, std::weak_ptr<std::recursive_mutex>> turns;
    const std::filesystem::path whole = files::realPath(file);
    const std::lock_guard lock(mutex);
    std::erase_if(turns, [](const auto &turn) { return turn.second.expired(); });
    std::weak_ptr<std::recursive_mutex> &known = turns[whole];
    auto turn = known.lock();
    if (!turn)
        known = turn = std::make_shared<std::recursive_mutex>();
    return turn;
}

} // namespace odo
