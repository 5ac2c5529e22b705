// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QString>
#include <QTest>

using namespace odo;

class TestError : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void isOneLine()
    {
        QCOMPARE((test::saidError(ErrorCode::Io, "file 'a\nb'", "it is full", "make room")).message(),
                 std::string("file 'a b': it is full; make room"));
        QCOMPARE((test::saidError(ErrorCode::Io, "file", "it is full", "")).message(),
                 std::string("file: it is full"));
    }

    void ofALongNameTheMiddleIsLeftOut()
    {
        const std::string longName = "project '/" + QString(3000, QChar(0x00DC)).toStdString() + "end.odo'";
        const std::string line =
            test::saidError(ErrorCode::Io, longName, "its name is too long", "choose a shorter name")
                .message();
        QVERIFY2(line.size() < 700, line.c_str());
        QVERIFY(line.starts_with("project '/\u00DC") &&
                line.ends_with("end.odo': its name is too long; choose a shorter name"));
        QVERIFY(line.find("\u2026") != std::string::npos);
        QCOMPARE(QString::fromStdString(line).toStdString(), line); // no character was cut in two
        QVERIFY(!QString::fromStdString(line).contains(QChar::ReplacementCharacter));
    }
};

ODOGRAPH_TEST(TestError, QCoreApplication)
#include "tst_error.moc"
