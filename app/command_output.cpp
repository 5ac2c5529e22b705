// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_output.h"

#include "core/base/file_system.h"
#include "core/base/platform/file_status.h"
#include "core/files/file_words.h"
#include "core/project/repositories.h"

#include <QFile>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace odo {

Message freeTemporarySpace()
{
    return ODO_TEXT("app.free_temporary_space", "free space in the folder of temporary files");
}

namespace {

tl::unexpected<Error> notPrinted(std::string because, Message advice)
{
    return fail(ErrorCode::Io, ODO_TEXT("app.standard_output", "standard output"),
                cannotBeWritten(std::move(because)), std::move(advice));
}

/// Standard output gets all bytes of the file. Its folder goes first: who reads only the beginning ends this
/// program (SIGPIPE).
Result<void> printFile(const QString &name, QTemporaryDir &folder)
{
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly))
        return notPrinted(file.errorString().toStdString(), freeTemporarySpace());
    folder.remove();
    std::array<char, 1 << 16> block{};
    for (qint64 count = 0; (count = file.read(block.data(), qint64(block.size()))) != 0;) {
        if (count < 0)
            return notPrinted(file.errorString().toStdString(), freeTemporarySpace());
        if (std::fwrite(block.data(), 1, std::size_t(count), stdout) != std::size_t(count))
            return notPrinted(
                std::strerror(errno),
                ODO_TEXT("app.take_all_of_it", "write to a program or a file that can take all of it"));
    }
    return {};
}

} // namespace

Result<void> protectRecordings(const CommandCall &call, Project &project)
{
    const auto recordings = ODO_TRY(project.trials().allRecordings());
    const std::string media = project.mediaFolder().string() + '/'; // where nothing may be written anyway
    for (const RecordingRecord &recording : recordings)
        if (const auto file = project.resolve(recording); !file.string().starts_with(media))
            call.recordings().add(file);
    return {};
}

Result<CommandOutput> CommandOutput::of(const CommandCall &call, const QString &file,
                                        std::optional<FileKind> kind, Project *project,
                                        const QString &printedEnding)
{
    CommandOutput output;
    if (file == standardOutput) {
        if (call.json())
            return call.wrongCall(
                ODO_TEXT("app.output_and_json", "-o - and --json would both write to standard output"));
        output.m_folder = std::make_unique<QTemporaryDir>();
        if (!output.m_folder->isValid())
            return notPrinted(output.m_folder->errorString().toStdString(), freeTemporarySpace());
        output.m_target =
            OutputTarget(output.m_folder->filePath(QStringLiteral("output") + printedEnding).toStdString());
        return output;
    }
    output.m_target = OutputTarget(file.toStdString(), call.isSet(option::force) ? Existing::ReplaceAny
                                                                                 : Existing::ReplaceSameKind);
    if (project && identityOf(output.m_target.file))
        ODO_TRY(protectRecordings(call, *project));
    ODO_TRY(checkOutput(output.m_target, kind));
    return output;
}

Result<void> CommandOutput::finish(const CommandCall &call, const QJsonObject &json,
                                   const QString &text) const
{
    if (isPrinted())
        return printFile(QString::fromStdString(m_target.file.string()), *m_folder);
    call.answer(json, text);
    return {};
}

} // namespace odo
