// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/window_lock.h"

#include "core/base/file_system.h"

#include <QString>
#include <QSysInfo>

namespace odo {

namespace {

std::filesystem::path lockFile(const std::filesystem::path &project)
{
    std::error_code problem;
    std::filesystem::path file = files::realPath(project, problem); // two ways to one file
    if (problem)
        file = project;
    file += ".lock";
    return file;
}

/// "anna on room12-pc3".
std::string holder()
{
    const QString user = qEnvironmentVariable("USER", QStringLiteral("somebody"));
    return QStringLiteral("%1 on %2").arg(user, QSysInfo::machineHostName()).toStdString();
}

} // namespace

Result<std::unique_ptr<WindowLock>> WindowLock::take(const std::filesystem::path &project)
{
    const std::string what = "project '" + project.filename().string() + "'";
    auto file = HeldFile::take(lockFile(project), HeldFile::Afterwards::Goes, holder());
    if (!file)
        return fail(file.error().code, what, file.error().why, file.error().advice);
    if (!*file) {
        const std::string who = HeldFile::wordsOf(lockFile(project));
        return fail(ErrorCode::AlreadyExists, what,
                    "it is open in another window" + (who.empty() ? std::string() : " (" + who + ")"),
                    "close it there first");
    }
    return std::unique_ptr<WindowLock>(new WindowLock(std::move(*file)));
}

} // namespace odo
