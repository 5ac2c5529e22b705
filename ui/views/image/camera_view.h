// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/card.h"

#include <optional>

namespace odo {

class ImageArea;
class Timeline;
class ZoomPan;

/// What a view is called: "Camera A", or its longer name.
QString viewTitle(const SceneView &view);

/// One view of a trial: its image at the shared time, and on it the robots' outlines, their trails, the
/// world's axes and the floor grid, all through the registered camera. Can be looked at closely (ZoomPan), to
/// single pixels.
class CameraView : public Card
{
    Q_OBJECT
public:
    explicit CameraView(Timeline &timeline, QWidget *parent = nullptr);
    ~CameraView() override;

    /// The view of this index of the scene; a null scene or an index beyond its views clears.
    void setScene(TrialScenePtr scene, std::size_t view);
    /// Painted over the image, within it; empty: nothing.
    void setOverlay(ImageOverlay overlay);
    /// Of all robots' trails and outlines, in place of each robot's own.
    void setRobotColour(const QColor &colour);
    /// Whether to draw the outlines of the detected robots; on by default.
    void setOutlinesShown(bool shown);
    /// Whether a corner shows the surroundings of the robot, as drawLoupe.
    void setLoupeShown(bool shown);
    /// While it waits for a position in the image, a click gives it; a right click always does.
    void setPointing(bool pointing);
    /// One line at the lower edge of the image, of what is under the mouse; empty: none.
    void setReadOut(const QString &text);
    /// True when the image that belongs to the current time is shown (or is not available).
    bool isSettled() const;

    /// The position of a point of the recording's image in the image area, in its widget coordinates.
    QPointF fromImagePixels(const QPointF &pixel) const;
    QWidget *imageArea() const;
    /// How closely it is looked at.
    ZoomPan &zoom() const;

Q_SIGNALS:
    void settled();
    /// In pixels of the recording's image, and on the screen.
    void pointedAt(const QPointF &pixel, const QPoint &global);
    /// The pixel of the recording's image under the mouse; nullopt where the mouse has left the image.
    void hovered(const std::optional<QPointF> &pixel);

private:
    ImageArea *m_area;
};

} // namespace odo
