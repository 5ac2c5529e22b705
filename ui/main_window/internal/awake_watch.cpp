// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/awake_watch.h"

#include <QTimer>

namespace odo {

AwakeWatch::AwakeWatch(std::function<bool()> isWorking, QObject *parent)
    : QObject(parent), m_isWorking(std::move(isWorking)), m_timer(new QTimer(this))
{
    connect(m_timer, &QTimer::timeout, this, &AwakeWatch::look);
    m_timer->start(step);
}

AwakeWatch::~AwakeWatch() = default;

void AwakeWatch::look()
{
    if (!m_isWorking()) {
        m_held.reset();
        m_wasTried = false;
    } else if (!m_wasTried) {
        m_held = SleepInhibitor::take("recording or computing");
        m_wasTried = true;
    }
}

} // namespace odo
