// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/form_fields.h"

#include "tests/support/registered_test.h"
#include "ui/models/number_text.h"

#include <QApplication>
#include <QTest>

using namespace odo;

/// "1.234" is never taken for another number than the one who typed it sees.
class TestNumberBox : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void textsAreRead_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("number"); // NaN: none
        const auto row = [](const char *language, const char *text, double number) {
            QTest::addRow("%s %s", language, text)
                << QString::fromLatin1(language) << QString::fromUtf8(text) << number;
        };
        const double none = std::nan("");
        for (const char *language : {"de_DE", "es_ES", "fr_FR", "en_GB", "ko_KR", "zh_CN"}) {
            row(language, "12.5", 12.5);
            row(language, "12,5", 12.5);
            row(language, " -0.300 ", -0.3);
            row(language, "1234", 1234);
            row(language, "", none);
            row(language, "a", none);
            row(language, "inf", none);
            row(language, "nan", none);
        }
        row("de_DE", "1.234", none);
        row("de_DE", "-123.456", none);
        row("de_DE", "1,234", 1.234);
        row("de_DE", "1234.567", 1234.567); // no thousands are parted so
        row("de_DE", "1.234,5", 1234.5);
        row("de_DE", "1.234.567", 1234567);
        row("es_ES", "1.234", none);
        row("en_GB", "1,234", none);
        row("en_GB", "1.234", 1.234);
        row("en_GB", "1,234.5", 1234.5);
        row("fr_FR", "1,234", 1.234);
        row("fr_FR", "1.234", 1.234); // a blank parts its thousands
    }
    void textsAreRead()
    {
        QFETCH(QString, language);
        QFETCH(QString, text);
        QFETCH(double, number);
        const auto read = typedNumber(text, QLocale(language));
        QCOMPARE(read.has_value(), std::isfinite(number));
        if (read)
            QCOMPARE(*read, number);
    }

    void boxesTakeWhatIsTyped_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("shown");
        QTest::addColumn<double>("value");
        const auto row = [](const char *language, const char *typed, const char *shown, double value) {
            QTest::addRow("%s %s", language, typed)
                << QString::fromLatin1(language) << QString::fromLatin1(typed) << QString::fromLatin1(shown)
                << value;
        };
        row("de_DE", "12.5", "12,50 mm", 12.5);
        row("de_DE", "12,5", "12,50 mm", 12.5);
        row("de_DE", "1.234", "7,00 mm", 7); // the number before
        row("de_DE", "1.234,5", "1234,50 mm", 1234.5);
        row("en_GB", "12.5", "12.50 mm", 12.5);
        row("en_GB", "12,5", "12.50 mm", 12.5);
        row("en_GB", "1,234", "7.00 mm", 7);
    }
    void boxesTakeWhatIsTyped()
    {
        QFETCH(QString, language);
        QFETCH(QString, typed);
        QFETCH(QString, shown);
        QFETCH(double, value);
        NumberBox box;
        box.setLocale(QLocale(language));
        box.setRange(-5000, 5000);
        box.setSuffix(QStringLiteral(" mm"));
        box.setValue(7);
        box.show();
        box.selectAll();
        QTest::keyClicks(&box, typed);
        QTest::keyClick(&box, Qt::Key_Return);
        QCOMPARE(box.text(), shown);
        QCOMPARE(box.value(), value);
    }
};

ODOGRAPH_TEST(TestNumberBox, QApplication)
#include "tst_number_box.moc"
