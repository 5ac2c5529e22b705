// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/recent_projects.h"

#include <QFileInfo>
#include <QSettings>

namespace odo {
namespace {
constexpr int mostFiles = 10;
const QString settingsKey = QStringLiteral("recentProjects");
} // namespace

QStringList RecentProjects::files() const
{
    return QSettings().value(settingsKey).toStringList();
}

void RecentProjects::add(const std::filesystem::path &file)
{
    const QString path = QFileInfo(QString::fromStdString(file.string())).absoluteFilePath();
    QStringList list = files();
    list.removeAll(path);
    list.prepend(path);
    QSettings().setValue(settingsKey, QStringList(list.mid(0, mostFiles)));
    Q_EMIT changed();
}

void RecentProjects::clear()
{
    QSettings().remove(settingsKey);
    Q_EMIT changed();
}

bool RecentProjects::exists(const QString &file)
{
    return QFileInfo::exists(file);
}

} // namespace odo
