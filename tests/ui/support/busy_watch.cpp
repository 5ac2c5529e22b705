// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/busy_watch.h"

#include "tests/support/patience.h"

#include <QtGlobal>
#include <algorithm>
#include <ctime>

namespace odo {
namespace {

double threadCpuMs()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

} // namespace

double longestAllowedMs()
{
    return 50 * test::slowness * (qEnvironmentVariableIsSet("ODOGRAPH_ALONE") ? 1 : 6);
}

BusyWatch::BusyWatch() : m_lastMs(threadCpuMs())
{
    startTimer(0);
}

void BusyWatch::timerEvent(QTimerEvent *)
{
    const double now = threadCpuMs();
    m_longestMs = std::max(m_longestMs, now - m_lastMs);
    m_lastMs = now;
}

} // namespace odo
