// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/recording_rows.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/base/sha256.h"
#include "core/files/file_words.h"
#include "core/files/protected_files.h"
#include "core/project/internal/analysis_digest.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/series_blobs.h"
#include "core/project/names.h"
#include "core/project/repositories.h"

#include <QFile>
#include <algorithm>

namespace odo {

namespace {

constexpr int largestSidePx = 32'000; // of an image that is read at all
constexpr int lastOrientation = 8;
constexpr const char *mediaEnding = ".media";

const QString recordingColumns = QStringLiteral(
    "SELECT recording.id, trial_id, camera_id, camera.name, position, path, sha256, bytes, width_px, "
    "height_px, frames_per_second, start_offset_s, clock_rate, recording.sync_method, start_offset_sigma_s, "
    "orientation ");

/// The folder of the project, absolute and without "." and "..".
std::filesystem::path projectFolder(const std::filesystem::path &projectFile)
{
    return realProjectFile(projectFile).parent_path();
}

bool isMediaFolder(const std::filesystem::path &name)
{
    return name.extension() == mediaEnding;
}

bool climbsOut(const std::filesystem::path &relative)
{
    return relative.empty() || *relative.begin() == "..";
}

Result<void> addFrameTimes(ProjectConnection &connection, RecordId id, const std::vector<Nanoseconds> &times)
{
    const std::span<const Nanoseconds> all(times);
    for (std::size_t start = 0; start < all.size(); start += rowsPerChunk) {
        const auto chunk = all.subspan(start, std::min(rowsPerChunk, all.size() - start));
        Statement insert(connection, QStringLiteral("INSERT INTO frame_time_chunk VALUES (?,?,?)"));
        insert.bind(id).bind(static_cast<std::int64_t>(start / rowsPerChunk)).bind(packTimes(chunk));
        ODO_TRY(insert.run());
    }
    return {};
}

Result<void> replaceFrameTimes(ProjectConnection &connection, const RecordingRecord &recording)
{
    Statement remove(connection, QStringLiteral("DELETE FROM frame_time_chunk WHERE recording_id=?"));
    ODO_TRY(remove.bind(recording.id).run());
    return addFrameTimes(connection, recording.id, recording.frameTimes);
}

Result<void> readFrameTimes(const ProjectConnection &connection, RecordingRecord &into)
{
    Statement select(
        connection,
        QStringLiteral("SELECT times FROM frame_time_chunk WHERE recording_id=? ORDER BY position"));
    const Message what = ODO_TEXT("project.frame_times_of", "frame times of '%1'")(Named::file(into.path));
    return select.bind(into.id).eachRow([&](const Statement &row) -> Result<void> {
        return unpackTimes(row.blob(0), what, into.frameTimes);
    });
}

RecordingRecord recordingOf(const Statement &row)
{
    RecordingRecord recording;
    recording.id = row.integer(0);
    recording.trial = row.integer(1);
    recording.camera = row.integer(2);
    recording.cameraName = row.name(3);
    recording.position = row.smallInteger(4);
    recording.path = row.text(5);
    recording.sha256 = row.text(6);
    recording.bytes = row.integer(7);
    recording.widthPx = std::clamp(row.smallInteger(8), 0, largestSidePx);
    recording.heightPx = std::clamp(row.smallInteger(9), 0, largestSidePx);
    recording.framesPerSecond = std::clamp(row.real(10), 0.0, highestFrameRate);
    recording.startOffsetS = row.real(11);
    recording.clockRate = row.real(12);
    recording.syncMethod = row.text(13);
    recording.startOffsetSigmaS = row.real(14);
    recording.orientation = std::clamp(row.smallInteger(15), 0, lastOrientation);
    return recording;
}

/// Without their frame times.
Result<std::vector<RecordingRecord>> readRecordings(Statement &select)
{
    std::vector<RecordingRecord> recordings;
    auto read = select.eachRow([&recordings](const Statement &row) -> Result<void> {
        recordings.push_back(recordingOf(row));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return recordings;
}

/// With their frame times.
Result<std::vector<RecordingRecord>> readWhole(const ProjectConnection &connection, Statement &select)
{
    auto recordings = ODO_TRY(readRecordings(select));
    for (RecordingRecord &recording : recordings)
        ODO_TRY(readFrameTimes(connection, recording));
    return recordings;
}

} // namespace

Result<RecordId> addRecording(ProjectConnection &connection, const RecordingRecord &recording)
{
    ODO_TRY(checkText(ODO_TEXT("project.recording_path", "path of a recording"), recording.path));
    if (recording.path.empty())
        return fail(ErrorCode::InvalidInput, ODO_TEXT("project.recording", "recording"),
                    ODO_TEXT("project.recording_without_file", "it has no file"),
                    ODO_TEXT("project.name_video_file", "name the video's file"));
    const std::filesystem::path path(recording.path);
    if (path.is_relative() && climbsOut(path.lexically_normal()))
        return fail(
            ErrorCode::InvalidInput,
            ODO_TEXT("project.recording_at", "recording '%1'")(Named::file(recording.path)),
            ODO_TEXT("project.path_leaves_folder", "its relative path points outside the project's folder"),
            ODO_TEXT("project.copy_file_beside", "copy the file to the project's folder"));
    Statement insert(
        connection,
        QStringLiteral("INSERT INTO recording (trial_id, camera_id, position, path, sha256, bytes, "
                       "width_px, height_px, frames_per_second, start_offset_s, clock_rate, sync_method, "
                       "start_offset_sigma_s, orientation) VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?)"));
    insert.bind(recording.trial).bind(recording.camera).bind(recording.position);
    insert.bind(path.is_absolute() ? storedPath(connection.file(), path) : recording.path);
    insert.bind(recording.sha256).bind(recording.bytes).bind(recording.widthPx).bind(recording.heightPx);
    insert.bind(recording.framesPerSecond).bind(recording.startOffsetS).bind(recording.clockRate);
    insert.bind(recording.syncMethod).bind(recording.startOffsetSigmaS);
    ODO_TRY(insert.bind(recording.orientation).run());
    const RecordId id = insert.insertedId();
    ODO_TRY(addFrameTimes(connection, id, recording.frameTimes));
    return id;
}

Result<void> updateRecording(ProjectConnection &connection, const RecordingRecord &recording)
{
    Statement update(
        connection,
        QStringLiteral("UPDATE recording SET position=?, sha256=?, bytes=?, width_px=?, height_px=?, "
                       "frames_per_second=?, "
                       "start_offset_s=?, clock_rate=?, sync_method=?, start_offset_sigma_s=? WHERE id=?"));
    update.bind(recording.position)
        .bind(recording.sha256)
        .bind(recording.bytes)
        .bind(recording.widthPx)
        .bind(recording.heightPx);
    update.bind(recording.framesPerSecond)
        .bind(recording.startOffsetS)
        .bind(recording.clockRate)
        .bind(recording.syncMethod);
    ODO_TRY(update.bind(recording.startOffsetSigmaS).bind(recording.id).run());
    return replaceFrameTimes(connection, recording);
}

Result<std::vector<RecordingRecord>> recordingsOf(const ProjectConnection &connection, RecordId trial)
{
    Statement select(connection,
                     recordingColumns + QStringLiteral("FROM recording JOIN camera ON camera.id=camera_id "
                                                       "WHERE trial_id=? ORDER BY position LIMIT ?"));
    return readWhole(connection, select.bind(trial).bind(static_cast<std::int64_t>(mostViews)));
}

Result<std::vector<RecordingRecord>> recordingsWithoutTimes(const ProjectConnection &connection)
{
    Statement select(connection,
                     recordingColumns + QStringLiteral("FROM recording JOIN camera ON camera.id=camera_id "
                                                       "ORDER BY trial_id, position"));
    return readRecordings(select);
}

Result<std::optional<RecordingRecord>> newestRecordingOf(const ProjectConnection &connection, RecordId camera)
{
    // Trials come first, by their date: the newest one that has such a recording ends the search.
    Statement select(connection,
                     recordingColumns +
                         QStringLiteral("FROM trial CROSS JOIN recording JOIN camera ON camera.id=camera_id "
                                        "WHERE trial_id=trial.id AND binned_ms IS NULL AND camera_id=? "
                                        "ORDER BY date_ms DESC, trial.id DESC, position LIMIT 1"));
    auto newest = ODO_TRY(readWhole(connection, select.bind(camera)));
    return newest.empty() ? std::nullopt : std::optional(std::move(newest.front()));
}

std::string storedPath(const std::filesystem::path &projectFile, const std::filesystem::path &file)
{
    const std::filesystem::path normal = file.lexically_normal();
    const std::filesystem::path folder = projectFolder(projectFile),
                                relative = normal.lexically_relative(folder);
    if (!climbsOut(relative))
        return relative.generic_string();
    std::error_code problem; // the project may have been opened by another way than the file was named by
    const std::filesystem::path real = files::realPath(normal.parent_path(), problem) / normal.filename(),
                                realRelative = real.lexically_relative(files::realPath(folder, problem));
    return problem || climbsOut(realRelative) ? normal.string() : realRelative.generic_string();
}

std::filesystem::path realProjectFile(const std::filesystem::path &projectFile)
{
    if (files::kindOfItself(projectFile) == files::Kind::Link)
        return files::realPath(projectFile);
    return files::absolute(projectFile).lexically_normal();
}

std::filesystem::path mediaFolderOf(const std::filesystem::path &projectFile)
{
    return realProjectFile(projectFile).replace_extension(mediaEnding);
}

std::filesystem::path absolutePath(const std::filesystem::path &projectFile, const std::string &path)
{
    std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
    if (normal.is_absolute())
        return normal;
    if (climbsOut(normal))
        return projectFolder(projectFile) / normal.filename();
    const std::filesystem::path stored = projectFolder(projectFile) / normal;
    const std::filesystem::path media = mediaFolderOf(projectFile), first = *normal.begin();
    if (!isMediaFolder(first) || first == media.filename())
        return stored;
    // The project may have been called otherwise when the file came into its media folder.
    const std::filesystem::path today = media / normal.lexically_relative(first);
    return !files::exists(stored) && files::exists(today) ? today : stored;
}

Result<std::string> fileSha256(const std::filesystem::path &file, const JobControl &control)
{
    const Message what = quotedFileSubject(file);
    ODO_TRY(checkMayBeRead(file, what));
    QFile input(QString::fromStdString(file.string()));
    if (!input.open(QIODevice::ReadOnly))
        return fail(ErrorCode::Io, what, cannotBeRead(input.errorString().toStdString()), checkFileIsThere());
    Sha256 hash;
    QByteArray block(1 << 20, Qt::Uninitialized);
    for (;;) {
        if (control.isCancelled())
            return cancelled(what);
        const qint64 count = input.read(block.data(), block.size());
        if (count < 0)
            return fail(ErrorCode::Io, what,
                        ODO_TEXT("project.reading_failed",
                                 "reading it failed (%1)")(foreignWords(input.errorString().toStdString())),
                        ODO_TEXT("project.check_disk", "check the disk"));
        if (count == 0)
            break;
        hash.add(block.constData(), static_cast<std::size_t>(count));
    }
    return hash.hex();
}

// TrialRepository's part of trials that are being recorded.

namespace {

Result<void> removeRecording(ProjectConnection &connection, RecordId id)
{
    for (const char *sql :
         {"DELETE FROM raw_time_chunk WHERE recording_id=?",
          "DELETE FROM frame_time_chunk WHERE recording_id=?", "DELETE FROM recording WHERE id=?"}) {
        ODO_TRY(runFor(connection, sql, id));
    }
    return {};
}

Result<void> updateTrial(ProjectConnection &connection, const TrialRecord &trial)
{
    Statement update(
        connection,
        QStringLiteral(
            "UPDATE trial SET sync_method=?, sync_offset_s=?, sync_offset_sigma_s=?, sync_score=?, "
            "duration_s=?, state='complete' WHERE id=?"));
    update.bind(trial.syncMethod).bind(trial.syncOffsetS).bind(trial.syncOffsetSigmaS).bind(trial.syncScore);
    return update.bind(trial.durationS).bind(trial.id).run();
}

} // namespace

Result<TrialRecord> TrialRepository::begin(const TrialRecord &trial,
                                           const std::vector<RecordingRecord> &recordings)
{
    return transact(m_connection, [&]() -> Result<TrialRecord> {
        auto added = ODO_TRY(add(trial, recordings));
        Statement update(m_connection, QStringLiteral("UPDATE trial SET state='recording' WHERE id=?"));
        ODO_TRY(update.bind(added.id).run());
        return get(added.id);
    });
}

Result<void> TrialRepository::appendRawTimes(RecordId recording, const RecordedTimes &times)
{
    if (times.frames.empty() && times.readings.empty())
        return {};
    Statement insert(
        m_connection,
        QStringLiteral(
            "INSERT INTO raw_time_chunk SELECT ?, COUNT(*), ?, ? FROM raw_time_chunk WHERE recording_id=?"));
    insert.bind(recording).bind(packRawTimes(times.frames)).bind(packClockReadings(times.readings));
    return insert.bind(recording).run();
}

Result<RecordedTimes> TrialRepository::rawTimes(RecordId recording) const
{
    RecordedTimes times;
    const Message what = ODO_TEXT("project.raw_times_of", "raw times of recording %1")(recording);
    Statement select(
        m_connection,
        QStringLiteral(
            "SELECT pictures, readings FROM raw_time_chunk WHERE recording_id=? ORDER BY position"));
    auto read = select.bind(recording).eachRow([&](const Statement &row) -> Result<void> {
        ODO_TRY(unpackRawTimes(row.blob(0), what, times.frames));
        return unpackClockReadings(row.blob(1), what, times.readings);
    });
    if (!read)
        return tl::unexpected(read.error());
    return times;
}

Result<void> TrialRepository::setDuration(RecordId trial, double durationS)
{
    Statement update(m_connection, QStringLiteral("UPDATE trial SET duration_s=? WHERE id=?"));
    return update.bind(durationS).bind(trial).run();
}

Result<void> TrialRepository::complete(const TrialRecord &trial,
                                       const std::vector<RecordingRecord> &recordings)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto before = ODO_TRY(get(trial.id));
        if (!before.unfinished)
            return fail(ErrorCode::InvalidInput, trialSubject(before.name),
                        ODO_TEXT("project.recording_ended", "its recording has ended already"),
                        ODO_TEXT("project.record_another", "record another trial"));
        const auto begun = ODO_TRY(this->recordings(trial.id));
        for (const RecordingRecord &recording : begun) {
            if (std::ranges::find(recordings, recording.id, &RecordingRecord::id) != recordings.end())
                continue;
            ODO_TRY(removeRecording(m_connection, recording.id));
        }
        for (const RecordingRecord &recording : recordings)
            ODO_TRY(updateRecording(m_connection, recording));
        return updateTrial(m_connection, trial);
    });
}

Result<std::vector<RecordingRecord>> TrialRepository::unhashed() const
{
    std::vector<RecordingRecord> recordings;
    Statement select(
        m_connection,
        QStringLiteral("SELECT recording.id, trial_id, path, bytes FROM recording JOIN trial ON "
                       "trial.id=trial_id WHERE sha256='' AND state='complete' ORDER BY recording.id"));
    auto read = select.eachRow([&](const Statement &row) -> Result<void> {
        RecordingRecord recording;
        recording.id = row.integer(0);
        recording.trial = row.integer(1);
        recording.path = row.text(2);
        recording.bytes = row.integer(3);
        recordings.push_back(std::move(recording));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return recordings;
}

Result<void> TrialRepository::setHash(RecordId recording, const std::string &sha256)
{
    return setRecordingHash(m_connection, recording, sha256);
}

Result<void> TrialRepository::setFrameTimes(const std::vector<RecordingRecord> &recordings)
{
    return transact(m_connection, [&]() -> Result<void> {
        for (const RecordingRecord &recording : recordings) {
            ODO_TRY(replaceFrameTimes(m_connection, recording));
            if (recording.position == 0 && !recording.frameTimes.empty())
                ODO_TRY(setDuration(recording.trial, toSeconds(recording.frameTimes.back())));
        }
        return {};
    });
}

Result<void> TrialRepository::removeUnfinished(RecordId trial)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = ODO_TRY(get(trial));
        if (!known.unfinished)
            return fail(ErrorCode::InvalidInput, trialSubject(known.name),
                        ODO_TEXT("project.recording_kept", "its recording has ended, and is kept"),
                        ODO_TEXT("project.leave_it", "leave it"));
        const auto recordings = ODO_TRY(this->recordings(trial));
        for (const RecordingRecord &recording : recordings)
            ODO_TRY(removeRecording(m_connection, recording.id));
        ODO_TRY(runFor(m_connection, "DELETE FROM trial_robot WHERE trial_id=?", trial));
        return runFor(m_connection, "DELETE FROM trial WHERE id=?", trial);
    });
}

} // namespace odo
