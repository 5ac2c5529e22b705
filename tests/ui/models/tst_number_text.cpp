// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/models/number_text.h"

#include <QApplication>
#include <QScopeGuard>
#include <QTest>
#include <cmath>
#include <limits>

using namespace odo;

class TestNumberText : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void variablesAreStoredWithAPoint()
    {
        const QLocale german(QLocale::German), english(QLocale::English, QLocale::UnitedStates);
        for (const QLocale &locale : {german, english}) {
            QCOMPARE(storedValue(QStringLiteral(" 7,4 "), locale), QStringLiteral("7.4"));
            QCOMPARE(storedValue(QStringLiteral("7.4"), locale), QStringLiteral("7.4"));
            QCOMPARE(storedValue(QStringLiteral("1.5e-3"), locale), QStringLiteral("1.5e-3"));
            QCOMPARE(storedValue(QStringLiteral("carpet, wet"), locale), QStringLiteral("carpet, wet"));
            QCOMPARE(storedValue(QStringLiteral("1,234"), locale),
                     QStringLiteral("1,234")); // one or a thousand
        }
    }
    void coordinatesAreToAMillimetre()
    {
        const QLocale english(QLocale::English, QLocale::UnitedStates);
        QCOMPARE(coordinateText(1.2043, std::nullopt, english), QStringLiteral("1204 mm"));
        QCOMPARE(coordinateText(1.2043, 0.0012, english), QStringLiteral("1204.3 ±1.2\u00a0mm"));
        setShownUnitSystem(UnitSystem::Inches);
        QCOMPARE(coordinateText(-0.0254, std::nullopt, english), QStringLiteral("-1.00 in"));
        setShownUnitSystem(UnitSystem::Millimetres);
    }
    void roundsToTheUncertainty_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("sigma");
        QTest::addColumn<QString>("text");
        QTest::newRow("one digit") << 1.8345 << 0.0231 << QStringLiteral("1.83 ±0.02");
        QTest::newRow("two when it leads with 1") << 1.8343 << 0.0143 << QStringLiteral("1.834 ±0.014");
        QTest::newRow("1.96 reads as 2") << 1.8345 << 0.0196 << QStringLiteral("1.83 ±0.02");
        QTest::newRow("trailing zeros stay") << 2.0 << 0.03 << QStringLiteral("2.00 ±0.03");
        QTest::newRow("integers") << 38.4 << 3.2 << QStringLiteral("38 ±3");
        QTest::newRow("tens") << 1234.0 << 56.0 << QStringLiteral("1230 ±60");
        QTest::newRow("larger than the value") << 0.2 << 3.0 << QStringLiteral("0 ±3");
        QTest::newRow("no minus zero") << -0.001 << 0.02 << QStringLiteral("0.00 ±0.02");
        QTest::newRow("negative") << -1.26 << 0.2 << QStringLiteral("-1.3 ±0.2");
        QTest::newRow("sigma zero is unknown") << 1.2345 << 0.0 << QStringLiteral("1.23");
        QTest::newRow("sigma not finite") << 1.2345 << std::nan("") << QStringLiteral("1.23");
        QTest::newRow("tiny") << 0.00123 << 0.0 << QStringLiteral("0.00123");
        QTest::newRow("count") << 2.0 << 0.0 << QStringLiteral("2");
        QTest::newRow("large without sigma") << 12345.6 << 0.0 << QStringLiteral("12346");
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << 1.0 << QStringLiteral("–");
    }
    void roundsToTheUncertainty()
    {
        QFETCH(double, value);
        QFETCH(double, sigma);
        QFETCH(QString, text);
        QCOMPARE(numberText(value, sigma, {}, QLocale::c()).text(), text);
    }
    void keepsTheUnitApart()
    {
        const NumberText figure = numberText(1.83, 0.02, QStringLiteral("m/s"), QLocale::c());
        QCOMPARE(figure.text(), QStringLiteral("1.83 ±0.02\u00a0m/s"));
        QCOMPARE(figure.smallPrint(), QStringLiteral("m/s ±0.02"));
    }
    void followsTheLocale()
    {
        const QLocale german(QLocale::German, QLocale::Germany);
        QCOMPARE(numberText(1234.5, 0.2, {}, german).text(), QStringLiteral("1234,5 ±0,2"));
        QCOMPARE(lengthText(0.0016, german), QStringLiteral("1,6\u00a0mm"));
    }
    void namesMetrics()
    {
        QCOMPARE(metricName("max_speed"), QStringLiteral("Top speed"));
        QCOMPARE(metricName("lap_time_2"), QStringLiteral("Lap time 2"));
        QCOMPARE(metricNumber({"stops", "1", 2, std::nullopt}, QLocale::c()).text(), QStringLiteral("2"));
        QCOMPARE(metricName("cross_track_rms"), QStringLiteral("Off the path (RMS)"));
        QCOMPARE(metricNumber({"max_turn_rate", "rad/s", M_PI, M_PI / 180}, QLocale::c()).text(),
                 QStringLiteral("180.0 ±1.0\u00a0°/s"));
        QCOMPARE(metricNumber({"path_completed", "1", 0.5, std::nullopt}, QLocale::c()).text(),
                 QStringLiteral("50.0\u00a0%"));
    }
    void followsTheUnitsThatAreShown_data()
    {
        QTest::addColumn<QString>("system");
        QTest::addColumn<QString>("speed");
        QTest::addColumn<QString>("way");
        QTest::addColumn<QString>("error");
        QTest::addColumn<QString>("place");
        QTest::newRow("mm") << QStringLiteral("mm") << QStringLiteral("1.83 ±0.02\u00a0m/s")
                            << QStringLiteral("2.540 ±0.010\u00a0m") << QStringLiteral("25.4\u00a0mm")
                            << QStringLiteral("1.23\u00a0m");
        QTest::newRow("cm") << QStringLiteral("cm") << QStringLiteral("183 ±2\u00a0cm/s")
                            << QStringLiteral("254.0 ±1.0\u00a0cm") << QStringLiteral("2.54\u00a0cm")
                            << QStringLiteral("123\u00a0cm");
        // 1.83 m/s = 6.0039 ft/s, 2.54 m = 8.3333 ft, 25.4 mm = 1 in, 1.23 m = 4.0354 ft
        QTest::newRow("in") << QStringLiteral("in") << QStringLiteral("6.00 ±0.07\u00a0ft/s")
                            << QStringLiteral("8.33 ±0.03\u00a0ft") << QStringLiteral("1.00\u00a0in")
                            << QStringLiteral("4.04\u00a0ft");
        QTest::newRow("a word that is none")
            << QStringLiteral("furlong") << QStringLiteral("1.83 ±0.02\u00a0m/s")
            << QStringLiteral("2.540 ±0.010\u00a0m") << QStringLiteral("25.4\u00a0mm")
            << QStringLiteral("1.23\u00a0m");
    }
    void followsTheUnitsThatAreShown()
    {
        QFETCH(QString, system);
        setShownUnitSystem(unitSystemFromWord(system));
        const auto back = qScopeGuard([] { setShownUnitSystem(UnitSystem::Millimetres); });
        const QLocale c = QLocale::c();
        QTEST(speedText(1.83, 0.02, c), "speed");
        QTEST(metricNumber({"max_speed", "m/s", 1.83, 0.02}, c).text(), "speed");
        QTEST(metricNumber({"path_length", "m", 2.54, 0.01}, c).text(), "way");
        QTEST(lengthText(0.0254, c), "error");
        const Metric offPath{"cross_track_rms", "mm", 25.4, 2.54};
        QVERIFY(metricNumber(offPath, c).text().endsWith(shownUnits().length.name));
        QVERIFY(std::abs(metricNumber(offPath, c).value.toDouble() - 0.0254 * shownUnits().length.perSi) <
                0.001 * shownUnits().length.perSi);
        QTEST(distanceText(1.23, c), "place");
        QCOMPARE(metricNumber({"duration", "s", 1.5, 0.1}, c).text(), QStringLiteral("1.50 ±0.10\u00a0s"));
    }
    void writesTimes()
    {
        using namespace std::chrono_literals;
        QCOMPARE(timeCode(3267ms), QStringLiteral("00:03.267"));
        QCOMPARE(timeCode(0ns), QStringLiteral("00:00.000"));
        QCOMPARE(timeCode(3599999600us), QStringLiteral("1:00:00.000"));
        QCOMPARE(timeCode(-1500ms), QStringLiteral("-00:01.500"));
        QCOMPARE(secondsText(3267ms, QLocale::c()), QStringLiteral("3.27\u00a0s"));
    }
};

ODOGRAPH_TEST(TestNumberText, QApplication)
#include "tst_number_text.moc"
