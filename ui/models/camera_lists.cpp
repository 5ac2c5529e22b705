// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/camera_lists.h"

#include "core/project/project.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/cameras.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"

namespace odo {

Result<std::vector<CameraRow>> loadCameraRows(Project &project)
{
    auto cameras = project.cameras().all();
    if (!cameras)
        return tl::make_unexpected(cameras.error());
    const Instant now = instantNow();
    std::vector<CameraRow> rows;
    rows.reserve(cameras->size());
    for (const CameraRecord &camera : *cameras) {
        auto intrinsics = project.cameras().currentIntrinsics(camera.id);
        if (!intrinsics)
            return tl::make_unexpected(intrinsics.error());
        auto registration = project.cameras().currentRegistration(camera.id);
        if (!registration)
            return tl::make_unexpected(registration.error());
        auto warnings = calibrationWarnings(project, camera, now);
        if (!warnings)
            return tl::make_unexpected(warnings.error());
        rows.push_back({camera, std::move(*intrinsics), std::move(*registration), std::move(*warnings)});
    }
    return rows;
}

CameraListModel::CameraListModel(QObject *parent) : RowTableModel(ColumnCount, parent) {}

void CameraListModel::setRows(std::vector<CameraRow> rows)
{
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

QString CameraListModel::display(const CameraRow &row, int column) const
{
    switch (column) {
    case NameColumn:
        return QString::fromStdString(row.camera.name);
    case CalibrationColumn:
        if (!row.intrinsics)
            return tr("not calibrated");
        if (row.intrinsics->calibration.rmsPx > 0)
            return tr("calibrated, ±%1 px")
                .arg(QLocale().toString(row.intrinsics->calibration.rmsPx, 'f', 2));
        return shownWords(row.intrinsics->origin);
    case RegistrationColumn:
        if (!row.registration)
            return tr("not registered");
        return tr("registered, %1").arg(cameraBadge(row.registration).text);
    case VerdictColumn:
        if (row.registration && row.registration->lastCheck &&
            row.registration->lastCheck->outcome != RegistrationCheck::Outcome::Still)
            return shownWords(row.registration->lastCheck->words);
        if (row.registration)
            return shownWords(row.registration->registration.verdict);
        if (row.intrinsics)
            return shownWords(row.intrinsics->calibration.verdict);
        return tr("Calibrate the lens, then register the camera to the floor.");
    default:
        return {};
    }
}

QVariant CameraListModel::cell(int index, int column, int role) const
{
    const CameraRow &row = m_rows[static_cast<std::size_t>(index)];
    switch (role) {
    case Qt::DisplayRole:
        return display(row, column);
    case Qt::ToolTipRole:
        return display(row, VerdictColumn).toHtmlEscaped();
    case BadgeTextRole:
        return cameraBadge(row.registration).text;
    case BadgeStateRole:
        return static_cast<int>(cameraBadge(row.registration).state);
    case NameRole:
        return QString::fromStdString(row.camera.name);
    default:
        return {};
    }
}

QVariant CameraListModel::heading(int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case NameColumn:
        return tr("Camera");
    case CalibrationColumn:
        return tr("Calibration");
    case RegistrationColumn:
        return tr("Floor");
    case VerdictColumn:
        return tr("Verdict");
    default:
        return {};
    }
}

LiveCameras::LiveCameras(List list, QObject *parent) : QObject(parent), m_list(std::move(list)) {}

void LiveCameras::poll()
{
    auto found = std::make_shared<std::vector<CameraDescription>>();
    if (!m_task.start([found, list = m_list](const JobControl &) -> Result<void> {
            *found = list();
            return {};
        }))
        return;
    connect(
        &m_task, &BackgroundTask::finished, this,
        [this, found] {
            m_cameras = std::move(*found);
            Q_EMIT changed();
        },
        Qt::SingleShotConnection);
    Q_EMIT changed();
}

} // namespace odo
