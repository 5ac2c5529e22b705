// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QImage>
#include <QTest>

using namespace odo;

using enum DrawingColour;

class TestRobotColours : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void chosenOnesAreKept_data()
    {
        using Colours = std::vector<DrawingColour>;
        using Positions = std::vector<int>;
        QTest::addColumn<Colours>("chosen");
        QTest::addColumn<Positions>("positions");
        QTest::newRow("none") << Colours{} << Positions{};
        QTest::newRow("by themselves") << Colours{Automatic, Automatic, Automatic} << Positions{0, 1, 2};
        QTest::newRow("the others get what nobody chose")
            << Colours{Automatic, Blue, Automatic} << Positions{1, 0, 2};
        QTest::newRow("the same twice") << Colours{Green, Green, Automatic} << Positions{2, 2, 0};
        QTest::newRow("more than there are")
            << Colours{Automatic, Automatic, Automatic, Automatic, Automatic, Automatic, Automatic}
            << Positions{0, 1, 2, 3, 4, 5, 0};
        QTest::newRow("all chosen and one more")
            << Colours{Blue, Vermilion, Green, Purple, Orange, SkyBlue, Automatic}
            << Positions{0, 1, 2, 3, 4, 5, 0};
    }
    void chosenOnesAreKept()
    {
        QFETCH(std::vector<DrawingColour>, chosen);
        QFETCH(std::vector<int>, positions);
        QCOMPARE(paletteIndices(chosen), positions);
    }

    void aChosenOneOverridesThePlainOne()
    {
        const QPalette palette = darkPalette();
        QCOMPARE(drawnColour(Automatic, Qt::white, palette), QColor(Qt::white));
        QCOMPARE(drawnColour(Green, Qt::white, palette), seriesColour(2, palette));
    }

    void aSceneIsDrawnAsItsRobotsSay()
    {
        TrialScene scene = *exampleScene({.frames = 20});
        scene.robots.resize(1);
        QCOMPARE(paletteIndices(scene), std::vector<int>{0});
        scene.robots[0].robot.drawingColour = Orange;
        QCOMPARE(paletteIndices(scene), std::vector<int>{4});
    }

    void everyColourHasAName()
    {
        QStringList names;
        for (const DrawingColour colour : drawingColours)
            names << drawingColourName(colour);
        QCOMPARE(names.removeDuplicates(), 0);
        QCOMPARE(drawingColourName(Automatic), QStringLiteral("automatic"));
    }

    void theKeyShowsThem()
    {
        SeriesKey key;
        key.setNames({QStringLiteral("A"), QStringLiteral("B")}, {5, 3});
        key.resize(key.sizeHint());
        const QImage image = key.grab().toImage();
        const auto has = [&image](const QColor &colour) {
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    if (image.pixelColor(x, y) == colour)
                        return true;
            return false;
        };
        QVERIFY(has(seriesColour(5, key.palette())) && has(seriesColour(3, key.palette())));
        QVERIFY(!has(seriesColour(0, key.palette())));
    }
};

ODOGRAPH_TEST(TestRobotColours, QApplication)
#include "tst_robot_colours.moc"
