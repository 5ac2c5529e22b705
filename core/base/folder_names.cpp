// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/folder_names.h"

#include <cerrno>
#include <dirent.h>
#include <memory>

namespace odo {

namespace {

struct CloseFolder
{
    void operator()(DIR *folder) const { ::closedir(folder); }
};

} // namespace

std::vector<std::string> namesIn(const std::filesystem::path &folder, std::error_code &problem)
{
    std::vector<std::string> names;
    errno = 0; // readdir tells its end from a failure by that alone
    const std::unique_ptr<DIR, CloseFolder> open(::opendir(folder.c_str()));
    while (const dirent *entry = open ? ::readdir(open.get()) : nullptr) {
        const std::string name = entry->d_name;
        if (name != "." && name != "..")
            names.push_back(name);
        errno = 0;
    }
    problem.assign(errno, std::generic_category());
    return names;
}

} // namespace odo
