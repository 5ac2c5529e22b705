// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fault/folder_content.h"

#include "core/exchange/project_archive.h"
#include "tests/fault/stored_rows.h"
#include "tests/support/program.h"

#include <QRegularExpression>
#include <QTemporaryDir>

namespace odo::test {

namespace {

QStringList contentOfFile(const std::filesystem::path &file)
{
    const QString name = QString::fromStdString(file.filename().string());
    QStringList damaged(QStringLiteral("damaged"));
    if (name.endsWith(QStringLiteral(".odo")) || name.contains(QStringLiteral(".odo.bak-"))) {
        const QStringList rows = storedRows(file);
        return rows.isEmpty() ? damaged : rows;
    }
    if (name.endsWith(QStringLiteral(".zip"))) {
        const QTemporaryDir place;
        const std::filesystem::path unpacked = std::filesystem::path(place.path().toStdString()) / "unpacked";
        if (!unpackArchive(file, unpacked, {}))
            return damaged;
        QStringList all;
        const FolderContent content = contentOf(unpacked);
        for (auto each = content.begin(); each != content.end(); ++each)
            all << each.key() << each.value();
        return all;
    }
    return {QString::fromLatin1(fileHash(QString::fromStdString(file.string())).toHex())};
}

} // namespace

FolderContent contentOf(const std::filesystem::path &folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto &each : std::filesystem::recursive_directory_iterator(folder)) {
        if (each.is_regular_file())
            files.push_back(each.path());
    }
    FolderContent content;
    for (const std::filesystem::path &file : files) {
        const QString name = QString::fromStdString(file.lexically_relative(folder).string());
        const bool isSideFile = name.endsWith(QStringLiteral("-wal")) ||
                                name.endsWith(QStringLiteral("-shm")) ||
                                name.endsWith(QStringLiteral("-journal")); // goes when its database is read
        if (!isSideFile && !name.endsWith(QStringLiteral(".lock")))
            content.insert(name, contentOfFile(file));
    }
    return content;
}

bool isInTheMaking(const QString &name)
{
    static const QRegularExpression making(QStringLiteral(
        "(^|/)\\.odograph-[a-z2-7]{12}\\.part(/|$)|(^|/)\\.new-[a-z0-9]{6}\\.part$|-wal$|-shm$|-journal$"));
    return making.match(name).hasMatch();
}

} // namespace odo::test
