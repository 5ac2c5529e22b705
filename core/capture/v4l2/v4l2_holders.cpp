// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/v4l2_holders.h"

#include "core/base/file_system.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <system_error>
#include <unistd.h>

namespace odo {

namespace {

/// Links are read, never followed: what lies behind them may hang.
bool holds(const std::filesystem::path &process, const std::filesystem::path &node)
{
    std::error_code problem; // of another user's, or one that has ended: then it is not told
    const std::filesystem::path handles = process / "fd";
    return std::ranges::any_of(files::namesIn(handles, problem), [&](const std::string &name) {
        std::error_code closed;
        return files::linkTarget(handles / name, closed) == node;
    });
}

} // namespace

std::vector<std::string> programsThatHold(const std::filesystem::path &node)
{
    std::error_code problem;
    const std::filesystem::path real = files::realPath(node, problem);
    if (problem)
        return {};
    const std::string own = std::to_string(::getpid());
    std::set<std::string> names;
    for (const std::string &number : files::namesIn("/proc", problem)) {
        const std::filesystem::path process = std::filesystem::path("/proc") / number;
        if (number == own || !std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; }) || !holds(process, real))
            continue;
        std::string name;
        std::ifstream input(process / "comm");
        if (std::getline(input, name) && !name.empty())
            names.insert(name);
    }
    return {names.begin(), names.end()};
}

} // namespace odo
