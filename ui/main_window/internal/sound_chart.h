// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/sound_track.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/charts/chart_view.h"

#include <array>
#include <vector>

namespace odo {

/// The loudest of a sound in each millisecond, 0 to 1. A plain value.
struct SoundPeaks
{
    double firstS = 0; ///< of the first one, since the video's first frame
    std::vector<float> peaks;
};

/// Any thread.
SoundPeaks peaksOf(const SoundTrack &track);

/// The loudness of two views over the trial's time, the first one's upwards, the second one's downwards: once
/// the time offset is right, what both heard is at one time. Dragged to the left or right, the second moves
/// against the first. GUI thread.
class SoundChart : public ChartView
{
    Q_OBJECT
public:
    explicit SoundChart(QWidget *parent = nullptr);
    void setSounds(std::array<SoundPeaks, 2> sounds);
    /// How much later the second view's first frame was taken.
    void setOffset(double offsetS);
    double offsetS() const { return m_offsetS; }

Q_SIGNALS:
    void offsetDragged(double offsetS);

protected:
    void goTo(double x) override;
    void dragTo(double from, double x) override;

private:
    void showVisible();

    std::array<SoundPeaks, 2> m_sounds;
    double m_offsetS = 0, m_grabbedS = 0; ///< now, and when it was grabbed
};

} // namespace odo
