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

/// An image of the floor and the markers detected in it.
struct StillImage
{
    Frame frame;
    QImage image;
    std::vector<MarkerPixel> markers;
    std::optional<Error> notFound; ///< why no markers are there
};

/// Writes a camera's image beside the project, before its registration is stored. On a thread of the
/// wizard's.
using KeepImage = std::function<Result<void>(const QString &camera, const Frame &image)>;

/// The source of an image: a file (image or video), or the address of a camera.
struct ImageOrigin
{
    QString file, liveUri;
};

/// Takes the image and detects the layout's markers in it; in a video, the first frame that shows the most. A
/// layout without markers: the image alone, of a video the first frame. Any thread; long. Errors: unreadable,
/// lost camera, Cancelled, and a size other than the calibrated one.
Result<StillImage> takeStillImage(const ImageOrigin &origin, const MarkerLayout &layout,
                                  const std::optional<Intrinsics> &intrinsics, const JobControl &control);

/// Why an image of another size than the lens was calibrated at cannot be taken.
Error imageOfOtherSize(const Frame &image, const Intrinsics &calibrated);

/// The camera model for an image of this size.
CameraModel cameraOf(const std::optional<Intrinsics> &intrinsics, int widthPx, int heightPx);

class LiveCameraBox;
class LiveCameras;
class PathField;

/// Asks for the source of a floor image: the camera's newest recording, a connected camera, or a file.
class ImageChoice : public QWidget
{
    Q_OBJECT
public:
    /// live must outlive it. fileName: of the line for the file, for a screen reader.
    ImageChoice(const LiveCameras &live, const QString &fileName, QWidget *parent = nullptr);

    /// Beside another one in a dialog: no key with Alt is to mean both.
    void removeKeys();
    /// Of the camera that is chosen; nullopt: it has none. It is taken where there is one, unless something
    /// else was chosen.
    void setRecording(const std::optional<std::filesystem::path> &file);
    void setFile(const QString &file);
    /// Both empty: nothing is chosen yet.
    ImageOrigin origin() const;
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
