// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/live_camera_box.h"

#include "ui/models/live_cameras.h"

#include <QSignalBlocker>
#include <algorithm>

namespace odo {

LiveCameraBox::LiveCameraBox(const LiveCameras &cameras, QWidget *parent) : QComboBox(parent), m_cameras(cameras)
{
    setAccessibleName(tr("Camera that is connected"));
    setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(&cameras, &LiveCameras::changed, this, &LiveCameraBox::fill);
    fill();
}

void LiveCameraBox::fill()
{
    const QString chosen = uri();
    {
        const QSignalBlocker blocked(this);
        clear();
        for (const CameraDescription &camera : m_cameras.cameras()) {
            const QString name = shownDeviceName(camera);
            addItem(camera.widthPx > 0 ? tr("%1, %2×%3").arg(name).arg(camera.widthPx).arg(camera.heightPx) : name, QString::fromStdString(camera.uri));
        }
        if (count() == 0)
            addItem(m_cameras.isLooking() ? tr("Looking for cameras…") : tr("No camera is connected"), QString());
        setCurrentIndex(std::max(0, findData(chosen)));
    }
    Q_EMIT currentIndexChanged(currentIndex());
}

} // namespace odo
