// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>

namespace odo {

/// The window's application: an exception in an event ends that event, not the program, and is shown in a
/// box.
class GuardedApplication : public QApplication
{
public:
    using QApplication::QApplication;
    bool notify(QObject *receiver, QEvent *event) override;

private:
    void report(const QString &line);

    bool m_isReporting = false; ///< one at a time: what fails at each painting would open boxes without end
};

/// Before an application is made: settings of the environment by which Qt ends the program or shows nothing,
/// because they are no numbers or beyond all sense, are dropped.
void dropSenselessScales();

/// Once there is an application that paints: Qt paints on threads of its pool, and waits for ever if one
/// cannot be started. They are started now, and stay. Ends the program (endForShortage) if they cannot be
/// started: Qt would wait for them at the end, too.
void keepPaintersReady();

} // namespace odo
