// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/media_copy.h"

#include "core/base/file_system.h"
#include "core/exchange/file_name.h"
#include "core/exchange/whole_file.h"
#include "core/project/recording_rows.h"

#include <QCryptographicHash>
#include <QFile>

namespace odo {

namespace {

constexpr qint64 blockBytes = 4 << 20;
constexpr const char *roomAdvice = "check the free space and the rights of the project's folder";

/// Of what files may be called letters and digits of any script, '-' and '_' stay; the rest could mean something to a shell.
QString safeName(const std::string &name)
{
    const QString whole = QString::fromStdString(fileNameOf(name)).left(80);
    QString safe;
    for (const QChar c : whole)
        safe += c.isLetterOrNumber() || c == u'-' || c == u'_' ? c : QChar(u'_');
    return safe;
}

/// Copies block by block, hashing on the way, and gives the hash.
Result<std::string> copyHashed(const std::filesystem::path &source, const std::filesystem::path &target,
                               const std::string &what, const JobControl &control)
{
    const auto problemOf = [&](const QFileDevice &file) {
        return fail(ErrorCode::Io, what, file.errorString().toStdString(), roomAdvice);
    };
    QFile in(QString::fromStdString(source.string()));
    if (!in.open(QIODevice::ReadOnly))
        return problemOf(in);
    WholeFile out(QString::fromStdString(target.string()));
    if (!out.open(QIODevice::WriteOnly))
        return problemOf(out);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    while (!in.atEnd()) {
        if (control.isCancelled())
            return cancelled(what);
        const QByteArray block = in.read(blockBytes);
        if (block.isEmpty() && in.error() != QFileDevice::NoError)
            return problemOf(in);
        hash.addData(block);
        if (out.write(block) != block.size())
            return problemOf(out);
    }
    if (!out.commit())
        return problemOf(out);
    return hash.result().toHex().toStdString();
}

} // namespace

std::filesystem::path freeMediaPath(const std::filesystem::path &folder, const std::string &name,
                                    const std::string &ending, const std::vector<std::filesystem::path> &taken)
{
    const std::string stem = safeName(name).toStdString();
    std::filesystem::path path = folder / (stem + ending);
    for (int number = 2; files::exists(path) || std::ranges::find(taken, path) != taken.end(); ++number)
        path = folder / (stem + "_" + std::to_string(number) + ending);
    return path;
}

Result<MediaCopy> copyIntoMedia(const std::filesystem::path &source, const std::filesystem::path &mediaFolder,
                                const std::string &name, const JobControl &control)
{
    const std::string what = "copy of '" + source.string() + "'";
    std::error_code problem;
    files::makeFolders(mediaFolder, problem);
    if (problem)
        return fail(ErrorCode::Io, what, problem.message(), roomAdvice);
    MediaCopy copy;
    const std::filesystem::path original = files::absolute(source);
    copy.made = !files::isSame(original.parent_path(), mediaFolder);
    copy.file = copy.made ? freeMediaPath(mediaFolder, name, source.extension().string()) : original;
    const auto hash = copy.made ? copyHashed(original, copy.file, what, control) : fileSha256(original, control);
    if (!hash)
        return tl::unexpected(hash.error());
    copy.sha256 = *hash;
    copy.bytes = static_cast<std::int64_t>(files::sizeOf(copy.file, problem));
    return copy;
}

} // namespace odo
