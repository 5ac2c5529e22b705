// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/testbed/check/check_camera.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/testbed/floor/still_picture.h"

#include <QWidget>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;

namespace odo {

class LiveCameras;
class PictureChoice;

/// First page of registering a camera through another one: which two, and where a picture of each comes from.
class ThroughSourcePage : public QWidget
{
    Q_OBJECT
public:
    /// cameras: those that can be registered. registered: those it can be done through; one at least.
    ThroughSourcePage(const std::vector<FloorCamera> &cameras, const QString &current, const std::vector<CheckCamera> &registered,
                      const LiveCameras &live, QWidget *parent = nullptr);

    const FloorCamera &camera() const;
    const CheckCamera &through() const;
    PictureChoice &picture() { return *m_picture; }
    PictureChoice &throughPicture() { return *m_throughPicture; }
    bool isComplete() const;

Q_SIGNALS:
    void completeChanged();

private:
    void showCameras();

    const std::vector<FloorCamera> m_cameras;
    const std::vector<CheckCamera> m_registered;
    QComboBox *m_camera, *m_through;
    PictureChoice *m_picture, *m_throughPicture;
    QLabel *m_same; ///< shown when both are the same camera
};

} // namespace odo
