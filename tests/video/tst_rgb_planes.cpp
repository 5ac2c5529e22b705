// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/planes/camera_planes.h"

#include "tests/support/registered_test.h"
#include "tests/video/raw_colours.h"

using namespace odo;
using namespace odo::test;

namespace {

/// Packed colours, with some bytes between the rows.
class PackedImage
{
public:
    template <class ColourAt>
    PackedImage(int width, int height, RgbView::Order order, ColourAt colourAt)
        : m_view{nullptr, width, height, 3 * width + 5, order}
    {
        m_bytes.resize(static_cast<std::size_t>(m_view.stride) * static_cast<std::size_t>(height), 77);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const Colour colour = colourAt(x, y);
                std::uint8_t *pixel = m_bytes.data() + y * m_view.stride + 3 * x;
                const bool redFirst = order == RgbView::Order::Rgb;
                pixel[redFirst ? 0 : 2] = static_cast<std::uint8_t>(std::lround(colour.red));
                pixel[1] = static_cast<std::uint8_t>(std::lround(colour.green));
                pixel[redFirst ? 2 : 0] = static_cast<std::uint8_t>(std::lround(colour.blue));
            }
        }
        m_view.data = m_bytes.data();
    }
    const RgbView &view() const { return m_view; }

private:
    RgbView m_view;
    std::vector<std::uint8_t> m_bytes;
};

} // namespace

class TestRgbPlanes : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void flatColoursAreThoseOfBt601_data()
    {
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        for (const auto order : {RgbView::Order::Rgb, RgbView::Order::Bgr})
            for (const auto &[width, height] : {std::pair{8, 6}, std::pair{7, 5}, std::pair{1, 1}})
                QTest::addRow("%s %dx%d", order == RgbView::Order::Rgb ? "RGB" : "BGR", width, height)
                    << int(order) << width << height;
    }
    void flatColoursAreThoseOfBt601()
    {
        QFETCH(int, order);
        QFETCH(int, width);
        QFETCH(int, height);
        for (const Colour &colour : flatColours) {
            const PackedImage image(width, height, RgbView::Order(order), [&](int, int) { return colour; });
            const Frame frame = rgbPlanes(image.view(), 0, {});
            const Yuv expected = closedForm(colour);
            compareWithin(frame.y, expected.y, 0.51); // rounding to a level
            compareWithin(frame.u, expected.u, 0.51);
            compareWithin(frame.v, expected.v, 0.51);
        }
    }

    void edgesLieWhereTheyAre_data()
    {
        QTest::addColumn<bool>("upright");
        QTest::addColumn<double>("place");
        for (const bool upright : {true, false})
            for (const double place : {31.0, 31.25, 31.5, 32.3})
                QTest::addRow("%s %g", upright ? "upright" : "level", place) << upright << place;
    }
    void edgesLieWhereTheyAre()
    {
        QFETCH(bool, upright);
        QFETCH(double, place);
        const Colour before{10, 20, 160}, after{250, 230, 30};
        const PackedImage image(64, 64, RgbView::Order::Rgb, [&](int x, int y) {
            return between(before, after, softStep((upright ? x : y) - place));
        });
        const Frame frame = rgbPlanes(image.view(), 3, std::chrono::seconds(1));
        // Rounding to a level the 14 samples of an edge 190 levels high, of which the tails round one way,
        // moves it by some 0.03 pixels.
        for (const double found : edgePositions(frame.y, upright))
            QVERIFY2(std::abs(found - place) < 0.05, qPrintable(QString::number(found)));
        // Chroma is 40 levels high at least, in samples two pixels apart; a wrong siting is off by 0.5
        // pixels.
        const double offset = upright ? frame.format.chromaOffsetX() : frame.format.chromaOffsetY();
        for (const PlaneView &plane : {frame.u, frame.v}) {
            for (const double found : edgePositions(plane, upright))
                QVERIFY2(std::abs(2 * found + offset - place) < 0.15,
                         qPrintable(QString::number(2 * found + offset)));
        }
        QCOMPARE(frame.index, 3);
        QCOMPARE(frame.time, Nanoseconds(1'000'000'000));
    }

    void monoHasItsLumaAndNoColour()
    {
        std::vector<std::uint8_t> bytes(8 * 3);
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<std::uint8_t>(10 * i);
        const Frame frame = monoPlanes({bytes.data(), 5, 3, 8}, 0, {});
        QCOMPARE(frame.format.width, 5);
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 5; ++x)
                QCOMPARE(frame.y.at(x, y), bytes[std::size_t(8 * y + x)]);
        QCOMPARE(frame.u.width, 3);
        compareWithin(frame.u, 128, 0);
        compareWithin(frame.v, 128, 0);
        QVERIFY(frame.format.fullRange);
    }
};

ODOGRAPH_TEST(TestRgbPlanes, QCoreApplication)
#include "tst_rgb_planes.moc"
