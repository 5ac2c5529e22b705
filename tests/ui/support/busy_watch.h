// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <utility>

namespace odo {

/// What a test allows anything to keep the event loop: 50 ms when ODOGRAPH_ALONE is set. Otherwise six times
/// that, for beside other programs, which take the caches and pages from it, work of 20, 48 and 70 ms took
/// 51, 148 and 178 ms of CPU time, and machines differ by two; and more under a sanitizer.
double longestAllowedMs();

/// The longest that anything kept the event loop of this thread busy. CPU time, which other programs cannot
/// prolong.
class BusyWatch : public QObject
{
public:
    BusyWatch();
    double longestMs() const { return m_longestMs; }
    /// The longest since it was taken last.
    double takeLongestMs() { return std::exchange(m_longestMs, 0); }

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    double m_lastMs = 0, m_longestMs = 0;
};

} // namespace odo
