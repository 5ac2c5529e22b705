// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/calibration/marker_detection.h"

#include <QImage>
#include <QString>
#include <QWidget>
#include <filesystem>
#include <functional>
#include <optional>

class QRadioButton;

namespace odo {

/// A picture of the floor and the markers found in it.
struct StillPicture
{
    Frame frame;
    QImage image;
    std::vector<MarkerPixel> markers;
    std::optional<Error> notFound; ///< why no markers are there
};

/// Keeps a camera's picture beside the project, before its registration is stored. On a thread of the
/// wizard's.
using KeepPicture = std::function<Result<void>(const QString &camera, const Frame &picture)>;

/// Where a picture comes from: a file (picture or video), or the address of a camera.
struct PictureOrigin
{
    QString file, liveUri;
};

/// Takes the picture and looks for the layout's markers in it; of a video the first picture in which the most
/// are seen. A layout without markers: the picture alone, of a video the first. Any thread; long. Errors:
/// unreadable, lost camera, Cancelled, and another size than the lens was measured at.
Result<StillPicture> takeStillPicture(const PictureOrigin &origin, const MarkerLayout &layout,
                                      const std::optional<Intrinsics> &lens, const JobControl &control);

/// The camera that a picture of this size was taken with.
CameraModel cameraOf(const std::optional<Intrinsics> &lens, int widthPx, int heightPx);

class LiveCameraBox;
class LiveCameras;
class PathField;

/// Asks where a picture of the floor comes from: the camera's newest recording, a camera that is connected,
/// or a file.
class PictureChoice : public QWidget
{
    Q_OBJECT
public:
    /// live must outlive it. fileName: of the line for the file, for a screen reader.
    PictureChoice(const LiveCameras &live, const QString &fileName, QWidget *parent = nullptr);

    /// Of the camera that is chosen; nullopt: it has none. It is taken where there is one, unless something
    /// else was chosen.
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
