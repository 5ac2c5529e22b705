// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/media_copy.h"

#include "core/base/file_system.h"
#include "core/base/sha256.h"
#include "core/exchange/file_name.h"
#include "core/files/file_words.h"
#include "core/files/protected_files.h"
#include "core/files/temporary.h"
#include "core/project/project_media.h"
#include "core/project/project_words.h"
#include "core/project/recording_rows.h"
#include "core/workflow/shared_words.h"

#include <QFile>

namespace odo {

namespace {

constexpr qint64 blockBytes = 1 << 18;
/// How much may wait for the disk: who cancels, and the end, waits for no more.
constexpr qint64 syncEach = 16 << 20;

/// Of what files may be called letters and digits of any script, '-' and '_' stay; the rest could mean
/// something to a shell.
std::string safeName(const std::string &name)
{
    const QString whole = QString::fromStdString(fileNameOf(name)).left(80);
    QString safe;
    for (const QChar c : whole)
        safe += c.isLetterOrNumber() || c == u'-' || c == u'_' ? c : QChar(u'_');
    return safe.toStdString();
}

/// Makes a file in the folder. An import that failed may remove the empty folder at any moment.
template <class Make>
SystemResult<ClaimedFile> inFolder(const std::filesystem::path &folder, const Make &make)
{
    constexpr int mostTries = 20;
    for (int tried = 1;; ++tried) {
        std::error_code problem;
        files::makeFolders(folder, problem);
        if (problem)
            return tl::unexpected(problem);
        auto file = make();
        if (file || file.error() != std::errc::no_such_file_or_directory || tried == mostTries)
            return file;
    }
}

/// Copies block by block, hashing meanwhile, and gives the hash.
Result<std::string> copyHashed(const std::filesystem::path &source, const ClaimedFile &target,
                               const Message &what, const JobControl &control)
{
    ODO_TRY(checkMayBeRead(source, what));
    QFile in(QString::fromStdString(source.string()));
    if (!in.open(QIODevice::ReadOnly))
        return fail(ErrorCode::Io, what, foreignWords(in.errorString().toStdString()), checkProjectFolder());
    Sha256 hash;
    for (qint64 waiting = 0; !in.atEnd();) {
        if (control.isCancelled())
            return cancelled(what);
        const QByteArray block = in.read(blockBytes);
        if (block.isEmpty() && in.error() != QFileDevice::NoError)
            return fail(ErrorCode::Io, what, foreignWords(in.errorString().toStdString()),
                        checkProjectFolder());
        hash.add(block.constData(), static_cast<std::size_t>(block.size()));
        std::error_code problem = target.write({block.constData(), static_cast<std::size_t>(block.size())});
        waiting += block.size();
        if (!problem && waiting >= syncEach) {
            problem = target.sync();
            waiting = 0;
        }
        if (problem)
            return fail(ErrorCode::Io, what, foreignWords(problem.message()), checkProjectFolder());
    }
    return hash.hex();
}

Result<void> published(ClaimedFile &file, const std::string &name, const std::string &ending,
                       const Message &what)
{
    std::error_code problem = file.sync();
    if (!problem)
        problem = file.publish(safeName(name), ending);
    if (problem)
        return fail(ErrorCode::Io, what, foreignWords(problem.message()), checkProjectFolder());
    syncToDisk(file.path().parent_path()); // some file systems cannot: the bytes are safe
    return {};
}

/// One that lies in the media folder.
Result<MediaCopy> held(const std::filesystem::path &file, const Message &what, const JobControl &control)
{
    auto hold = ClaimedFile::hold(file);
    if (!hold && hold.error() == std::errc::resource_unavailable_try_again)
        return fail(ErrorCode::Unavailable, what,
                    ODO_TEXT("workflow.written_just_now", "another program is writing or removing it"),
                    waitUntilThatHasEnded());
    auto hash = ODO_TRY(fileSha256(file, control));
    if (!hold)
        return fail(ErrorCode::Io, what, foreignWords(hold.error().message()), checkFileIsThere());
    return MediaCopy{std::move(*hold), std::move(hash)};
}

Result<MediaCopy> copied(const std::filesystem::path &source, const std::filesystem::path &mediaFolder,
                         const std::string &name, const Message &what, const JobControl &control)
{
    auto file = inFolder(mediaFolder, [&] { return ClaimedFile::begin(mediaFolder); });
    if (!file)
        return fail(ErrorCode::Io, what, foreignWords(file.error().message()), checkProjectFolder());
    auto hash = ODO_TRY(copyHashed(source, *file, what, control));
    ODO_TRY(published(*file, name, source.extension().string(), what));
    return MediaCopy{std::move(*file), std::move(hash)};
}

Result<MediaCopy> withSize(MediaCopy copy, const Message &what)
{
    const auto bytes = copy.file.bytes();
    if (!bytes)
        return cannotBeInspected(what, bytes.error(), checkFileIsThere());
    copy.bytes = *bytes;
    return copy;
}

} // namespace

Result<MediaCopy> makeInMedia(const std::filesystem::path &mediaFolder, const std::string &name,
                              const std::string &ending, const Message &what,
                              const std::function<Result<void>(const std::filesystem::path &claimed)> &make,
                              const JobControl &control)
{
    auto file = inFolder(mediaFolder, [&] { return ClaimedFile::begin(mediaFolder); });
    if (!file)
        return fail(ErrorCode::Io, what, foreignWords(file.error().message()), checkProjectFolder());
    ODO_TRY(make(file->path()));
    auto hash = ODO_TRY(fileSha256(file->path(), control));
    ODO_TRY(published(*file, name, ending, what));
    return withSize(MediaCopy{std::move(*file), std::move(hash)}, what);
}

Result<ClaimedFile> claimMediaFile(const std::filesystem::path &folder, const std::string &name,
                                   const std::string &ending)
{
    auto file = inFolder(folder, [&] { return ClaimedFile::create(folder, safeName(name), ending); });
    if (!file)
        return fail(ErrorCode::Io, cannotWriteFile(folder / (safeName(name) + ending)),
                    foreignWords(file.error().message()), checkProjectFolder());
    return std::move(*file);
}

Result<ClaimedFile> writeMediaFile(const std::filesystem::path &folder, const std::string &name,
                                   const std::string &ending, std::span<const char> content,
                                   const Message &what)
{
    auto file = inFolder(folder, [&] { return ClaimedFile::begin(folder); });
    if (!file)
        return fail(ErrorCode::Io, what, foreignWords(file.error().message()), checkProjectFolder());
    if (const std::error_code problem = file->write(content))
        return fail(ErrorCode::Io, what, foreignWords(problem.message()), checkProjectFolder());
    ODO_TRY(published(*file, name, ending, what));
    return std::move(*file);
}

Result<MediaCopy> copyIntoMedia(const std::filesystem::path &source, const std::filesystem::path &mediaFolder,
                                const std::string &name, const JobControl &control)
{
    const std::filesystem::path original = files::absolute(source);
    const Message what = ODO_TEXT("workflow.copy_of", "copy of '%1'")(Named::file(source));
    const bool isThere =
        files::isSame(original.parent_path(), mediaFolder) || isOwnMedia(original, mediaFolder);
    auto copy =
        ODO_TRY(isThere ? held(original, what, control) : copied(original, mediaFolder, name, what, control));
    return withSize(std::move(copy), what);
}

} // namespace odo
