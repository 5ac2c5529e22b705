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
}

QImage paintWindow(MainWindow &window, QSize size)
{
    window.resize(size);
    window.show();
    // Layouts take effect, and the views ask for pictures of their final size, before anything is waited for.
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
    window.grab();
    QEventLoop loop;
    QTimer limit;
    limit.setSingleShot(true);
    QObject::connect(&limit, &QTimer::timeout, &loop, &QEventLoop::quit);
    QObject::connect(&window, &MainWindow::settled, &loop, &QEventLoop::quit);
    limit.start(longestWait);
    while (!window.isSettled() && limit.isActive())
        loop.exec();
    QCoreApplication::processEvents();
    return window.grab().toImage();
}

} // namespace odo
