// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bounded_queue.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <thread>

using namespace odo;

class TestBoundedQueue : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void keepsOrderAcrossThreads()
    {
        BoundedQueue<int> queue(3);
        std::thread producer([&] {
            for (int i = 0; i < 1000; ++i)
                queue.push(i);
            queue.close();
        });
        int expected = 0;
        while (const auto value = queue.pop())
            QCOMPARE(*value, expected++);
        producer.join();
        QCOMPARE(expected, 1000);
        QCOMPARE(queue.dropped(), std::uint64_t(0));
    }
    void dropsTheOldestAndCounts()
    {
        BoundedQueue<int> queue(2);
        for (int i = 0; i < 5; ++i)
            QVERIFY(queue.pushOrDrop(i));
        QCOMPARE(queue.dropped(), std::uint64_t(3));
        QCOMPARE(*queue.pop(), 3);
        QCOMPARE(*queue.pop(), 4);
    }
    void saysWhenItIsFull()
    {
        BoundedQueue<int> queue(1);
        QVERIFY(queue.tryPush(1));
        QVERIFY(!queue.tryPush(2));
        QCOMPARE(*queue.pop(), 1);
        QVERIFY(queue.tryPush(3));
        queue.close();
        QCOMPARE(*queue.pop(), 3);
        QVERIFY(!queue.tryPush(4));
        QCOMPARE(queue.dropped(), std::uint64_t(0));
    }
    void closingWakesAWaitingProducerAndConsumer()
    {
        BoundedQueue<int> full(1), empty(1);
        QVERIFY(full.push(1));
        bool taken = true, got = true;
        std::thread producer([&] { taken = full.push(2); });
        std::thread consumer([&] { got = empty.pop().has_value(); });
        full.close();
        empty.close();
        producer.join();
        consumer.join();
        QVERIFY(!taken);
        QVERIFY(!got);
        QCOMPARE(*full.pop(), 1); // what was inside can still be had
        QVERIFY(!full.pop().has_value());
    }
};

ODOGRAPH_TEST(TestBoundedQueue, QCoreApplication)
#include "tst_bounded_queue.moc"
