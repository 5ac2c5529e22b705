// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/school/internal/school_media.h"

#include "core/base/file_system.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/media_copy.h"

#include <QString>
#include <algorithm>

namespace odo {

namespace {

bool isHash(const std::string &text)
{
    return text.size() == 64 &&
           std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

std::filesystem::path drawerOf(const std::filesystem::path &folder, const std::string &sha256)
{
    return folder / sha256.substr(0, 2);
}

Message isOther(const std::filesystem::path &file)
{
    return ODO_TEXT("school.recording_changed",
                    "the recording '%1' is missing or has changed, and was left out")(
        Named::file(file.filename()));
}

/// Copies a file into a folder; nothing where its content is not the one that is wanted.
Result<std::optional<MediaCopy>> verifiedCopy(const std::filesystem::path &source, const std::string &sha256,
                                              const std::filesystem::path &folder, const std::string &name,
                                              const JobControl &control)
{
    auto copy = copyIntoMedia(source, folder, name, control);
    if (!copy && copy.error().code == ErrorCode::NotFound)
        return std::nullopt;
    if (!copy)
        return tl::unexpected(copy.error());
    if (copy->sha256 != sha256)
        return std::nullopt; // and the copy goes
    return std::move(*copy);
}

} // namespace

std::filesystem::path mediaFileOf(const std::filesystem::path &folder, const std::string &sha256)
{
    if (!isHash(sha256))
        return {};
    std::error_code problem; // there is none of that name where it cannot be read
    for (const std::string &name : files::namesIn(drawerOf(folder, sha256), problem)) {
        if (name.starts_with(sha256) && name.find(".part") == std::string::npos)
            return drawerOf(folder, sha256) / name;
    }
    return {};
}

Result<void> publishRecordings(Project &project, const std::filesystem::path &folder,
                               const JobControl &control, SchoolReport &report)
{
    const auto recordings = ODO_TRY(project.trials().allRecordings());
    double done = 0;
    for (const RecordingRecord &recording : recordings) {
        if (control.isCancelled())
            return cancelled(fileSubject(folder));
        const double from = done++ / double(recordings.size());
        if (!isHash(recording.sha256) || !mediaFileOf(folder, recording.sha256).empty())
            continue;
        const std::filesystem::path file = project.resolve(recording);
        auto copy = ODO_TRY(verifiedCopy(file, recording.sha256, drawerOf(folder, recording.sha256),
                                         recording.sha256 + file.extension().string(),
                                         partOf(control, from, done / double(recordings.size()))));
        if (!copy) {
            report.warnings.push_back(isOther(file));
            continue;
        }
        copy->file.keep();
        report.mediaBytes += copy->bytes;
    }
    return {};
}

Result<void> pullRecordings(Project &project, RecordId trial, const QByteArray &recordings,
                            const std::string &owner, const std::filesystem::path &folder,
                            const JobControl &control, SchoolReport &report)
{
    const auto wanted = recordingsElsewhere(recordings);
    if (!wanted) {
        report.warnings.push_back(wholeMessage(wanted.error()));
        return {};
    }
    const auto record = ODO_TRY(project.trials().get(trial));
    std::vector<MediaCopy> copies;
    std::vector<std::filesystem::path> files;
    for (const RecordingElsewhere &one : *wanted) {
        const std::filesystem::path source = mediaFileOf(folder, one.sha256);
        std::optional<MediaCopy> copy;
        if (!source.empty())
            copy = ODO_TRY(verifiedCopy(source, one.sha256, project.mediaFolder(),
                                        record.name + "_" + one.camera, control));
        if (!copy) {
            report.warnings.push_back(ODO_TEXT(
                "school.recording_elsewhere",
                "trial '%1', view '%2': its recording is not in the media folder; bench '%3' has it as '%4'")(
                Named::trial(record.name), Named::camera(one.camera), owner, Named::file(one.file)));
            return {};
        }
        report.mediaBytes += copy->bytes;
        files.push_back(copy->file.path());
        copies.push_back(std::move(*copy));
    }
    const auto attached = attachRecordings(project, trial, recordings, files);
    if (!attached && attached.error().code != ErrorCode::InvalidInput)
        return attached;
    if (!attached) {
        report.warnings.push_back(wholeMessage(attached.error()));
        return {};
    }
    for (MediaCopy &copy : copies)
        copy.file.keep();
    return {};
}

} // namespace odo
