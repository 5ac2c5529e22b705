// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/rescue.h"

#include "core/base/file_system.h"
#include "core/files/output_guard.h"
#include "core/project/project.h"

#include <cstdlib>
#include <vector>

namespace odo {

namespace {

/// The folders to try, in this order.
std::vector<std::filesystem::path> foldersFor(const Project &project)
{
    std::vector<std::filesystem::path> folders;
    const auto add = [&](const std::filesystem::path &folder) {
        if (files::isFolder(folder))
            folders.push_back(folder);
    };
    add(files::absolute(project.file()).parent_path());
    if (const auto now = project.presentPlace())
        add(now->parent_path());
    if (const char *home = std::getenv("HOME"))
        add(home);
    return folders;
}

} // namespace

Result<std::filesystem::path> rescueProject(const Project &project)
{
    constexpr int mostNames = 1000;
    project.emptyLog(); // or whoever opens a file that took this one's place would apply the log to that
    Result<void> done = fail(ErrorCode::NotFound, "project '" + project.file().filename().string() + "'",
                             "its folder is gone, and there is no home folder to rescue it to", "put the file back in its place");
    for (const std::filesystem::path &folder : foldersFor(project)) {
        for (int number = 1; number <= mostNames; ++number) {
            const std::string ending = number == 1 ? " (rescued).odo" : " (rescued " + std::to_string(number) + ").odo";
            const std::filesystem::path file = folder / (project.file().stem().string() + ending);
            done = checkNewProject(file, "project '" + project.file().filename().string() + "'");
            if (done)
                done = project.saveCopy(file);
            if (done)
                return file;
            if (done.error().code != ErrorCode::AlreadyExists)
                break;
        }
    }
    return tl::unexpected(done.error());
}

} // namespace odo
