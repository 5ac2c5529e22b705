// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/chroma_density.h"
#include "tests/support/registered_test.h"
#include "tests/tracking/painter.h"

#include <QtTest>
#include <cmath>

using namespace odo;

class TestChroma : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void primariesAsInTheStandard_data();
    void primariesAsInTheStandard();
    void greyHasNone();
    void positionsFollowTheSiting();
    void rectanglesClip();
    void binsAndTheirCentresAgree();
    void blurKeepsTheSum();
    void otherLightReachesAlongTheRay();
    void transformTurnsAndScales();
    void overlapOfEqualAndDisjoint();
    void likenessFalls();
    void tableWeighsAgainstTheBackground();
};

void TestChroma::primariesAsInTheStandard_data()
{
    QTest::addColumn<QString>("colour");
    QTest::addColumn<int>("matrix");
    QTest::addColumn<bool>("full");
    QTest::addColumn<double>("cb");
    QTest::addColumn<double>("cr");
    using enum YuvMatrix;
    const auto row = [](const char *name, const char *colour, YuvMatrix matrix, bool full, double cb,
                        double cr) {
        QTest::newRow(name) << QString::fromLatin1(colour) << int(matrix) << full << cb << cr;
    };
    // The code values of 100 % colour bars (ITU-R BT.601, BT.709, BT.2020) and of JFIF.
    row("red 601", "#ff0000", Bt601, false, 90, 240);
    row("green 601", "#00ff00", Bt601, false, 54, 34);
    row("blue 601", "#0000ff", Bt601, false, 240, 110);
    row("red 709", "#ff0000", Bt709, false, 102, 240);
    row("green 709", "#00ff00", Bt709, false, 42, 26);
    row("blue 709", "#0000ff", Bt709, false, 240, 118);
    row("red 2020", "#ff0000", Bt2020, false, 97, 240);
    row("green 2020", "#00ff00", Bt2020, false, 47, 25);
    row("blue 2020", "#0000ff", Bt2020, false, 240, 119);
    row("red JFIF", "#ff0000", Bt601, true, 85, 255.5);
    row("yellow 601", "#ffff00", Bt601, false, 16, 146);
}

void TestChroma::primariesAsInTheStandard()
{
    QFETCH(QString, colour);
    QFETCH(int, matrix);
    QFETCH(bool, full);
    QFETCH(double, cb);
    QFETCH(double, cr);
    FrameFormat format;
    format.matrix = static_cast<YuvMatrix>(matrix);
    format.fullRange = full;
    const Chroma chroma = chromaOf(*parseColour(colour.toStdString()), format);
    // The standards' tables are rounded to whole code values.
    QVERIFY2(std::abs(chroma.x() + 128 - cb) <= 0.5, qPrintable(QString::number(chroma.x() + 128)));
    QVERIFY2(std::abs(chroma.y() + 128 - cr) <= 0.5, qPrintable(QString::number(chroma.y() + 128)));
}

void TestChroma::greyHasNone()
{
    for (const int level : {0, 1, 128, 255}) {
        const auto grey = static_cast<std::uint8_t>(level);
        QVERIFY(chromaOf({grey, grey, grey}, FrameFormat()).norm() < 1e-9);
    }
}

void TestChroma::positionsFollowTheSiting()
{
    std::mt19937 random(1);
    const auto gridOf = [&](const FrameFormat &format) {
        return ChromaGrid(Painter(format).frame(0, 0, 0, random));
    };
    const Eigen::Vector2d sample(10, 20);
    QCOMPARE(gridOf(testFormat(64, 64, ChromaSiting::Left)).toLuma(sample), Eigen::Vector2d(20, 40.5));
    QCOMPARE(gridOf(testFormat(64, 64, ChromaSiting::Center)).toLuma(sample), Eigen::Vector2d(20.5, 40.5));
    QCOMPARE(gridOf(testFormat(64, 64, ChromaSiting::TopLeft)).toLuma(sample), Eigen::Vector2d(20, 40));
    QCOMPARE(gridOf(testFormat(64, 64, ChromaSiting::Left, 1, 0)).toLuma(sample), Eigen::Vector2d(20, 20));
    QCOMPARE(gridOf(testFormat(64, 64, ChromaSiting::Left, 0, 0)).toLuma(sample), sample);
    const ChromaGrid grid = gridOf(testFormat(65, 63));
    QCOMPARE(grid.bounds().width(), 33);
    QCOMPARE(grid.bounds().height(), 32);
    QVERIFY((grid.fromLuma(grid.toLuma(sample)) - sample).norm() < 1e-12);
}

void TestChroma::rectanglesClip()
{
    const ChromaRect image{0, 0, 20, 10};
    QVERIFY((ChromaRect{25, 2, 30, 8}.clippedTo(image).isEmpty()));
    const ChromaRect part = ChromaRect{-5, 4, 7, 6}.grownBy(1).clippedTo(image);
    QCOMPARE(part.left, 0);
    QCOMPARE(part.top, 3);
    QCOMPARE(part.right, 8);
    QCOMPARE(part.bottom, 7);
}

void TestChroma::binsAndTheirCentresAgree()
{
    for (const int u : {0, 60, 128, 255}) {
        for (const int v : {3, 127, 200}) {
            const auto cu = static_cast<std::uint8_t>(u), cv = static_cast<std::uint8_t>(v);
            const Chroma centre = ChromaDensity::centreOf(ChromaDensity::binOf(cu, cv));
            QVERIFY(std::abs(centre.x() - (u - 128)) <= 1.5);
            QVERIFY(std::abs(centre.y() - (v - 128)) <= 1.5);
        }
    }
}

void TestChroma::blurKeepsTheSum()
{
    ChromaDensity density;
    density[ChromaDensity::binOf(100, 180)] = 3;
    density[ChromaDensity::binOf(0, 255)] = 2; // a corner: nothing may be lost over the edge
    density.normalise();
    density.blur(3);
    QVERIFY(std::abs(density.sum() - 1) < 1e-5);
    QVERIFY(density[ChromaDensity::binOf(104, 180)] > 0.04f);
    ChromaDensity empty;
    empty.normalise();
    QCOMPARE(empty.sum(), 0.0);
}

void TestChroma::otherLightReachesAlongTheRay()
{
    ChromaDensity density;
    density[ChromaDensity::binOf(128 + 40, 128 - 60)] = 1;
    density.blur(1);
    const ChromaDensity smeared = density.underOtherLight(0.6, 1.4);
    const auto at = [&](double gain) {
        return smeared[ChromaDensity::binOf(static_cast<std::uint8_t>(128 + gain * 40),
                                            static_cast<std::uint8_t>(128 - gain * 60))];
    };
    QVERIFY(at(1.0) > 0.15f);
    QVERIFY(at(0.7) > 0.05f && at(1.3) > 0.05f);
    QVERIFY(at(0.4) < 0.01f && at(1.8) < 0.01f);
    QVERIFY(smeared[ChromaDensity::binOf(128 + 60, 128 - 40)] < 0.01f); // another hue
}

void TestChroma::transformTurnsAndScales()
{
    ChromaDensity density;
    density[ChromaDensity::binOf(128 + 40, 128)] = 1;
    density.blur(2);
    const ChromaDensity turned = density.transformed(1.5, 3.14159265 / 2); // u → v, 40 → 60
    std::size_t highest = 0;
    for (std::size_t bin = 0; bin < ChromaDensity::binCount; ++bin) {
        if (turned[bin] > turned[highest])
            highest = bin;
    }
    const Chroma centre = ChromaDensity::centreOf(highest);
    QVERIFY(std::abs(centre.x()) < 6 && std::abs(centre.y() - 62) < 6);
}

void TestChroma::overlapOfEqualAndDisjoint()
{
    ChromaDensity a = densityOfGivenColour({60, -30});
    const ChromaDensity b = densityOfGivenColour({-50, 40});
    QVERIFY(std::abs(a.overlap(a) - 1) < 1e-5);
    QVERIFY(a.overlap(b) < 0.05);
}

void TestChroma::likenessFalls()
{
    const Chroma given(14, -31);
    QVERIFY(std::abs(likeness(given, given) - 1) < 1e-12);
    QVERIFY(std::abs(likeness(0.65 * given, given) - 1) < 1e-9); // −35 % light
    QVERIFY(std::abs(likeness(1.35 * given, given) - 1) < 1e-9);
    QVERIFY(likeness(0.2 * given, given) < 0.1);
    QVERIFY(likeness(3 * given, given) < 0.2);
    QVERIFY(likeness(-given, given) < 1e-6);
    QCOMPARE(likeness(Chroma::Zero(), given), 0.0);
}

void TestChroma::tableWeighsAgainstTheBackground()
{
    ChromaDensity robot, background;
    robot[ChromaDensity::binOf(100, 200)] = 0.5f;
    robot[ChromaDensity::binOf(128, 128)] = 0.5f;      // grey parts of the robot …
    background[ChromaDensity::binOf(128, 128)] = 1.0f; // … on a grey floor tell nothing
    const ChromaTable table(robot, background, 0.001f);
    QVERIFY(table.weight(100, 200) > 250);
    QVERIFY(table.weight(128, 128) < ChromaTable::threshold);
    QCOMPARE(int(table.weight(30, 30)), 0);
    QCOMPARE(int(ChromaTable().weight(100, 200)), 0);
}

ODOGRAPH_TEST(TestChroma, QCoreApplication)
#include "tst_chroma.moc"
