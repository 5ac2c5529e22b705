// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/calibrate_pair_job.h"

#include "core/base/units.h"
#include "core/files/protected_files.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/video/image.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/register_job.h"

#include <algorithm>

namespace odo {

namespace {

constexpr double searchShare = 0.8; // of the progress

Message pairOf(const CalibratePairSettings &settings)
{
    return ODO_TEXT("workflow.pair_of_cameras", "the relative position of cameras '%1' and '%2'")(
        Named::camera(settings.cameras[0]), Named::camera(settings.cameras[1]));
}

} // namespace

CalibratePairJob::CalibratePairJob(CalibratePairSettings settings) : m_settings(std::move(settings)) {}

Result<void> CalibratePairJob::prepare(Project &project)
{
    if (m_settings.cameras[0] == m_settings.cameras[1])
        return fail(ErrorCode::InvalidInput, pairOf(m_settings),
                    ODO_TEXT("workflow.pair_of_one_camera", "both are the same camera"),
                    ODO_TEXT("workflow.name_two_cameras", "name two cameras"));
    m_mediaFolder = project.mediaFolder();
    for (const auto &files : m_settings.files)
        for (const auto &file : files)
            ODO_TRY(checkMayBeRead(file, quotedName(Named::file(file))));
    m_files = ODO_TRY(pairFiles(m_settings.files[0], m_settings.files[1]));
    const auto cameras = ODO_TRY(project.cameras().all());
    for (const CameraRecord &camera : cameras) {
        for (std::size_t side = 0; side < 2; ++side) {
            if (camera.name != m_settings.cameras[side])
                continue;
            if (auto intrinsics = ODO_TRY(project.cameras().currentIntrinsics(camera.id))) {
                m_sides[side].stored = std::move(intrinsics->calibration.intrinsics);
                m_sides[side].intrinsics = intrinsics->id;
            }
            ODO_TRY(readRegistration(project, camera.id, side));
        }
    }
    if (m_sides[0].registration && m_sides[1].registration) {
        const RecordId layouts[] = {m_sides[0].registration->layout, m_sides[1].registration->layout};
        m_haveCommonAxes = layouts[0] == layouts[1];
        for (std::size_t side = 0; side < 2 && !m_haveCommonAxes; ++side) {
            const auto layout = ODO_TRY(project.layouts().get(layouts[side]));
            m_haveCommonAxes = isLayoutOfReference(layout.layout.name, m_settings.cameras[1 - side]);
        }
    }
    return {};
}

Result<void> CalibratePairJob::readRegistration(Project &project, RecordId camera, std::size_t index)
{
    Side &side = m_sides[index];
    side.registration = ODO_TRY(project.cameras().currentRegistration(camera));
    if (!side.registration || side.registration->intrinsics == 0)
        return {};
    auto stored = ODO_TRY(project.cameras().intrinsics(side.registration->intrinsics));
    const auto lens = ODO_TRY(CameraModel::create(std::move(stored.calibration.intrinsics)));
    side.pose = poseOnFloor(side.registration->registration, lens, side.registration->pixels);
    return {};
}

Result<void> CalibratePairJob::run(const JobControl &control)
{
    for (std::size_t i = 0; i < m_files.size(); ++i) {
        const FilePair &files = m_files[i];
        const std::string nameA = files.a.filename().string(), nameB = files.b.filename().string();
        if (files.a.empty() || files.b.empty()) {
            m_rejected.push_back(
                {nameA, nameB,
                 ODO_TEXT("workflow.no_counterpart", "the other camera has no file of its number")});
            continue;
        }
        control.report(searchShare * double(i) / double(m_files.size()),
                       ODO_TEXT("workflow.looking_for_board_in_both",
                                "detecting the board in %1 and %2")(Named::file(nameA), Named::file(nameB)));
        const auto visited = visitFramePairs(
            files,
            [&](const FramePair &frames) {
                searchPair(frames);
                return !control.isCancelled();
            },
            control.cancel);
        if (control.isCancelled())
            return cancelled(pairOf(m_settings));
        if (!visited)
            m_rejected.push_back({nameA, nameB, visited.error().why});
    }
    const auto named = [&](Error error) {
        error.what = pairOf(m_settings);
        return tl::unexpected(std::move(error));
    };
    if (m_pairs.empty())
        return named(relateCameras({}, CameraModel::assumed(1, 1), CameraModel::assumed(1, 1), {}).error());
    control.report(searchShare, ODO_TEXT("workflow.computing_pair", "computing the relative position"));
    const auto a = ODO_TRY(cameraOf(0, control));
    const auto b = ODO_TRY(cameraOf(1, control));
    auto pair = relateCameras(m_pairs, a, b, control);
    if (!pair)
        return named(pair.error());
    m_pair = std::move(*pair);
    m_pair.rejected.insert(m_pair.rejected.begin(), m_rejected.begin(), m_rejected.end());
    join({a, b});
    for (Side &side : m_sides)
        if (side.storage)
            ODO_TRY(side.storage->writeImages(side.images, control));
    return {};
}

void CalibratePairJob::join(const std::array<CameraModel, 2> &cameras)
{
    const bool isRegistered[] = {m_sides[0].registration.has_value(), m_sides[1].registration.has_value()};
    if (isRegistered[0] && isRegistered[1]) {
        if (m_haveCommonAxes && m_sides[0].pose && m_sides[1].pose)
            m_difference = differenceOf(poseByRelation(*m_sides[0].pose, m_pair), *m_sides[1].pose);
        return;
    }
    if (!isRegistered[0] && !isRegistered[1])
        return;
    const std::size_t reference = isRegistered[0] ? 0 : 1, other = 1 - reference;
    if (!m_sides[reference].pose) {
        m_whyNotJoined =
            ODO_TEXT("workflow.reference_not_calibrated",
                     "camera '%1' was registered without a lens calibration: register it again with it")(
                Named::camera(m_settings.cameras[reference]));
        return;
    }
    const PoseOnFloor pose =
        poseByRelation(*m_sides[reference].pose, reference == 0 ? m_pair : reversed(m_pair));
    auto registered =
        registerByPose(pose, cameraSubject(m_settings.cameras[reference]), cameras[other], m_pair.rmsPx);
    if (!registered) {
        m_whyNotJoined = odo::joined({registered.error().why, registered.error().advice}, Join::Semicolon);
        return;
    }
    m_joinedPositions = std::move(registered->positions);
    Joined joined{other, {}, {}};
    joined.record.pixels = std::move(registered->pixels);
    joined.record.assumedIntrinsics = registered->registration.intrinsics;
    joined.record.registration = std::move(registered->registration);
    m_joined = std::move(joined);
}

Result<void> CalibratePairJob::storeJoined(Project &project)
{
    if (!m_joined)
        return {};
    const std::size_t reference = 1 - m_joined->side;
    m_joined->record.intrinsics = m_sides[m_joined->side].intrinsics;
    m_joined->record =
        ODO_TRY(storeViaCamera(project, m_settings.cameras[m_joined->side], m_settings.cameras[reference],
                               m_sides[reference].registration->id, m_joinedPositions, m_joined->record));
    m_joined->layout = m_joinedPositions.name;
    return {};
}

std::optional<BoardView> CalibratePairJob::findIn(const Frame &frame, const std::string &name,
                                                  std::size_t index, Message &reason)
{
    Side &side = m_sides[index];
    if (side.widthPx == 0) {
        side.widthPx = side.stored ? side.stored->widthPx : frame.format.width;
        side.heightPx = side.stored ? side.stored->heightPx : frame.format.height;
    }
    if (frame.format.width != side.widthPx || frame.format.height != side.heightPx) {
        reason = side.stored ? ODO_TEXT("workflow.pair_of_other_size", "'%1' is %2, but the camera was "
                                                                       "calibrated at %3")(
                                   Named::file(name), sizeText(frame.format.width, frame.format.height),
                                   sizeText(side.widthPx, side.heightPx))
                             : otherSizeThanMost(frame.format.width, frame.format.height, side.widthPx,
                                                 side.heightPx);
        return std::nullopt;
    }
    auto view = findBoard(frame, m_settings.board, name);
    if (!view) {
        reason = odo::joined({quotedName(Named::file(name)), view.error().why}, Join::Colon);
        return std::nullopt;
    }
    // One board in all images: what the first one shows holds for the rest.
    m_settings.board.pattern = view->pattern;
    m_settings.board.columns = view->columns;
    m_settings.board.rows = view->rows;
    m_views[index].push_back(*view);
    if (side.stored)
        return std::move(*view);
    if (auto png = greyPng(frame))
        side.images.push_back({name, std::move(*png)});
    return std::move(*view);
}

void CalibratePairJob::searchPair(const FramePair &frames)
{
    Message reason;
    auto a = findIn(frames.a, frames.nameA, 0, reason);
    auto b = findIn(frames.b, frames.nameB, 1, reason);
    if (a && b)
        m_pairs.push_back({std::move(*a), std::move(*b)});
    else
        m_rejected.push_back({frames.nameA, frames.nameB, std::move(reason)});
}

Result<CameraModel> CalibratePairJob::cameraOf(std::size_t index, const JobControl &control)
{
    Side &side = m_sides[index];
    if (side.stored)
        return CameraModel::create(*side.stored);
    auto calibration =
        calibrateIntrinsics(m_views[index], side.widthPx, side.heightPx, std::nullopt, control);
    if (!calibration) {
        Error error = calibration.error();
        error.what = calibrationOf(m_settings.cameras[index]);
        return tl::unexpected(std::move(error));
    }
    auto camera = CameraModel::create(calibration->intrinsics);
    side.storage = std::make_unique<CalibrationStorage>(m_mediaFolder, m_settings.cameras[index],
                                                        std::move(*calibration), m_settings.board);
    m_calibrated.push_back(m_settings.cameras[index]);
    return camera;
}

Result<void> CalibratePairJob::commit(Project &project)
{
    const auto stored =
        project.change(ODO_TEXT("workflow.calibrate_pair", "calibrate cameras %1 and %2 as a pair")(
                           Named::camera(m_settings.cameras[0]), Named::camera(m_settings.cameras[1])),
                       [&]() -> Result<void> {
                           for (Side &side : m_sides) {
                               if (!side.storage)
                                   continue;
                               const auto record = ODO_TRY(side.storage->commit(project));
                               side.intrinsics = record.id;
                           }
                           return storeJoined(project);
                       });
    for (Side &side : m_sides)
        side.storage.reset(); // what was not stored, goes
    return stored;
}

} // namespace odo
