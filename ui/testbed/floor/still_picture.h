// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/calibration/marker_detection.h"

#include <QImage>
#include <QString>
#include <functional>
#include <optional>

namespace odo {

/// A picture of the floor and the markers found in it.
struct StillPicture
{
    Frame frame;
    QImage image;
    std::vector<MarkerPixel> markers;
    std::optional<Error> notFound; ///< why no markers are there
};

/// Keeps a camera's picture beside the project, before its registration is stored. On a thread of the wizard's.
using KeepPicture = std::function<Result<void>(const QString &camera, const Frame &picture)>;

/// Where a picture comes from: a file (picture or video), or the address of a camera.
struct PictureOrigin
{
    QString file, liveUri;
};

/// Takes the picture and looks for the layout's markers in it; of a video the first picture in which the most are seen. A
/// layout without markers: the picture alone, of a video the first.
/// Any thread; long. Errors: unreadable, lost camera, Cancelled, and another size than the lens was measured at.
Result<StillPicture> takeStillPicture(const PictureOrigin &origin, const MarkerLayout &layout, const std::optional<Intrinsics> &lens,
                                      const JobControl &control);

/// The camera that a picture of this size was taken with.
CameraModel cameraOf(const std::optional<Intrinsics> &lens, int widthPx, int heightPx);

} // namespace odo
