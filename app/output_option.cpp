// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output_option.h"

#include "app/command_call.h"
#include "app/option_names.h"
#include "core/project/repositories.h"

namespace odo {

namespace {

/// Protects the recordings that are not in the media folder, where nothing may be written anyway.
Result<void> protectRecordings(Project &project, InputFiles &files)
{
    const auto recordings = project.trials().allRecordings();
    if (!recordings)
        return tl::unexpected(recordings.error());
    const std::string media = project.mediaFolder().string() + '/';
    for (const RecordingRecord &recording : *recordings)
        if (const auto file = project.resolve(recording); !file.string().starts_with(media))
            files.add(file);
    return {};
}

} // namespace

QCommandLineOption forceOption()
{
    return {option::force, QStringLiteral("Replace a file of another kind, too.")};
}

QList<QCommandLineOption> outputOptions(const QString &description)
{
    return {{{QStringLiteral("o"), option::output}, description, QStringLiteral("FILE")}, forceOption()};
}

Result<OutputTarget> outputOf(const CommandCall &call, const std::string &file, std::optional<FileKind> kind, Project *project)
{
    const OutputTarget target(file, call.isSet(option::force) ? Existing::ReplaceAny : Existing::ReplaceSameKind);
    if (project && identityOf(target.file))
        if (auto done = protectRecordings(*project, call.recordings()); !done)
            return tl::unexpected(done.error());
    return checkOutput(target, kind).map([&](const OutputPlace &) { return target; });
}

} // namespace odo
