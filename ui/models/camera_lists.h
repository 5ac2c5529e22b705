// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/camera_source.h"
#include "core/project/records.h"
#include "ui/models/background_task.h"
#include "ui/models/internal/row_table_model.h"
#include "ui/models/number_text.h"

#include <optional>
#include <vector>

namespace odo {

class Project;

/// A camera of the project with what is known of it.
struct CameraRow
{
    CameraRecord camera;
    std::optional<IntrinsicsRecord> intrinsics;     ///< in force
    std::optional<RegistrationRecord> registration; ///< in force
    std::vector<Message> warnings;                  ///< of age and resolution, whole sentences
};

/// On the project's thread.
Result<std::vector<CameraRow>> loadCameraRows(Project &project);

/// The cameras of a project and how far they are set up.
class CameraListModel : public RowTableModel
{
    Q_OBJECT
public:
    enum Columns { NameColumn, CalibrationColumn, RegistrationColumn, VerdictColumn, ColumnCount };
    enum Roles {
        BadgeTextRole = Qt::UserRole, ///< QString, "±1.6 mm", "moved 14 mm", "not registered"
        BadgeStateRole,               ///< int, BadgeState
        NameRole,                     ///< QString
    };

    explicit CameraListModel(QObject *parent = nullptr);
    void setRows(std::vector<CameraRow> rows);
    const CameraRow &row(int index) const { return m_rows.at(static_cast<std::size_t>(index)); }

private:
    int rows() const override { return static_cast<int>(m_rows.size()); }
    QVariant cell(int index, int column, int role) const override;
    QVariant heading(int column, int role) const override;
    QString display(const CameraRow &row, int column) const;

    std::vector<CameraRow> m_rows;
};

/// The connected cameras. A search takes up to two seconds, so it runs on a thread of its own; the last
/// result stays valid meanwhile. GUI thread.
class LiveCameras : public QObject
{
    Q_OBJECT
public:
    using List = std::function<std::vector<CameraDescription>()>;

    /// list: called on a thread of its own.
    explicit LiveCameras(List list = listCameras, QObject *parent = nullptr);

    /// Searches again, unless a search is running.
    void poll();
    bool isSearching() const { return m_task.isRunning(); }
    const std::vector<CameraDescription> &cameras() const { return m_cameras; }

Q_SIGNALS:
    void changed(); ///< a search has started or ended

private:
    List m_list;
    std::vector<CameraDescription> m_cameras;
    BackgroundTask m_task;
};

} // namespace odo
