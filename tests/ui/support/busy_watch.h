// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace odo {

/// The longest that anything kept the event loop of this thread busy. CPU time, which other programs cannot prolong.
class BusyWatch : public QObject
{
public:
    BusyWatch();
    double longestMs() const { return m_longestMs; }

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    double m_lastMs = 0, m_longestMs = 0;
};

} // namespace odo
