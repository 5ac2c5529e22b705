// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/sound_chart.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace odo {

namespace {

constexpr double peaksPerSecond = 1000;
constexpr int columns = 1500; // of what is visible

double endOf(const SoundPeaks &sound)
{
    return sound.firstS + double(sound.peaks.size()) / peaksPerSecond;
}

/// The loudest of each column that lies within the sound.
CurveRun visiblePeaks(const SoundPeaks &sound, double beganS, double sign, const AxisSpan &visible)
{
    CurveRun run;
    const double step = std::max((visible.high() - visible.low()) / columns, 1 / peaksPerSecond);
    const double first = sound.firstS + beganS;
    const auto count = std::ptrdiff_t(sound.peaks.size());
    const auto indexAt = [&](double timeS) {
        return std::clamp<std::ptrdiff_t>(std::llround((timeS - first) * peaksPerSecond), 0, count);
    };
    // from multiples of the step on, so that the columns do not flicker while the view is moved
    for (double from = std::floor(visible.low() / step) * step; from < visible.high(); from += step) {
        const auto begin = sound.peaks.begin() + indexAt(from),
                   end = sound.peaks.begin() + indexAt(from + step);
        if (begin < end)
            run.points.push_back(BandPoint(from, {sign * double(*std::max_element(begin, end)), 0}));
    }
    return run;
}

} // namespace

SoundPeaks peaksOf(const SoundTrack &track)
{
    constexpr auto each = std::size_t(SoundTrack::rate / peaksPerSecond);
    SoundPeaks sound{track.firstS, {}};
    sound.peaks.reserve(track.samples.size() / each + 1);
    for (std::size_t i = 0; i < track.samples.size(); i += each) {
        int loudest = 0;
        for (std::size_t k = i; k < std::min(i + each, track.samples.size()); ++k)
            loudest = std::max(loudest, std::abs(int(track.samples[k])));
        sound.peaks.push_back(float(loudest) / 32768.0F);
    }
    const auto highest = std::ranges::max_element(sound.peaks);
    if (highest != sound.peaks.end() && *highest > 0)
        for (float &peak : sound.peaks)
            peak /= *highest; // a clap is a mark, however far the microphone was
    return sound;
}

SoundChart::SoundChart(QWidget *parent)
    : ChartView(*new AxisSpan, ChartAxes{{QStringLiteral("s"), 1}, tr("Loudness")}, parent)
{
    span().setParent(this);
    setAccessibleName(tr("Loudness of both views"));
    connect(&span(), &AxisSpan::spanChanged, this, &SoundChart::showVisible);
    showValues(ValueRange{-1, 1});
}

void SoundChart::setSounds(std::array<SoundPeaks, 2> sounds)
{
    m_sounds = std::move(sounds);
    const double later = m_offsetS;
    span().setWhole(std::min(m_sounds[0].firstS, m_sounds[1].firstS + later),
                    std::max(endOf(m_sounds[0]), endOf(m_sounds[1]) + later));
    showVisible();
}

void SoundChart::setOffset(double offsetS)
{
    if (offsetS == m_offsetS)
        return;
    m_offsetS = offsetS;
    showVisible();
}

void SoundChart::goTo(double)
{
    m_grabbedS = m_offsetS;
}

void SoundChart::dragTo(double from, double x)
{
    setOffset(m_grabbedS + x - from);
    Q_EMIT offsetDragged(m_offsetS);
}

void SoundChart::showVisible()
{
    auto content = std::make_shared<ChartContent>();
    for (int view = 0; view < 2; ++view) {
        ChartCurve curve;
        curve.position = curve.group = view;
        curve.widthPx = 1.2;
        curve.runs = {
            visiblePeaks(m_sounds[std::size_t(view)], view == 0 ? 0 : m_offsetS, view == 0 ? 1 : -1, span())};
        content->curves.push_back(std::move(curve));
    }
    content->range = {-1, 1};
    setContent(std::move(content));
}

} // namespace odo
