// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/shortage.h"

#include "tests/fault/scarce.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QTest>
#include <atomic>
#include <new>
#include <stdexcept>
#include <system_error>

using namespace odo;
using namespace odo::test;

/// What the standard library throws where this computer has run out of something.
class TestShortage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aShortageIsAnError_data()
    {
        QTest::addColumn<int>("code"); // of the system; 0: bad_alloc
        QTest::addColumn<QByteArray>("why");
        QTest::newRow("memory") << 0 << QByteArray("this computer does not have enough free memory for it");
        QTest::newRow("memory of the system")
            << ENOMEM << QByteArray("this computer does not have enough free memory for it");
        QTest::newRow("threads") << EAGAIN << QByteArray("this computer cannot start another thread");
        QTest::newRow("files") << EMFILE << QByteArray("too many files are open");
        QTest::newRow("files of all programs") << ENFILE << QByteArray("too many files are open");
    }
    void aShortageIsAnError()
    {
        QFETCH(int, code);
        QFETCH(QByteArray, why);
        const auto result = orShortage(foreignWords("the work"), [code]() -> Result<int> {
            if (code == 0)
                throw std::bad_alloc();
            throw std::system_error(code, std::generic_category());
        });
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::Unavailable);
        QCOMPARE(result.error().message(),
                 "the work: " + why.toStdString() +
                     "; what was saved is safe; close other programs and try again");
    }

    void allElseIsAnErrorToo()
    {
        QCOMPARE(orShortage(foreignWords(""), []() -> Result<int> { return 7; }).value(), 7);
        QCOMPARE(orShortage(foreignWords(""),
                            []() -> Result<int> { return test::saidFailure(ErrorCode::Io, "a", "b", "c"); })
                     .error()
                     .what.english(),
                 std::string("a"));
        const auto unexpected = orShortage(foreignWords("the work"),
                                           []() -> Result<int> { throw std::logic_error("no such row"); });
        QCOMPARE(unexpected.error().code, ErrorCode::Internal);
        QCOMPARE(unexpected.error().message(),
                 std::string("the work: something unexpected happened (no such row); what was saved is safe; "
                             "try again, and report it if it happens again"));
        QCOMPARE(orShortage(foreignWords(""), []() -> Result<int> { throw 7; }).error().why.english(),
                 std::string("something unexpected happened (an unknown exception)"));
    }

    void aThreadThatIsNotToBeHadIsAnError()
    {
        std::atomic<int> done = 0;
        auto thread = startThread(foreignWords("the work"), [&done] { ++done; });
        QVERIFY(thread);
        thread->join();
        const FailingRequest none(Scarce::Threads, 1);
        const auto refused = startThread(foreignWords("the work"), [&done] { ++done; });
        QVERIFY(none.hasFailed());
        QVERIFY(!refused);
        QCOMPARE(refused.error().message(), noThread(foreignWords("the work")).message());
        QCOMPARE(done.load(), 1);
    }

    /// Whichever thread is refused.
    void partsAreAllDone()
    {
        for (std::uint64_t n = 0; n < 6; ++n) {
            std::vector<int> done(4, 0);
            const FailingRequest failing(Scarce::Threads, n);
            sideBySide(done.size(), [&done](std::size_t part) { ++done[part]; });
            QCOMPARE(done, std::vector<int>(4, 1));
            QCOMPARE(failing.hasFailed(), n > 0 && n < 5);
        }
        sideBySide(0, [](std::size_t) { QFAIL("there is no part"); });
    }

    void whatAPartThrowsComesOut()
    {
        std::atomic<int> done = 0;
        const auto work = [&done](std::size_t part) {
            if (part == 1)
                throw std::bad_alloc();
            ++done;
        };
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, sideBySide(4, work));
        QCOMPARE(done.load(), 3);
    }
};

ODOGRAPH_TEST(TestShortage, QCoreApplication)
#include "tst_shortage.moc"
