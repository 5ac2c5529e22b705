// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/testbed/floor/still_picture.h"

#include <QWidget>
#include <filesystem>
#include <optional>

class QRadioButton;

namespace odo {

class LiveCameraBox;
class LiveCameras;
class PathField;

/// Asks where a picture of the floor comes from: the camera's newest recording, a camera that is connected, or a file.
class PictureChoice : public QWidget
{
    Q_OBJECT
public:
    /// live must outlive it. fileName: of the line for the file, for a screen reader.
    PictureChoice(const LiveCameras &live, const QString &fileName, QWidget *parent = nullptr);

    /// Of the camera that is chosen; nullopt: it has none. It is taken where there is one, unless something else was chosen.
    void setRecording(const std::optional<std::filesystem::path> &file);
    void setFile(const QString &file);
    /// Both empty: nothing is chosen yet.
    PictureOrigin origin() const;
    bool isComplete() const;

Q_SIGNALS:
    void changed();

private:
    void updateChoices();

    std::optional<std::filesystem::path> m_recording;
    QRadioButton *m_fromRecording, *m_fromLive, *m_fromFile;
    LiveCameraBox *m_live;
    PathField *m_file;
};

} // namespace odo
