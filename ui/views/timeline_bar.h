// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QFrame>

class QComboBox;
class QLabel;
class QToolButton;

namespace odo {

class Timeline;
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
