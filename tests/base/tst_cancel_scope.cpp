// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/job_control.h"
#include "core/base/shortage.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <atomic>

using namespace odo;

class TestCancelScope : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whatIsCancelledEndsAsAnError()
    {
        const CancelToken cancel;
        const auto work = [&]() -> Result<int> {
            const CancelScope scope(&cancel);
            endIfCancelled();
            return 7;
        };
        QCOMPARE(orShortage(foreignWords("the work"), work).value(), 7);
        cancel.cancel();
        QCOMPARE(orShortage(foreignWords("the work"), work).error().message(),
                 std::string("the work: cancelled; nothing was changed"));
        QCOMPARE(orShortage(foreignWords("the work"), work).error().code, ErrorCode::Cancelled);
        endIfCancelled(); // outside of it nothing ends
        QVERIFY(!CancelScope::current());
    }

    void scopesLieWithinOneAnother()
    {
        const CancelToken outer, inner;
        outer.cancel();
        const CancelScope scope(&outer);
        {
            const CancelScope within(&inner);
            endIfCancelled();
            const CancelScope none(nullptr);
            inner.cancel();
            endIfCancelled();
        }
        QVERIFY_EXCEPTION_THROWN(endIfCancelled(), WorkCancelled);
    }

    void allPartsSideBySideEnd()
    {
        const CancelToken cancel;
        cancel.cancel();
        std::atomic<int> ended{0};
        const auto done = orShortage(foreignWords("the parts"), [&]() -> Result<void> {
            const CancelScope scope(&cancel);
            sideBySide(4, [&](std::size_t) {
                ++ended;
                endIfCancelled();
                --ended;
            });
            return {};
        });
        QVERIFY(!done && done.error().code == ErrorCode::Cancelled);
        QCOMPARE(ended.load(), 4);
    }
};

ODOGRAPH_TEST(TestCancelScope, QCoreApplication)
#include "tst_cancel_scope.moc"
