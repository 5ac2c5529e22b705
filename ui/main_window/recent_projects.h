// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>
#include <filesystem>

namespace odo {

/// The projects that were open last, newest first, at most ten; kept in the settings. One that is gone stays
/// in the list (its disk may be unplugged) and is marked by exists().
class RecentProjects : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;
    QStringList files() const;
    void add(const std::filesystem::path &file);
    void clear();
    static bool exists(const QString &file);

Q_SIGNALS:
    void changed();
};

} // namespace odo
