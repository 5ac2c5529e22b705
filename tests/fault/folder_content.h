// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QStringList>
#include <filesystem>

namespace odo::test {

/// What is in a folder, each file by its name from there: of databases their rows, of archives the files in
/// them, of others their bytes' hash. One that cannot be read has "damaged". Locks do not count: they mean
/// nothing once nobody holds them.
using FolderContent = QMap<QString, QStringList>;
FolderContent contentOf(const std::filesystem::path &folder);

/// Whether it is one of the names under which something is in the making.
bool isInTheMaking(const QString &name);

} // namespace odo::test
