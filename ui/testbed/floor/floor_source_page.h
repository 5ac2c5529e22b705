// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/testbed/floor/still_picture.h"

#include <QWidget>

class QComboBox;
class QLabel;

namespace odo {

class BadgeLabel;
class LiveCameras;
class PictureChoice;

/// First page of the floor wizard: which camera, which layout, and the picture in which its markers are seen.
class FloorSourcePage : public QWidget
{
    Q_OBJECT
public:
    /// live must outlive it.
    FloorSourcePage(const std::vector<FloorCamera> &cameras, const QString &current, const std::vector<LayoutRecord> &layouts,
                    const LiveCameras &live, QWidget *parent = nullptr);

    QString camera() const;
    int layout() const; ///< its place in the list
    PictureOrigin origin() const;
    void setFile(const QString &file);
    bool isComplete() const;

Q_SIGNALS:
    void completeChanged();

private:
    void showCamera();
    const FloorCamera *known() const;

    const std::vector<FloorCamera> m_cameras;
    QComboBox *m_camera, *m_layout;
    PictureChoice *m_picture;
    QLabel *m_lens;
    BadgeLabel *m_badge;
};

} // namespace odo
