// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace odo {

class LiveCameras;

/// A choice among the cameras that are connected, which fills itself when they are found. Its data is the address.
class LiveCameraBox : public QComboBox
{
    Q_OBJECT
public:
    /// cameras must outlive it.
    explicit LiveCameraBox(const LiveCameras &cameras, QWidget *parent = nullptr);

    /// Empty: none is connected, or none was found yet.
    QString uri() const { return currentData().toString(); }

private:
    void fill();
    const LiveCameras &m_cameras;
};

} // namespace odo
