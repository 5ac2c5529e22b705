// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tracking/textured_floor.h"

#include "core/tracking/internal/difference_windows.h"
#include "core/tracking/internal/region_edge.h"
#include "tests/support/registered_test.h"

#include <QTest>

#include <array>
#include <cmath>

using namespace odo;
using namespace odo::test;

namespace {

const FrameFormat format = testFormat(320, 240);
const PixelRect image{0, 0, 320, 240};

/// A floor that varies by one code value.
Background backgroundOf(const Painter &floor)
{
    std::mt19937 random(1);
    const Frame frame = floor.frame(0, 0, 0, random);
    const auto planeOf = [](const PlaneView &from) {
        Background::Plane plane{from.width, from.height, {}, {}};
        for (int y = 0; y < from.height; ++y)
            plane.values.insert(plane.values.end(), from.row(y), from.row(y) + from.width);
        plane.sigmas.assign(plane.values.size(), std::uint8_t(1 / Background::sigmaUnit));
        return plane;
    };
    return {frame.format, planeOf(frame.y), planeOf(frame.u), planeOf(frame.v)};
}

/// Two browns, in squares of 4 pixels.
Painter chequeredFloor()
{
    Painter floor(format, {150, 140, 120});
    for (int y = 0; y < format.height; y += 8)
        for (int x = y % 16 == 0 ? 0 : 4; x < format.width; x += 8)
            floor.rectangle({x - 0.5, y - 0.5}, {x + 3.5, y + 3.5}, {110, 103, 88});
    return floor;
}

/// Squares of 8 pixels in two colours, as far as a rectangle reaches.
void chequer(Painter &floor, const PixelRect &where, RgbColour one, RgbColour other)
{
    constexpr int side = 8;
    for (int y = where.y0; y < where.y1; y += side)
        for (int x = where.x0; x < where.x1; x += side)
            floor.rectangle({x - 0.5, y - 0.5}, {x + side - 0.5, y + side - 0.5},
                            (x + y) / side % 2 == 0 ? one : other);
}

/// By how much a codec may err in the chroma beside a pixel: a twentieth of what it varies by in its patch.
double codedAt(const ComparedWindow &w, int x, int y)
{
    double most = 0;
    for (const int py : {std::max(0, y - 3), std::min(w.height() - 1, y + 3)})
        for (const int px : {std::max(0, x - 3), std::min(w.width() - 1, x + 3)})
            most = std::max({most, std::abs(double(w.behind(px, py).u) - double(w.behind(x, y).u)),
                             std::abs(double(w.behind(px, py).v) - double(w.behind(x, y).v))});
    return 0.05 * most;
}

enum class Verdict { Shade, OtherHue, Flat, Unclear };

/// What a pixel that is as dark as in a shadow is, by all such pixels of the 7 x 7 around it; unclear where
/// it nearly is something else.
Verdict verdictOf(const ComparedWindow &w, int x, int y)
{
    double n = 0, offU = 0, offV = 0, seen = 0, seen2 = 0, behind = 0, behind2 = 0;
    for (int py = std::max(0, y - 3); py <= std::min(w.height() - 1, y + 3); ++py)
        for (int px = std::max(0, x - 3); px <= std::min(w.width() - 1, x + 3); ++px) {
            if (!w.darkened().at(px, py))
                continue;
            const PixelColour now = w.seen(px, py), floor = w.behind(px, py);
            const double logNow = std::log(double(now.luma)), logFloor = std::log(double(floor.luma)),
                         ratio = double(now.luma) / double(floor.luma);
            n += 1;
            offU += double(now.u) - ratio * double(floor.u);
            offV += double(now.v) - ratio * double(floor.v);
            seen += logNow;
            seen2 += logNow * logNow;
            behind += logFloor;
            behind2 += logFloor * logFloor;
        }
    if (n < 16)
        return Verdict::Shade;
    // A dark robot mirrored in the floor takes neutral light from it, up to a fifth, and leaves its hue
    // purer.
    const PixelColour here = w.behind(x, y);
    const double luma = double(w.seen(x, y).luma), u = double(here.u), v = double(here.v),
                 darker = std::clamp(1 - luma / double(here.luma), 0.0, 0.2),
                 purer = std::clamp((offU * u + offV * v) / (n * (u * u + v * v)), 0.0, darker),
                 off = std::max(std::abs(offU / n - purer * u), std::abs(offV / n - purer * v)) -
                       codedAt(w, x, y);
    const double variance = seen2 / n - seen * seen / (n * n),
                 varianceBehind = behind2 / n - behind * behind / (n * n);
    const double flat = 0.25 * varianceBehind - variance,
                 textured = varianceBehind * luma * luma / (6.0 * double(w.lumaNoise2(x, y))) - 1;
    if (std::abs(off - 2.2) < 0.01 ||
        (off < 2.2 && (std::abs(flat) < 1e-4 || (flat > 0 && std::abs(textured) < 0.01))))
        return Verdict::Unclear;
    return off > 2.2 ? Verdict::OtherHue : flat > 0 && textured > 0 ? Verdict::Flat : Verdict::Shade;
}

Frame frameOf(const Painter &painter, double noise)
{
    std::mt19937 random(2);
    return painter.frame(0, 0, noise, random);
}

/// A frame beside its background, in the first window around what differs.
struct ComparedFrame
{
    DifferenceLattice lattice;
    ComparedWindow window;

    ComparedFrame(const Frame &frame, const Background &background) : lattice(background), window(background)
    {
        lattice.compare(frame, background);
        window.compare(frame, lattice.gain(), windowsAround(lattice.differences(), image).front().front());
    }
};

} // namespace

class TestComparedWindow : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void noiseHasNoWindow()
    {
        const Painter floor = texturedFloor(format);
        const Background background = backgroundOf(floor);
        DifferenceLattice lattice(background);
        lattice.compare(frameOf(floor, 1), background);
        QVERIFY(windowsAround(lattice.differences(), image).empty());
        QVERIFY(std::abs(lattice.gain().factor - 1) < 0.01F);
    }

    /// A black rectangle: a window around it, in which exactly its pixels differ, in any light.
    void whatDiffersIsFound_data()
    {
        QTest::addColumn<double>("light");
        QTest::newRow("in the same light") << 1.0;
        QTest::newRow("in less light") << 0.8;
    }
    void whatDiffersIsFound()
    {
        QFETCH(double, light);
        const Painter floor = texturedFloor(format);
        const Background background = backgroundOf(floor);
        Painter painter = floor;
        painter.rectangle({99.5, 79.5}, {149.5, 119.5}, {15, 15, 15});
        painter.light(light);
        const Frame frame = frameOf(painter, 0);
        DifferenceLattice lattice(background);
        lattice.compare(frame, background);
        QVERIFY(std::abs(double(lattice.gain().factor) - light) < 0.01);
        const auto groups = windowsAround(lattice.differences(), image);
        QCOMPARE(groups.size(), std::size_t(1));
        QCOMPARE(groups.front().size(), std::size_t(1));
        ComparedWindow window(background);
        window.compare(frame, lattice.gain(), groups.front().front());
        const PixelRect around{100, 80, 150, 120};
        QVERIFY(window.rect().contains(around));
        // Chroma is at half the resolution, so a pixel beside the edge may differ by its chroma.
        for (int y = 0; y < window.height(); ++y)
            for (int x = 0; x < window.width(); ++x) {
                const int px = window.rect().x0 + x, py = window.rect().y0 + y;
                const bool isIn = around.contains({px, py, px + 1, py + 1}),
                           isNear = PixelRect{98, 78, 152, 122}.contains({px, py, px + 1, py + 1});
                QVERIFY(window.differs().at(x, y) == isIn || (isNear && !isIn));
                if (isIn)
                    QVERIFY(window.plain().at(x, y) &&
                            std::abs(window.seen(x, y).luma -
                                     float(frame.y.at(px, py) - lattice.gain().black)) < 1e-3F);
            }
    }

    /// The edge of a bright rectangle between pixels, by how much of each pixel it covers.
    void anEdgeIsMeasuredBetweenPixels()
    {
        const Painter floor(format, {80, 80, 80});
        const Background background = backgroundOf(floor);
        for (const double shift : {0.0, 0.25, 0.5, 0.75}) {
            Painter painter = floor;
            const Eigen::Vector2d low(99.5 + shift, 79.5 + shift / 2), high(149.5 + shift, 119.5 + shift / 2);
            painter.rectangle(low, high, {220, 220, 220});
            const Frame frame = frameOf(painter, 0);
            const ComparedFrame compared(frame, background);
            const ComparedWindow &window = compared.window;
            FloorShade shade;
            shade.find(window);
            QVERIFY(shade.shade().isEmpty() && shade.byHue().isEmpty());
            RegionEdge edge;
            edge.measure(window, shade, {0, 0, window.width(), window.height()}, window.plain(),
                         BitMask(window.width(), window.height()));
            Eigen::Vector2d least(1e9, 1e9), most(-1e9, -1e9);
            for (const Eigen::Vector2d &point : edge.points()) {
                least = least.cwiseMin(point);
                most = most.cwiseMax(point);
            }
            // A code value of 150 is what rounding may hide of a pixel. Between a pixel of which a part c is
            // covered and one that is covered wholly, the line through both crosses one half (c/2 - c²) / (1
            // - c) from the edge: 0.083 px at a quarter, and no more.
            const double mostPx = shift == 0 ? 0.03 : 0.12;
            QVERIFY2((least - low).norm() < mostPx && (most - high).norm() < mostPx,
                     qPrintable(QStringLiteral("%1 %2").arg((least - low).norm()).arg((most - high).norm())));
            QVERIFY(edge.meanChroma().norm() < 0.5);
        }
    }

    /// Half of the floor's light: shadow where the floor's texture shows through, and none where it does not.
    void shadowsShowTheTexture()
    {
        const Painter floor = chequeredFloor();
        const Background background = backgroundOf(floor);
        const Eigen::Vector2d low(99.5, 79.5), high(149.5, 119.5);
        for (const bool isShadow : {true, false}) {
            Painter painter = floor;
            if (isShadow)
                painter.shade(low, high, 0.6);
            else
                painter.rectangle(low, high, {90, 84, 72}); // as brown as the floor, but flat
            const Frame frame = frameOf(painter, 0);
            const ComparedFrame compared(frame, background);
            const ComparedWindow &window = compared.window;
            FloorShade shade;
            shade.find(window);
            const double share = double(shade.shade().count()) / (50 * 40);
            QVERIFY2(isShadow ? share > 0.9 : share < 0.2,
                     qPrintable(QStringLiteral("%1 %2").arg(isShadow).arg(share)));
        }
    }

    /// A ramp by three code values a sample: the noise has 0.08 of what it rises by over two samples.
    void theChromasNoiseGrowsWithItsSlope()
    {
        Background background = backgroundOf(Painter(format, {80, 80, 80}));
        for (int x = 0; x < background.u.width; ++x)
            for (int y = 0; y < background.u.height; ++y)
                background.u.values[std::size_t(y * background.u.width + x)] =
                    std::uint8_t(60 + 3 * (x % 40));
        const double noise2 = 1 + 0.08 * 0.08 * 6 * 6;
        QVERIFY(std::abs(double(noise2At(background.u, 1, 20, 50)) - noise2) < 1e-4);
        QVERIFY(std::abs(double(noise2At(background.u, 0.5F, 20, 50)) - 1 - (noise2 - 1) / 4) < 1e-4);
        QCOMPARE(noise2At(background.v, 1, 20, 50), 1.0F);
        // of the noisier plane
        const int inverse = BackgroundNoise(background).chromaRow(50)[20];
        QVERIFY(std::abs(inverse - BackgroundNoise::unit / std::sqrt(noise2)) < 1);
    }

    /// In a row of any length, at the frame's borders too, where a slope is that to the sample itself.
    void rowsOfNoiseAreThoseOfTheirSamples()
    {
        Background background = backgroundOf(Painter(format, {80, 80, 80}));
        std::mt19937 random(7);
        for (std::uint8_t &value : background.y.values)
            value = std::uint8_t(random());
        for (std::uint8_t &sigma : background.y.sigmas)
            sigma = std::uint8_t(8 + random() % 40);
        const Background::Plane &plane = background.y;
        const auto at = [&](int x, int y) {
            return int(plane.row(std::clamp(y, 0, plane.height - 1))[std::clamp(x, 0, plane.width - 1)]);
        };
        constexpr double factor = 1.25;
        for (const int y : {0, 1, 77, plane.height - 1}) {
            for (const auto &[first, last] :
                 {std::pair(0, plane.width), std::pair(0, 1), std::pair(5, 18),
                  std::pair(plane.width - 3, plane.width), std::pair(plane.width - 1, plane.width)}) {
                std::vector<float> noise2(std::size_t(last - first) + 1, -1.0F);
                noise2InRow(plane, float(factor), y, first, last, noise2.data());
                for (int x = first; x < last; ++x) {
                    const double sigma = plane.sigmaRow(y)[x] / 8.0, dx = at(x + 1, y) - at(x - 1, y),
                                 dy = at(x, y + 1) - at(x, y - 1), jitter = 0.08 * factor,
                                 expected = sigma * sigma + jitter * jitter * (dx * dx + dy * dy);
                    QVERIFY2(std::abs(double(noise2[std::size_t(x - first)]) - expected) < 1e-4 * expected,
                             qPrintable(QStringLiteral("%1 %2").arg(x).arg(y)));
                }
                QCOMPARE(noise2.back(), -1.0F); // nothing is written beyond
            }
        }
    }

    /// A codec leaves errors where the floor's colours change: there a shadow may be a little off in its
    /// chroma, and on a floor of one colour it may not.
    void aCodedPatternMayBeOffInItsShadow()
    {
        const PixelRect shaded{96, 80, 160, 128};
        for (const bool hasPattern : {true, false}) {
            const RgbColour red{150, 90, 90}, blue{90, 90, 150}, middle{110, 110, 110};
            Painter floor(format, middle);
            if (hasPattern)
                chequer(floor, image, red, blue);
            Painter painter = floor;
            // 0.7 of the light, and 3 code values of Cb more
            chequer(painter, shaded, hasPattern ? RgbColour{103, 62, 69} : RgbColour{75, 76, 83},
                    hasPattern ? RgbColour{61, 62, 111} : RgbColour{75, 76, 83});
            const Background background = backgroundOf(floor);
            const Frame frame = frameOf(painter, 0);
            const ComparedFrame compared(frame, background);
            FloorShade shade;
            shade.find(compared.window);
            const double share = double(shade.shade().count()) / (64 * 48);
            QVERIFY2(hasPattern ? share > 0.75 : share < 0.2,
                     qPrintable(QStringLiteral("%1 %2").arg(hasPattern).arg(share)));
        }
    }

    /// A shadow, a surface as brown as the floor and two that nearly are, in any light: each pixel is judged
    /// by those around it.
    void eachPatchIsJudged_data() { whatDiffersIsFound_data(); }
    void eachPatchIsJudged()
    {
        QFETCH(double, light);
        const Painter floor = chequeredFloor();
        const Background background = backgroundOf(floor);
        Painter painter = floor;
        painter.shade({79.5, 59.5}, {119.5, 99.5}, 0.6);
        painter.rectangle({121.5, 59.5}, {159.5, 99.5}, {90, 84, 72});
        for (int x = 140; x < 156; x += 8)
            // about half as much texture as the floor's
            painter.rectangle({x - 0.5, 59.5}, {x + 3.5, 99.5}, {78, 73, 62});
        painter.rectangle({79.5, 103.5}, {119.5, 149.5}, {84, 86, 74});
        painter.rectangle({119.5, 103.5}, {159.5, 149.5}, {88, 84, 77});
        painter.light(light);
        const Frame frame = frameOf(painter, 1);
        const ComparedFrame compared(frame, background);
        const ComparedWindow &window = compared.window;
        FloorShade shade;
        for (int round = 0; round < 2; ++round) // the second with the memory of the first
            shade.find(window);
        std::array<int, 4> count{};
        QStringList wrong;
        window.darkened().forEach([&](int x, int y) {
            const Verdict verdict = verdictOf(window, x, y);
            ++count[std::size_t(verdict)];
            if (verdict != Verdict::Unclear && (shade.shade().at(x, y) != (verdict == Verdict::Shade) ||
                                                shade.byHue().at(x, y) != (verdict == Verdict::OtherHue)))
                wrong.append(QStringLiteral("(%1, %2) is %3").arg(x).arg(y).arg(int(verdict)));
        });
        QVERIFY2(wrong.isEmpty(),
                 qPrintable(
                     QStringLiteral("%1: %2").arg(wrong.size()).arg(wrong.mid(0, 5).join(QLatin1Char(' ')))));
        for (const Verdict verdict : {Verdict::Shade, Verdict::OtherHue, Verdict::Flat})
            QVERIFY2(count[std::size_t(verdict)] > 300,
                     qPrintable(QStringLiteral("%1: %2").arg(int(verdict)).arg(count[std::size_t(verdict)])));
        QVERIFY2(count[std::size_t(Verdict::Unclear)] < 200,
                 qPrintable(QString::number(count[std::size_t(Verdict::Unclear)])));
        QVERIFY((shade.shade() - window.darkened()).isEmpty() &&
                (shade.byHue() - window.darkened()).isEmpty());
    }
};

ODOGRAPH_TEST(TestComparedWindow, QCoreApplication)
#include "tst_compared_window.moc"
