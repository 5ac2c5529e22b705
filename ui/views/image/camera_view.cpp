// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/image/camera_view.h"

#include "ui/models/number_text.h"
#include "ui/models/timeline.h"
#include "ui/models/trial_scene.h"
#include "ui/views/image/internal/image_area.h"

#include <QStringList>

namespace odo {

namespace {

QString viewRemark(const TrialScene &scene, std::size_t index)
{
    const RecordingRecord &recording = scene.views[index].recording;
    QStringList parts; // the most informative first: the end may be cut off
    if (index > 0 && isStepMeasured(recording))
        parts += CameraView::tr("synchronised to %1 ms")
                     .arg(QLocale().toString(recording.startOffsetSigmaS * 1e3, 'f', 1));
    else if (index > 0 && recording.syncMethod == "told")
        parts += CameraView::tr("manual offset");
    else if (index > 0)
        parts += CameraView::tr("not synchronised");
    parts += QStringLiteral("%1×%2").arg(recording.widthPx).arg(recording.heightPx);
    if (recording.framesPerSecond > 0)
        parts += CameraView::tr("%1 /s").arg(QLocale().toString(recording.framesPerSecond, 'f', 1));
    return parts.join(QStringLiteral(" · "));
}

} // namespace

QString viewTitle(const SceneView &view)
{
    const QString name = QString::fromStdString(view.camera);
    constexpr qsizetype shortName = 2; // "A" alone says little
    return name.size() <= shortName ? CameraView::tr("Camera %1").arg(name) : name;
}

CameraView::CameraView(Timeline &timeline, QWidget *parent)
    : Card(tr("Camera"), parent), m_area(new ImageArea(timeline, this))
{
    setContent(m_area);
    m_area->setAccessibleName(tr("Camera image"));
    connect(m_area, &ImageArea::settled, this, &CameraView::settled);
    connect(m_area, &ImageArea::pointedAt, this, &CameraView::pointedAt);
    connect(m_area, &ImageArea::hovered, this, &CameraView::hovered);
}

CameraView::~CameraView() = default;

void CameraView::setScene(TrialScenePtr scene, std::size_t view)
{
    const bool there = scene && view < scene->views.size();
    setTitle(there ? viewTitle(scene->views[view]) : tr("Camera"));
    setRemark(there ? viewRemark(*scene, view) : QString());
    setBadge(there ? registrationBadge(scene->views[view].registration) : Badge());
    m_area->setAccessibleName(tr("Image of %1").arg(title()));
    m_area->setScene(std::move(scene), view);
}

void CameraView::setOverlay(ImageOverlay overlay)
{
    m_area->setOverlay(std::move(overlay));
}

void CameraView::setRobotColour(const QColor &colour)
{
    m_area->setRobotColour(colour);
}

void CameraView::setOutlinesShown(bool shown)
{
    m_area->setOutlinesShown(shown);
}

void CameraView::setLoupeShown(bool shown)
{
    m_area->setLoupeShown(shown);
}

void CameraView::setPointing(bool pointing)
{
    m_area->setPointing(pointing);
}

void CameraView::setReadOut(const QString &text)
{
    m_area->setReadOut(text);
}

bool CameraView::isSettled() const
{
    return m_area->isSettled();
}
QPointF CameraView::fromImagePixels(const QPointF &pixel) const
{
    return m_area->fromImagePixels(pixel);
}
QWidget *CameraView::imageArea() const
{
    return m_area;
}
ZoomPan &CameraView::zoom() const
{
    return m_area->zoom();
}

} // namespace odo
