// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibration_storage.h"

#include "core/project/instant_now.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/cameras.h"

#include <algorithm>

namespace odo {

CalibrationStorage::CalibrationStorage(const std::filesystem::path &mediaFolder, std::string camera,
                                       IntrinsicCalibration calibration, const BoardSpec &board)
    : m_media(mediaFolder), m_camera(std::move(camera))
{
    m_record.origin = "calibrated from " + std::to_string(calibration.picturesUsed()) + " pictures";
    m_record.calibration = std::move(calibration);
    m_record.board = board;
    m_record.softwareVersion = ODOGRAPH_VERSION;
}

Result<void> CalibrationStorage::writePictures(const std::vector<BoardPicture> &pictures, const JobControl &control)
{
    const auto &used = m_record.calibration.pictures;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (control.isCancelled())
            return cancelled("calibration of camera '" + m_camera + "'");
        control.report(double(i) / double(used.size()), "keeping the pictures");
        const auto picture = std::ranges::find(pictures, used[i].view.source, &BoardPicture::source);
        m_record.files.emplace_back(); // those without a picture have none
        if (picture == pictures.end())
            continue;
        const std::string name = m_camera + "_" + std::filesystem::path(used[i].view.source).stem().string();
        auto written = m_media.write(name, picture->png);
        if (!written)
            return tl::unexpected(written.error());
        m_record.files.back() = std::move(*written);
    }
    return {};
}

Result<IntrinsicsRecord> CalibrationStorage::commit(Project &project)
{
    const auto stored = project.note("calibrate camera " + m_camera, [&]() -> Result<void> {
        const auto camera = findOrAddCamera(project, m_camera);
        if (!camera)
            return tl::unexpected(camera.error());
        m_record.camera = camera->id;
        m_record.made = instantNow();
        auto added = project.cameras().addIntrinsics(m_record);
        if (!added)
            return tl::unexpected(added.error());
        m_record = std::move(*added);
        return {};
    });
    if (!stored)
        return tl::unexpected(stored.error());
    m_media.keep();
    return m_record;
}

} // namespace odo
