// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/doubtful_stretches.h"

#include <QAbstractSlider>

namespace odo {

class Timeline;

/// The slider of the time line: value = frame; spikes as triangles above the groove, stretches in which less than usual is known of a robot
/// as bars there (hatched: which one it is), with words where the mouse rests; seconds below it.
class TimeSlider : public QAbstractSlider
{
    Q_OBJECT
public:
    explicit TimeSlider(Timeline &timeline, QWidget *parent = nullptr);
    void setScene(TrialScenePtr scene);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// Where a time lies, in widget coordinates.
    double xOf(Nanoseconds time) const;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    Nanoseconds timeAt(double x) const; ///< may lie before the start or after the end
    void goTo(double x);
    void paintSeconds(QPainter &painter, double y) const;
    void paintSelection(QPainter &painter, double y) const;
    void paintSpikes(QPainter &painter, double y) const;
    void paintStretches(QPainter &painter, double y) const;
    double grooveY() const;

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    std::vector<DoubtfulStretch> m_stretches; ///< of the scene
};

} // namespace odo
