// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <utility>

namespace odo {

/// The longest that anything kept the event loop of this thread busy. CPU time, which other programs cannot prolong.
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
