// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/scene_uncertainty.h"
#include "ui/models/trial_scene.h"

#include <QAbstractSlider>
#include <QFrame>
#include <QList>
#include <optional>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QToolButton;

namespace odo {

class Timeline;

/// The slider of the time line: value = frame; spikes as triangles above the groove, stretches in which less
/// than usual is known of a robot as bars there (hatched: which one it is), with words where the mouse rests;
/// seconds below it. What is outside of the trial's range is dimmed; the handles at its ends can be dragged.
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

Q_SIGNALS:
    /// To this range of the trial, when a handle of it was let go.
    void rangeDragged(const odo::TimeSpan &range);

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
    void paintRange(QPainter &painter, double y) const;
    TimeSpan range() const;
    bool beginDrag(const QPointF &position);
    void paintSpikes(QPainter &painter, double y) const;
    void paintStretches(QPainter &painter, double y) const;
    double grooveY() const;

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    std::vector<UncertainInterval> m_stretches; ///< of the scene
    std::optional<TimeSpan> m_dragged;          ///< the range while a handle of it is dragged
    bool m_dragsEnd = false;
};

class TimeSlider;

/// The shared time, to see and to move: to the start, play, to the end, time and frame, a slider with the
/// spikes above it and seconds below, the rate.
class TimelineBar : public QFrame
{
    Q_OBJECT
public:
    explicit TimelineBar(Timeline &timeline, QWidget *parent = nullptr);
    /// The spikes that are marked on the slider; null clears.
    void setScene(TrialScenePtr scene);
    /// What the context menu of the slider offers.
    void setRangeActions(const QList<QAction *> &actions);

Q_SIGNALS:
    void rangeDragged(const odo::TimeSpan &range);

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void makeButtons();
    void showCurrent();
    void showPlaying();
    void showRate();
    void applyColours();

    Timeline &m_timeline;
    QToolButton *m_first, *m_play, *m_last;
    QLabel *m_time, *m_frame;
    TimeSlider *m_slider;
    QComboBox *m_rate;
};

} // namespace odo
