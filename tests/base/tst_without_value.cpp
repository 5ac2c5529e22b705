// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QTest>

using namespace odo;

class TestWithoutValue : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void keepsWhetherItWentWellAndWhatWentWrong()
    {
        QVERIFY(withoutValue(Result<int>(7)).has_value());
        QVERIFY(withoutValue(Result<void>()).has_value());
        const Result<void> failed = withoutValue(
            Result<int>(test::saidFailure(ErrorCode::NotFound, "class 3", "it is gone", "look again")));
        QVERIFY(!failed);
        QVERIFY(failed.error().code == ErrorCode::NotFound);
        QCOMPARE(failed.error().message(), std::string("class 3: it is gone; look again"));
    }
};

ODOGRAPH_TEST(TestWithoutValue, QCoreApplication)
#include "tst_without_value.moc"
