// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/cameras.h"

#include "core/exchange/intrinsics_yaml.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

#include <algorithm>

namespace odo {

Result<CameraRecord> findOrAddCamera(Project &project, const std::string &name)
{
    auto found = project.cameras().find(name);
    if (found || found.error().code != ErrorCode::NotFound)
        return found;
    return project.cameras().add({0, name, ""});
}

namespace {

/// The files of a calibration's pictures, one each; those without a picture get none.
Result<std::vector<StoredPicture>> writePictures(CalibrationMedia &media, const std::string &camera,
                                                 const IntrinsicCalibration &calibration,
                                                 const std::vector<BoardPicture> &pictures)
{
    std::vector<StoredPicture> files;
    for (const CalibrationPicture &used : calibration.pictures) {
        const auto picture = std::ranges::find(pictures, used.view.source, &BoardPicture::source);
        files.emplace_back();
        if (picture == pictures.end())
            continue;
        auto written = media.write(camera + "_" + std::filesystem::path(used.view.source).stem().string(), picture->png);
        if (!written)
            return tl::unexpected(written.error());
        files.back() = std::move(*written);
    }
    return files;
}

} // namespace

Result<IntrinsicsRecord> storeCalibration(Project &project, const std::string &camera, const IntrinsicCalibration &calibration,
                                          const BoardSpec &board, const std::vector<BoardPicture> &pictures)
{
    CalibrationMedia media(project.mediaFolder());
    auto files = writePictures(media, camera, calibration, pictures);
    if (!files)
        return tl::unexpected(files.error());
    IntrinsicsRecord record;
    const auto stored = project.inTransaction([&]() -> Result<void> {
        const auto found = findOrAddCamera(project, camera);
        if (!found)
            return tl::unexpected(found.error());
        record.camera = found->id;
        record.made = std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
        record.origin = "calibrated from " + std::to_string(calibration.picturesUsed()) + " pictures";
        record.calibration = calibration;
        record.board = board;
        record.softwareVersion = ODOGRAPH_VERSION;
        record.files = std::move(*files);
        const auto added = project.cameras().addIntrinsics(record);
        if (!added)
            return tl::unexpected(added.error());
        record = *added;
        return {};
    });
    if (!stored)
        return tl::unexpected(stored.error());
    media.keep();
    return record;
}

Result<IntrinsicsRecord> importIntrinsics(Project &project, const std::string &camera,
                                          const std::filesystem::path &file)
{
    auto intrinsics = readIntrinsics(file);
    if (!intrinsics)
        return tl::unexpected(intrinsics.error());
    IntrinsicsRecord record;
    record.made = std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
    record.origin = "imported from " + file.filename().string();
    record.calibration.intrinsics = std::move(*intrinsics);
    const auto stored = project.inTransaction([&]() -> Result<void> {
        const auto found = findOrAddCamera(project, camera);
        if (!found)
            return tl::unexpected(found.error());
        record.camera = found->id;
        auto added = project.cameras().addIntrinsics(record);
        if (!added)
            return tl::unexpected(added.error());
        record = std::move(*added);
        return {};
    });
    if (!stored)
        return tl::unexpected(stored.error());
    return record;
}

Result<void> exportIntrinsics(Project &project, const std::string &camera, const std::filesystem::path &file)
{
    const auto found = project.cameras().find(camera);
    if (!found)
        return tl::unexpected(found.error());
    const auto intrinsics = project.cameras().currentIntrinsics(found->id);
    if (!intrinsics)
        return tl::unexpected(intrinsics.error());
    if (!*intrinsics)
        return fail(ErrorCode::NotFound, "intrinsics of camera '" + camera + "'", "it was never calibrated",
                    "run odograph calibrate, or odograph intrinsics import");
    return writeIntrinsics(file, camera, (*intrinsics)->calibration.intrinsics);
}

Result<std::optional<RecordingRecord>> newestRecording(Project &project, RecordId camera)
{
    const auto trials = project.trials().all();
    if (!trials)
        return tl::unexpected(trials.error());
    for (const TrialRecord &trial : *trials) {
        const auto recordings = project.trials().recordings(trial.id);
        if (!recordings)
            return tl::unexpected(recordings.error());
        for (const RecordingRecord &recording : *recordings) {
            if (recording.camera == camera)
                return recording;
        }
    }
    return std::nullopt;
}

} // namespace odo
