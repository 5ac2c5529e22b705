// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/series_blobs.h"
#include "core/project/internal/trial_document.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/school_documents.h"

namespace odo {

namespace {

tl::unexpected<Error> recordingsAreDamaged(const std::string &field)
{
    return fail(
        ErrorCode::InvalidInput, ODO_TEXT("project.school_recordings", "recordings of a trial from the hub"),
        ODO_TEXT("project.school_recordings_wrong", "their description is damaged: field '%1'")(field),
        publishAgain());
}

DocumentFields fieldsOf(const QByteArray &recordings, std::string &fault)
{
    return DocumentFields(QCborValue::fromCbor(recordings).toMap(), &fault);
}

Result<RecordId> cameraFor(Project &project, const std::string &name)
{
    if (const auto known = project.cameras().find(name))
        return known->id;
    return ODO_TRY(project.cameras().add({0, name, {}})).id;
}

RecordingRecord recordingIn(const DocumentFields &view)
{
    RecordingRecord recording;
    recording.sha256 = view.text("sha256");
    recording.bytes = view.integer("bytes");
    recording.widthPx = int(view.integer("width_px"));
    recording.heightPx = int(view.integer("height_px"));
    recording.orientation = int(view.integer("orientation"));
    recording.framesPerSecond = view.real("frames_per_second");
    recording.syncMethod = view.text("sync_method");
    recording.startOffsetS = view.real("start_offset_s");
    recording.startOffsetSigmaS = view.real("start_offset_sigma_s");
    recording.clockRate = view.real("clock_rate");
    for (const QByteArray &chunk : view.blobs("frame_times", maxBlobRows / rowsPerChunk + 1)) {
        if (recording.frameTimes.size() > maxBlobRows || !unpackTimes(chunk, Message(), recording.frameTimes))
            view.refuse("frame_times");
    }
    return recording;
}

} // namespace

Result<QCborMap> recordingsDocument(Project &project, const TrialRecord &trial)
{
    const auto recordings = ODO_TRY(project.trials().recordings(trial.id));
    QCborArray views;
    for (const RecordingRecord &view : recordings) {
        QCborArray times;
        const std::span<const Nanoseconds> all(view.frameTimes);
        for (std::size_t start = 0; start < all.size(); start += rowsPerChunk)
            times.append(packTimes(all.subspan(start, std::min(rowsPerChunk, all.size() - start))));
        views.append(QCborMap{{QStringLiteral("camera"), documentText(view.cameraName)},
                              {QStringLiteral("file"), documentText(project.resolve(view).string())},
                              {QStringLiteral("sha256"), documentText(view.sha256)},
                              {QStringLiteral("bytes"), qint64(view.bytes)},
                              {QStringLiteral("width_px"), view.widthPx},
                              {QStringLiteral("height_px"), view.heightPx},
                              {QStringLiteral("orientation"), view.orientation},
                              {QStringLiteral("frames_per_second"), view.framesPerSecond},
                              {QStringLiteral("sync_method"), documentText(view.syncMethod)},
                              {QStringLiteral("start_offset_s"), view.startOffsetS},
                              {QStringLiteral("start_offset_sigma_s"), view.startOffsetSigmaS},
                              {QStringLiteral("clock_rate"), view.clockRate},
                              {QStringLiteral("frame_times"), times}});
    }
    if (views.isEmpty())
        return QCborMap();
    return QCborMap{{QStringLiteral("sync_method"), documentText(trial.syncMethod)},
                    {QStringLiteral("sync_offset_s"), trial.syncOffsetS},
                    {QStringLiteral("sync_offset_sigma_s"), trial.syncOffsetSigmaS},
                    {QStringLiteral("sync_rate"), trial.syncRate},
                    {QStringLiteral("sync_rate_sigma"), trial.syncRateSigma},
                    {QStringLiteral("sync_score"), trial.syncScore},
                    {QStringLiteral("views"), views}};
}

Result<std::vector<RecordingElsewhere>> recordingsElsewhere(const QByteArray &recordings)
{
    std::string fault;
    const DocumentFields fields = fieldsOf(recordings, fault);
    std::vector<RecordingElsewhere> elsewhere;
    for (const DocumentFields &view : fields.parts("views", mostViews))
        elsewhere.push_back({view.text("camera"), view.text("sha256"), view.text("file", maxTextLength),
                             view.integer("bytes")});
    if (!fault.empty())
        return recordingsAreDamaged(fault);
    return elsewhere;
}

Result<void> attachRecordings(Project &project, RecordId trial, const QByteArray &recordings,
                              const std::vector<std::filesystem::path> &files)
{
    std::string fault;
    const DocumentFields fields = fieldsOf(recordings, fault);
    return project.inTransaction([&]() -> Result<void> {
        auto record = ODO_TRY(project.trials().get(trial));
        std::vector<RecordingRecord> views;
        for (const DocumentFields &view : fields.parts("views", mostViews)) {
            RecordingRecord recording = recordingIn(view);
            if (!fields.isSound() || views.size() == files.size())
                return recordingsAreDamaged(fault);
            recording.trial = trial;
            recording.camera = ODO_TRY(cameraFor(project, view.text("camera")));
            recording.position = int(views.size());
            recording.path = files[views.size()].string();
            views.push_back(std::move(recording));
        }
        record.syncMethod = fields.text("sync_method");
        record.syncOffsetS = fields.real("sync_offset_s");
        record.syncOffsetSigmaS = fields.real("sync_offset_sigma_s");
        record.syncRate = fields.real("sync_rate");
        record.syncRateSigma = fields.real("sync_rate_sigma");
        record.syncScore = fields.real("sync_score");
        if (!fields.isSound())
            return recordingsAreDamaged(fault);
        return project.school().addRecordings(trial, views, [&]() -> Result<void> {
            const auto stored = ODO_TRY(project.trials().recordings(trial));
            return project.trials().setSync(record, stored);
        });
    });
}

} // namespace odo
