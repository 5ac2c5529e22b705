// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame_intervals.h"
#include "ui/review/internal/figure_panel.h"

#include <QWidget>
#include <vector>

namespace odo {

/// The frame intervals of one view, with how many of its frames show the frame before once more.
struct ViewIntervals
{
    std::string camera;
    FrameIntervals intervals;
    std::int64_t frames = 0;
    /// Frames that the trackers found to repeat the one before; nullopt: no robot was tracked in it.
    std::optional<std::int64_t> repeated;
};
/// Of all views of a trial. repeated: of the first view, whose frames the samples are of. Any thread.
std::vector<ViewIntervals> viewIntervals(const TrialScene &scene);

/// "A: 33.4 ±0.1 ms apart (29.97 frames/s), jitter 1.2 ms; 3 frames missing in 2 places; …"
QString intervalText(const ViewIntervals &view);

/// How many intervals are how long, as bars; where the mouse is, in words.
class IntervalHistogram : public QWidget
{
    Q_OBJECT
public:
    explicit IntervalHistogram(FrameIntervals intervals, QWidget *parent = nullptr);
    QSize sizeHint() const override { return {260, 84}; }
    QSize minimumSizeHint() const override { return {160, 60}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    bool event(QEvent *event) override;

private:
    QRectF plot() const;
    /// Of the bin at a position; empty: none.
    QString wordsAt(double x) const;

    const FrameIntervals m_intervals;
};

/// The frame intervals of each view of a trial: histogram, jitter, lost and repeated frames.
class IntervalPanel : public FigurePanel
{
    Q_OBJECT
public:
    explicit IntervalPanel(QWidget *parent = nullptr);
};

} // namespace odo
