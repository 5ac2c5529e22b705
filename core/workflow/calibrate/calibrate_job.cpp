// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/calibrate_job.h"

#include "core/base/error.h"
#include "core/calibration/intrinsic_calibration.h"
#include "core/calibration/repeated_views.h"
#include "core/files/protected_files.h"
#include "core/project/project.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/video/image.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/calibrate/cameras.h"

#include <algorithm>

namespace odo {

Message calibrationOf(const std::string &camera)
{
    return ODO_TEXT("workflow.calibration_of_camera", "calibration of camera '%1'")(Named::camera(camera));
}

CalibrationStorage::CalibrationStorage(const std::filesystem::path &mediaFolder, std::string camera,
                                       IntrinsicCalibration calibration, const BoardSpec &board)
    : m_media(mediaFolder), m_camera(std::move(camera))
{
    m_record.origin =
        ODO_TEXT("workflow.calibrated_from_pictures", "calibrated from %1 images")(calibration.imagesUsed());
    m_record.calibration = std::move(calibration);
    m_record.board = board;
    m_record.softwareVersion = ODOGRAPH_VERSION;
}

Result<void> CalibrationStorage::writeImages(const std::vector<BoardImage> &images, const JobControl &control)
{
    const auto &used = m_record.calibration.images;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (control.isCancelled())
            return cancelled(calibrationOf(m_camera));
        control.report(double(i) / double(used.size()),
                       ODO_TEXT("workflow.keeping_pictures", "saving the images"));
        const auto image = std::ranges::find(images, used[i].view.source, &BoardImage::source);
        m_record.files.emplace_back(); // those without an image have none
        if (image == images.end())
            continue;
        const std::string name = m_camera + "_" + std::filesystem::path(used[i].view.source).stem().string();
        m_record.files.back() = ODO_TRY(m_media.write(name, image->png));
    }
    return {};
}

Result<IntrinsicsRecord> CalibrationStorage::commit(Project &project)
{
    const auto stored =
        project.note(ODO_TEXT("workflow.calibrate_camera", "calibrate camera %1")(Named::camera(m_camera)),
                     [&]() -> Result<void> {
                         const auto camera = ODO_TRY(findOrAddCamera(project, m_camera));
                         m_record.camera = camera.id;
                         m_record.made = instantNow();
                         m_record = ODO_TRY(project.cameras().addIntrinsics(m_record));
                         return {};
                     });
    if (!stored)
        return tl::unexpected(stored.error());
    m_media.keep();
    return m_record;
}

namespace {

// A hand-held board moves little between neighbouring frames: they would only repeat one position.
constexpr int boardVideoStep = 15;
constexpr std::size_t enoughVideoPositions = 60;

} // namespace

CalibrateJob::CalibrateJob(CalibrateSettings settings) : m_settings(std::move(settings)) {}

Result<void> CalibrateJob::prepare(Project &project)
{
    m_mediaFolder = project.mediaFolder();
    for (const auto &file : m_settings.files)
        ODO_TRY(checkMayBeRead(file, quotedName(Named::file(file))));
    return {};
}

Result<void> CalibrateJob::run(const JobControl &control)
{
    for (std::size_t i = 0; i < m_settings.files.size(); ++i) {
        control.report(0.8 * double(i) / double(m_settings.files.size()),
                       ODO_TEXT("workflow.looking_for_board_in",
                                "detecting the board in %1")(Named::file(m_settings.files[i].filename())));
        ODO_TRY(searchFile(m_settings.files[i], control));
    }
    if (m_views.empty()) {
        const Message why = m_rejected.empty()
                                ? Message(ODO_TEXT("workflow.no_picture_read", "no image could be read"))
                                : m_rejected.front().reason;
        return fail(
            ErrorCode::Undetermined, calibrationOf(m_settings.camera),
            ODO_TEXT("workflow.board_in_no_picture",
                     "the board was found in none of %1 images (%2)")(m_rejected.size(), why),
            ODO_TEXT("workflow.show_whole_board",
                     "show the whole board, flat, sharp and evenly lit, and check --pattern and --board"));
    }
    control.report(0.85, ODO_TEXT("workflow.computing_intrinsics", "computing the intrinsics"));
    auto calibration = calibrateIntrinsics(m_views, m_widthPx, m_heightPx, m_settings.model, control);
    if (!calibration) {
        Error error = calibration.error();
        error.what = calibrationOf(m_settings.camera);
        return tl::unexpected(error);
    }
    m_calibration = std::move(*calibration);
    m_calibration.rejected.insert(m_calibration.rejected.begin(), m_rejected.begin(), m_rejected.end());
    m_storage = std::make_unique<CalibrationStorage>(m_mediaFolder, m_settings.camera, m_calibration,
                                                     m_settings.board);
    auto written = m_storage->writeImages(m_images, control);
    if (!written)
        m_storage.reset();
    return written;
}

Result<void> CalibrateJob::searchFile(const std::filesystem::path &file, const JobControl &control)
{
    const auto visited = visitImages(
        file, boardVideoStep,
        [&](const Frame &frame, const std::string &name) {
            searchImage(frame, name);
            return !control.isCancelled() &&
                   m_positions.size() < enoughVideoPositions + m_settings.files.size();
        },
        control.cancel);
    if (control.isCancelled())
        return cancelled(calibrationOf(m_settings.camera));
    // One unreadable image among many is refused like one without a board; it must not cost the others.
    if (!visited)
        m_rejected.push_back({file.filename().string(), visited.error().why});
    return {};
}

void CalibrateJob::searchImage(const Frame &frame, const std::string &name)
{
    if (m_widthPx == 0) {
        m_widthPx = frame.format.width;
        m_heightPx = frame.format.height;
    }
    if (frame.format.width != m_widthPx || frame.format.height != m_heightPx) {
        m_rejected.push_back({name, otherSizeThanFirst(frame.format, m_widthPx, m_heightPx)});
        return;
    }
    auto view = findBoard(frame, m_settings.board, name);
    if (!view) {
        m_rejected.push_back({name, view.error().why});
        return;
    }
    // What the first board turned out to be holds for the rest: it is one board, and a known size is found
    // faster.
    m_settings.board.pattern = view->pattern;
    m_settings.board.columns = view->columns;
    m_settings.board.rows = view->rows;
    const bool isNew = std::ranges::none_of(
        m_positions, [&](std::size_t before) { return repeatsPosition(*view, m_views[before]); });
    m_views.push_back(std::move(*view));
    if (!isNew)
        return;
    m_positions.push_back(m_views.size() - 1);
    if (auto png = greyPng(frame))
        m_images.push_back({name, std::move(*png)});
}

Result<void> CalibrateJob::commit(Project &project)
{
    const auto stored = m_storage->commit(project);
    m_storage.reset(); // if it was not stored, its images go
    if (!stored)
        return tl::unexpected(stored.error());
    return {};
}

} // namespace odo
