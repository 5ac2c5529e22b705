// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/stills_painting.h"

#include "ui/report/report_painting.h"
#include "ui/views/picture_overlay.h"
#include "ui/views/robot_colours.h"
#include "ui/views/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

namespace odo {

namespace {

constexpr std::size_t mostStills = 2;
constexpr double stillGap = 6;

class ReportStillsWords
{
    Q_DECLARE_TR_FUNCTIONS(ReportStills)
};

} // namespace

QRectF drawStill(QPainter &painter, const QRectF &rect, const TrialScene &scene, std::size_t view, const Still &still)
{
    const RecordingRecord &recording = scene.views[view].recording;
    const ThemeColours colours = ThemeColours::of(reportPalette());
    const QSizeF size = QSizeF(std::max(1, recording.widthPx), std::max(1, recording.heightPx))
                            .scaled(rect.size(), Qt::KeepAspectRatio);
    const QRectF box(rect.topLeft(), size);
    painter.save();
    painter.setClipRect(box);
    if (still.picture.isNull()) {
        painter.fillRect(box, colours.pictureGround);
        const QString why = still.isVideoThere ? ReportStillsWords::tr("no picture: the video cannot be read")
                                               : ReportStillsWords::tr("no picture: the video is missing");
        drawLine(painter, box, why, reportFont(smallSize), colours.muted, Qt::AlignCenter);
    } else {
        painter.drawImage(box, still.picture);
        const double scale = box.width() / recording.widthPx;
        const PictureMap map = [&](const QPointF &pixel) {
            return box.topLeft() + (pixel + QPointF(0.5, 0.5)) * scale;
        };
        painter.setFont(reportFont(smallSize));
        painter.setRenderHint(QPainter::Antialiasing);
        const std::vector<int> places = colourPlaces(scene);
        for (std::size_t robot = 0; robot < scene.robots.size(); ++robot) {
            if (scene.views[view].floorView)
                paintTrail(painter, scene, robot, *scene.views[view].floorView, map, colourOnPicture(places[robot]));
            paintRobot(painter, scene, view, robot, still.frame, map);
        }
    }
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.border, 0.8));
    painter.drawRect(box);
    const QString name = literalName(scene.views[view].camera);
    const QFont font = reportFont(smallSize, QFont::DemiBold);
    const double width = std::min(box.width(), QFontMetricsF(font).horizontalAdvance(name) + 10);
    const QRectF sign(box.left(), box.top(), width, 14);
    painter.fillRect(sign, colours.card);
    drawLine(painter, sign.adjusted(4, 0, -2, 0), name, font, colours.text);
    return box;
}

void drawStills(QPainter &painter, const QRectF &rect, const TrialScene &scene, const std::vector<Still> &stills)
{
    const std::size_t count = std::min(mostStills, stills.size());
    double top = rect.top();
    for (std::size_t view = 0; view < count; ++view) {
        const double height = (rect.height() - stillGap * double(count - 1)) / double(count);
        const QRectF box = drawStill(painter, QRectF(rect.left(), top, rect.width(), height), scene, view, stills[view]);
        top = box.bottom() + stillGap;
    }
}

} // namespace odo
