// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/media_copy.h"

#include <QCryptographicHash>
#include <QFile>
#include <QSaveFile>

namespace odo {

namespace {

constexpr qint64 blockBytes = 4 << 20;

/// Letters and digits of any script, '-', '_' and '.' stay; the rest could mean something to a file system or a shell.
QString safeName(const std::string &name)
{
    QString safe;
    for (const QChar c : QString::fromStdString(name).left(80))
        safe += c.isLetterOrNumber() || c == u'-' || c == u'_' ? c : QChar(u'_');
    return safe;
}

std::filesystem::path unusedPath(const std::filesystem::path &folder, const QString &stem, const std::string &ending)
{
    std::filesystem::path path = folder / (stem.toStdString() + ending);
    for (int number = 2; std::filesystem::exists(path); ++number)
        path = folder / (stem.toStdString() + "_" + std::to_string(number) + ending);
    return path;
}

} // namespace

Result<MediaCopy> copyIntoMedia(const std::filesystem::path &source, const std::filesystem::path &mediaFolder,
                                const std::string &name, const JobControl &control)
{
    const std::string what = "copy of '" + source.string() + "'";
    const auto problemOf = [&](const QString &why) {
        return fail(ErrorCode::Io, what, why.toStdString(), "check the free space and the rights of the project's folder");
    };
    std::error_code problem;
    std::filesystem::create_directories(mediaFolder, problem);
    if (problem)
        return problemOf(QString::fromStdString(problem.message()));
    MediaCopy copy;
    copy.made = !std::filesystem::equivalent(source.parent_path().empty() ? "." : source.parent_path(), mediaFolder, problem);
    copy.file = copy.made ? unusedPath(mediaFolder, safeName(name), source.extension().string())
                          : std::filesystem::absolute(source);

    QFile in(QString::fromStdString(source.string()));
    if (!in.open(QIODevice::ReadOnly))
        return problemOf(in.errorString());
    QSaveFile out(QString::fromStdString(copy.file.string()));
    if (copy.made && !out.open(QIODevice::WriteOnly))
        return problemOf(out.errorString());
    QCryptographicHash hash(QCryptographicHash::Sha256);
    while (!in.atEnd()) {
        if (control.isCancelled())
            return cancelled(what);
        const QByteArray block = in.read(blockBytes);
        if (block.isEmpty() && in.error() != QFileDevice::NoError)
            return problemOf(in.errorString());
        hash.addData(block);
        if (copy.made && out.write(block) != block.size())
            return problemOf(out.errorString());
        copy.bytes += block.size();
    }
    if (copy.made && !out.commit())
        return problemOf(out.errorString());
    copy.sha256 = hash.result().toHex().toStdString();
    return copy;
}

} // namespace odo
