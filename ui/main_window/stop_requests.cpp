// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/stop_requests.h"

#include "core/base/stop_signals.h"
#include "ui/main_window/main_window.h"

#include <QGuiApplication>
#include <QSocketNotifier>

namespace odo {

StopRequests::StopRequests(MainWindow &window) : m_window(window)
{
    connect(qGuiApp, &QGuiApplication::commitDataRequest, this, [this] { m_window.finishRecording(); }, Qt::DirectConnection);
    if (stopDescriptor() < 0)
        return;
    auto *notifier = new QSocketNotifier(stopDescriptor(), QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this, notifier] {
        notifier->setEnabled(false); // it stays readable
        stop();
    });
}

void StopRequests::stop()
{
    m_window.finishRecording();
    m_window.close();
    QCoreApplication::exit(); // also where a dialog is open
}

} // namespace odo
