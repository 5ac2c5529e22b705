// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "ui/models/trial_scene.h"

#include <QImage>
#include <QObject>
#include <memory>
#include <thread>

namespace odo {

/// The floor seen from above, put together from the cameras' images. Rows go down as Y goes down.
struct FloorImage
{
    QImage image;               ///< premultiplied ARGB; transparent where no camera looks
    Eigen::AlignedBox2d extent; ///< of the image on the floor, metres
};

/// What is made of the floor where these bounds must be seen: a little more, so that the image does not end
/// at the markers.
Eigen::AlignedBox2d floorExtent(const Eigen::AlignedBox2d &bounds);
/// How many pixels the longer side of it has, where it is shown this large.
int floorSidePx(const Eigen::AlignedBox2d &extent, double pixelsPerMetre);

/// Each point of the floor takes its colour from the views that see it, the one with the finest resolution
/// there weighing most; the median over a few frames of each view removes whatever moves. Any thread; slow
/// (decodes). A null image when nothing could be seen or the work was cancelled.
FloorImage makeFloorImage(const TrialScene &scene, const Eigen::AlignedBox2d &extent, int longestSidePx,
                          const CancelToken &cancel);

/// Makes the floor image of a scene on a thread of its own, as fine as it is shown. GUI thread.
class FloorImageMaker : public QObject
{
    Q_OBJECT
public:
    explicit FloorImageMaker(QObject *parent = nullptr);
    ~FloorImageMaker() override;

    /// Begins without waiting; an image in work is given up, and the new one begins as soon as that has
    /// ended. bounds: what must be seen; a little more is made, so that the image does not end at the
    /// markers. A null scene only stops.
    void make(TrialScenePtr scene, const Eigen::AlignedBox2d &bounds, double pixelsPerMetre);
    /// Remakes it if it is shown much larger than it was made for.
    void setScale(double pixelsPerMetre);
    bool isRunning() const { return m_running; }

Q_SIGNALS:
    void ready(const odo::FloorImage &image);

private:
    void restart();
    void begin();
    void finish(const FloorImage &image, bool givenUp);

    CancelToken m_cancel;
    std::thread m_thread;
    TrialScenePtr m_scene; ///< whose floor is shown
    Eigen::AlignedBox2d m_extent;
    int m_sidePx = 0;        ///< how fine it is, or is to be
    bool m_isWanted = false; ///< not started yet
    bool m_running = false;
};

} // namespace odo
