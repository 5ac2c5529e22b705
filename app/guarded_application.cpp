// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guarded_application.h"

#include "core/base/shortage.h"
#include "ui/models/shown_message.h"

#include <QMessageBox>
#include <QSemaphore>
#include <QThreadPool>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <memory>

namespace odo {

bool GuardedApplication::notify(QObject *receiver, QEvent *event)
{
    try {
        return QApplication::notify(receiver, event);
    } catch (...) {
        const MessageText *shortage = shortageBeingHandled();
        try {
            report(errorLine(shortageNow(cannotDoThis())));
        } catch (...) { // not even that can be reported
            endForShortage(shortage ? *shortage
                                    : ODO_TEXT("app.unexpected", "something unexpected happened"));
        }
    }
    return false;
}

void GuardedApplication::report(const QString &line)
{
    if (m_isReporting)
        return;
    m_isReporting = true;
    QTimer::singleShot(0, this, [this, line] {
        QMessageBox box(QMessageBox::Critical, applicationDisplayName(), line, QMessageBox::Ok,
                        activeWindow());
        box.setTextFormat(Qt::PlainText);
        box.exec();
        m_isReporting = false;
    });
}

void dropSenselessScales()
{
    const auto isSensible = [](const QByteArray &text) {
        bool isNumber = false;
        const double factor = text.toDouble(&isNumber);
        return isNumber && factor >= 0.25 && factor <= 8; // false for NaN
    };
    if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR") && !isSensible(qgetenv("QT_SCALE_FACTOR")))
        qunsetenv("QT_SCALE_FACTOR");
    const QByteArray screens = qgetenv("QT_SCREEN_SCALE_FACTORS"); // "1.5;2" or "name=1.5;name=2"
    const QList<QByteArray> factors = screens.split(';');
    if (!screens.isEmpty() && !std::ranges::all_of(factors, [&](const QByteArray &each) {
            return isSensible(each.mid(each.indexOf('=') + 1));
        }))
        qunsetenv("QT_SCREEN_SCALE_FACTORS");
    bool isNumber = false;
    const int dpi = qgetenv("QT_FONT_DPI").toInt(&isNumber);
    if (qEnvironmentVariableIsSet("QT_FONT_DPI") && (!isNumber || dpi < 24 || dpi > 800))
        qunsetenv("QT_FONT_DPI");
}

void keepPaintersReady()
{
    using namespace std::chrono_literals;
    // including those of threads, about which Qt prints lines of its own
    constexpr std::size_t filesOfPainting = 40;
    needFiles(filesOfPainting);
    QThreadPool &pool = *QThreadPool::globalInstance();
    pool.setExpiryTimeout(-1);
    struct Meeting
    {
        QSemaphore here, all;
    };
    const auto meeting = std::make_shared<Meeting>(); // of a thread that comes too late as well
    const int painters = pool.maxThreadCount();
    for (int i = 0; i < painters; ++i)
        pool.start([meeting] {
            meeting->here.release();
            meeting->all.acquire();
        });
    const bool areHere = meeting->here.tryAcquire(painters, std::chrono::milliseconds(5s).count());
    meeting->all.release(painters);
    if (!areHere)
        endForShortage(noFurtherThread());
}

} // namespace odo
