// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/v4l2_holders.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <system_error>
#include <unistd.h>

namespace odo {

namespace {

namespace fs = std::filesystem;

/// Links are read, never followed: what lies behind them may hang.
bool holds(const fs::path &process, const fs::path &node)
{
    std::error_code problem; // of another user's, or one that has ended: then it is not told
    for (fs::directory_iterator each(process / "fd", problem), end; !problem && each != end; each.increment(problem)) {
        std::error_code ignored;
        if (fs::read_symlink(each->path(), ignored) == node)
            return true;
    }
    return false;
}

} // namespace

std::vector<std::string> programsThatHold(const fs::path &node)
{
    std::error_code problem;
    const fs::path real = fs::canonical(node, problem);
    if (problem)
        return {};
    const std::string own = std::to_string(::getpid());
    std::set<std::string> names;
    for (fs::directory_iterator each("/proc", problem), end; !problem && each != end; each.increment(problem)) {
        const std::string number = each->path().filename().string();
        if (number == own || !std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; }) || !holds(each->path(), real))
            continue;
        std::string name;
        std::ifstream input(each->path() / "comm");
        if (std::getline(input, name) && !name.empty())
            names.insert(name);
    }
    return {names.begin(), names.end()};
}

} // namespace odo
