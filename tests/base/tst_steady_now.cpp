// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/steady_now.h"

#include "tests/support/registered_test.h"

#include <QTest>

#include <ctime>
#include <set>
#include <thread>
#include <vector>

using namespace odo;
using namespace std::chrono_literals;

class TestSteadyNow : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// The kernel's clock that goes on while the machine sleeps; this one may have slept or not.
    void itIsTheClockThatNeverStandsStill()
    {
        const auto onTime = [] {
            timespec time{};
            clock_gettime(CLOCK_BOOTTIME, &time);
            return std::chrono::seconds(time.tv_sec) + Nanoseconds(time.tv_nsec);
        };
        const Nanoseconds before = onTime(), now = steadyNow(), after = onTime();
        // How long the machine slept is known to a millisecond.
        QVERIFY(now > before - 1ms && now < after + 1ms);
    }

    /// By many threads at once, on a machine that makes them wait: nobody thinks that it slept.
    void itDoesNotTremble()
    {
        std::vector<std::set<Nanoseconds>> answers(8);
        {
            std::vector<std::jthread> threads;
            for (auto &seen : answers)
                threads.emplace_back([&seen] {
                    for (int i = 0; i < 20000; ++i)
                        seen.insert(machineSlept());
                });
        }
        for (const auto &seen : answers)
            QVERIFY(seen == std::set<Nanoseconds>{machineSlept()});
    }
};

ODOGRAPH_TEST(TestSteadyNow, QCoreApplication)
#include "tst_steady_now.moc"
