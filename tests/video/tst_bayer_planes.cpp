// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/planes/camera_planes.h"

#include "tests/support/registered_test.h"
#include "tests/video/raw_colours.h"

using namespace odo;
using namespace odo::test;

namespace {

/// What a raw sensor sees of a picture.
class RawImage
{
public:
    template <class ColourAt>
    RawImage(int width, int height, BayerOrder order, ColourAt colourAt) : m_width(width), m_height(height)
    {
        const int redX = order == BayerOrder::Grbg || order == BayerOrder::Bggr;
        const int redY = order == BayerOrder::Gbrg || order == BayerOrder::Bggr;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < stride(); ++x) {
                const Colour colour = colourAt(x, y);
                const bool red = x % 2 == redX && y % 2 == redY, blue = x % 2 != redX && y % 2 != redY;
                m_bytes.push_back(static_cast<std::uint8_t>(std::lround(red    ? colour.red
                                                                        : blue ? colour.blue
                                                                               : colour.green)));
            }
        }
    }
    PlaneView view() const { return {m_bytes.data(), m_width, m_height, stride()}; }

private:
    int stride() const { return m_width + 3; }
    int m_width, m_height;
    std::vector<std::uint8_t> m_bytes;
};

const std::pair<const char *, BayerOrder> orders[] = {{"RGGB", BayerOrder::Rggb},
                                                      {"GRBG", BayerOrder::Grbg},
                                                      {"GBRG", BayerOrder::Gbrg},
                                                      {"BGGR", BayerOrder::Bggr}};

} // namespace

class TestBayerPlanes : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void flatColoursAreThoseOfBt601_data();
    void flatColoursAreThoseOfBt601();
    void edgesLieWhereTheyAre_data();
    void edgesLieWhereTheyAre();
    void aSharpGreyEdgeHasNoPattern();
    void saysWhatItIs();
};

void TestBayerPlanes::flatColoursAreThoseOfBt601_data()
{
    QTest::addColumn<int>("order");
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    for (const auto &[name, order] : orders)
        for (const auto &[width, height] :
             {std::pair{16, 12}, std::pair{15, 11}, std::pair{2, 2}, std::pair{3, 2}})
            QTest::addRow("%s %dx%d", name, width, height) << int(order) << width << height;
}

void TestBayerPlanes::flatColoursAreThoseOfBt601()
{
    QFETCH(int, order);
    QFETCH(int, width);
    QFETCH(int, height);
    for (const Colour &colour : flatColours) {
        const RawImage raw(width, height, BayerOrder(order), [&](int, int) { return colour; });
        const Frame frame = bayerPlanes(raw.view(), BayerOrder(order), 0, {});
        const Yuv expected = closedForm(colour);
        // Half a level of rounding, and 1/64 of the correction's.
        compareWithin(frame.y, expected.y, 0.52);
        compareWithin(frame.u, expected.u, 0.52);
        compareWithin(frame.v, expected.v, 0.52);
    }
}

void TestBayerPlanes::edgesLieWhereTheyAre_data()
{
    QTest::addColumn<int>("order");
    QTest::addColumn<bool>("upright");
    QTest::addColumn<double>("place");
    for (const auto &[name, order] : orders)
        for (const bool upright : {true, false})
            for (const double place : {31.0, 31.25, 31.5, 32.3})
                QTest::addRow("%s %s %g", name, upright ? "upright" : "level", place)
                    << int(order) << upright << place;
}

/// An edge between colours that differ in all planes: luma has it in its place, chroma where its siting says.
void TestBayerPlanes::edgesLieWhereTheyAre()
{
    QFETCH(int, order);
    QFETCH(bool, upright);
    QFETCH(double, place);
    const Colour before{10, 20, 160}, after{250, 230, 30};
    const RawImage raw(64, 64, BayerOrder(order), [&](int x, int y) {
        return between(before, after, softStep((upright ? x : y) - place));
    });
    const Frame frame = bayerPlanes(raw.view(), BayerOrder(order), 0, {});
    // Rounding to a level the 14 samples of an edge 190 levels high, of which the tails round one way, moves
    // it by some 0.03 pixels.
    for (const double found : edgePositions(frame.y, upright))
        QVERIFY2(std::abs(found - place) < 0.05, qPrintable(QString::number(found)));
    // Chroma is 40 levels high at least, in samples two pixels apart; a wrong siting is off by 0.5 pixels.
    const double offset = upright ? frame.format.chromaOffsetX() : frame.format.chromaOffsetY();
    for (const PlaneView &plane : {frame.u, frame.v}) {
        for (const double found : edgePositions(plane, upright))
            QVERIFY2(std::abs(2 * found + offset - place) < 0.15,
                     qPrintable(QString::number(2 * found + offset)));
    }
}

/// Of a step from black to white every row is smoothed alike, whatever its colours: no zipper.
void TestBayerPlanes::aSharpGreyEdgeHasNoPattern()
{
    const RawImage raw(32, 16, BayerOrder::Rggb, [](int x, int) {
        return x < 15 ? Colour{0, 0, 0} : Colour{200, 200, 200};
    });
    const Frame frame = bayerPlanes(raw.view(), BayerOrder::Rggb, 0, {});
    for (int y = 0; y < 16; ++y) {
        QCOMPARE(int(frame.y.at(13, y)), 0);
        QVERIFY(std::abs(frame.y.at(14, y) - 50) <=
                9); // a quarter; but for what the colours of the sharp step seem to be
        QVERIFY(std::abs(frame.y.at(15, y) - 150) <= 9);
        QCOMPARE(frame.y.at(14, y), frame.y.at(14, 0));
        QCOMPARE(frame.y.at(15, y), frame.y.at(15, 0));
    }
}

void TestBayerPlanes::saysWhatItIs()
{
    const RawImage raw(6, 5, BayerOrder::Grbg, [](int, int) { return Colour{9, 9, 9}; });
    const Frame frame = bayerPlanes(raw.view(), BayerOrder::Grbg, 7, std::chrono::seconds(2));
    QCOMPARE(frame.index, 7);
    QCOMPARE(frame.time, Nanoseconds(2'000'000'000));
    QCOMPARE(frame.format.width, 6);
    QCOMPARE(frame.format.height, 5);
    QCOMPARE(frame.u.width, 3);
    QCOMPARE(frame.u.height, 3);
    QCOMPARE(frame.format.siting, ChromaSiting::Center);
    QVERIFY(frame.format.fullRange);
}

ODOGRAPH_TEST(TestBayerPlanes, QCoreApplication)
#include "tst_bayer_planes.moc"
