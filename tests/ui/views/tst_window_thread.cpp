// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/chart_image.h"

#include "core/base/job_control.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <QThread>
#include <atomic>
#include <stdexcept>
#include <thread>

using namespace odo;

class TestWindowThread : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void onItsOwnThreadItIsDoneAtOnce()
    {
        bool isDone = false;
        onWindowThread([&] { isDone = true; });
        QVERIFY(isDone);
    }
    void anotherThreadWaitsForIt()
    {
        std::atomic<QThread *> where = nullptr;
        std::atomic<bool> goesOn = false, wasDoneBefore = false;
        std::thread worker([&] {
            onWindowThread([&] { where = QThread::currentThread(); });
            wasDoneBefore = where != nullptr;
            goesOn = true;
        });
        QTRY_VERIFY(goesOn);
        worker.join();
        QCOMPARE(where.load(), QThread::currentThread());
        QVERIFY(wasDoneBefore);
    }
    void whatItThrowsIsThrownThere()
    {
        std::atomic<bool> goesOn = false;
        std::string why;
        std::thread worker([&] {
            try {
                onWindowThread([] { throw std::runtime_error("no chart"); });
            } catch (const std::runtime_error &error) {
                why = error.what();
            }
            goesOn = true;
        });
        QTRY_VERIFY(goesOn);
        worker.join();
        QCOMPARE(why, std::string("no chart"));
    }
    void whoCancelsMayWaitForTheThreadThatWaits()
    {
        const CancelToken cancel;
        bool isEnded = false, isDone = false;
        std::thread worker([&] {
            const CancelScope scope(&cancel);
            try {
                onWindowThread([&] { isDone = true; });
            } catch (const WorkCancelled &) {
                isEnded = true;
            }
        });
        cancel.cancel();
        worker.join(); // on the window's thread, which meanwhile handles no event
        QVERIFY(isEnded);
        QCoreApplication::processEvents();
        QVERIFY(!isDone); // nobody waits for it any more
    }
};

ODOGRAPH_TEST(TestWindowThread, QCoreApplication)
#include "tst_window_thread.moc"
