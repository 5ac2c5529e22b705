// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/paint_window.h"

#include "ui/main_window/main_window.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QPixmap>
#include <QTimer>
#include <chrono>

namespace odo {
namespace {
constexpr std::chrono::seconds longestWait{10};
constexpr std::chrono::milliseconds askEach{50};
} // namespace

QImage paintWindow(MainWindow &window, QSize size, const CancelToken &cancel)
{
    window.setAttribute(Qt::WA_DontShowOnScreen);
    window.resize(size);
    window.show();
    // Apply layouts first: the views then request images of their final size.
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
    window.grab();
    QEventLoop loop;
    QTimer limit, cancelled;
    limit.setSingleShot(true);
    QObject::connect(&limit, &QTimer::timeout, &loop, &QEventLoop::quit);
    QObject::connect(&window, &MainWindow::settled, &loop, &QEventLoop::quit);
    limit.start(longestWait);
    QObject::connect(&cancelled, &QTimer::timeout, &loop, &QEventLoop::quit);
    cancelled.start(askEach);
    while (!window.isSettled() && limit.isActive() && !cancel.isCancelled())
        loop.exec();
    QCoreApplication::processEvents();
    return window.grab().toImage();
}

} // namespace odo
