// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/units.h"

#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QTest>
#include <clocale>

using namespace odo;

class TestUnits : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void readsLengths_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("metres");
        QTest::newRow("bare number is mm") << "25" << 0.025;
        QTest::newRow("mm") << "25mm" << 0.025;
        QTest::newRow("cm") << "2.5cm" << 0.025;
        QTest::newRow("m") << "0.3m" << 0.3;
    }
    void readsLengths()
    {
        QFETCH(QString, text);
        QFETCH(double, metres);
        const auto length = parseLengthM(text.toStdString());
        QVERIFY(length.has_value());
        QVERIFY(std::abs(*length - metres) < 1e-12);
    }
    void refusesWhatIsNoLength_data()
    {
        QTest::addColumn<QString>("text");
        for (const char *text : {"", "mm", "1,5mm", "nan", "inf", "12 in", "1e999", "0x10", "--3"})
            QTest::newRow(text) << text;
    }
    void refusesWhatIsNoLength()
    {
        QFETCH(QString, text);
        const auto length = parseLengthM(text.toStdString());
        QVERIFY(!length.has_value());
        QCOMPARE(length.error().code, ErrorCode::InvalidInput);
        QVERIFY(length.error().message().find("write it like 25mm") != std::string::npos);
    }
    void numbersIgnoreTheLocale()
    {
        // With a decimal comma in force std::stod would read 1.
        std::setlocale(LC_ALL, "de_DE.UTF-8");
        QCOMPARE(parseNumber("1.5").value(), 1.5);
        QCOMPARE(formatNumber(-1234.567, 2), std::string("-1234.57"));
        std::setlocale(LC_ALL, "C");
    }
    void coloursRoundTrip()
    {
        const auto colour = parseColour("#d72328");
        QVERIFY(colour.has_value());
        QCOMPARE(int(colour->red), 0xd7);
        QCOMPARE(colour->toString(), std::string("#d72328"));
        for (const char *text : {"d72328", "#d7232", "#d7232g", "#d72328ff", "red"})
            QVERIFY(!parseColour(text).has_value());
    }
    void errorsAreOneLine()
    {
        const Error error = test::saidError(ErrorCode::Io, "a\nb", "c\td", "e");
        QCOMPARE(error.message(), std::string("a b: c d; e"));
    }
};

ODOGRAPH_TEST(TestUnits, QCoreApplication)
#include "tst_units.moc"
