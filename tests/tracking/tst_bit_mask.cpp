// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/bit_mask.h"

#include "tests/support/registered_test.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <random>

using namespace odo;

namespace {

using IsSet = std::function<bool(int, int)>;

BitMask maskOf(int width, int height, const IsSet &isSet)
{
    BitMask mask(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (isSet(x, y))
                mask.set(x, y);
    return mask;
}

BitMask speckled(int width, int height, double share)
{
    std::mt19937 random(std::uint32_t(width * 1000 + height));
    std::bernoulli_distribution isSet(share);
    return maskOf(width, height, [&](int, int) { return isSet(random); });
}

/// Whether a mask is what a definition says of each of its pixels.
bool isAs(const BitMask &mask, const IsSet &isSet)
{
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            if (mask.at(x, y) != isSet(x, y))
                return false;
    return true;
}

/// Whether any pixel of a disc around a place is in the set, which is continued outside the image.
bool discMeets(const BitMask &mask, int x, int y, int radius, bool isOutsideSet)
{
    for (int dy = -radius; dy <= radius; ++dy) {
        const auto half = int(std::lround(std::sqrt(radius * radius - dy * dy)));
        for (int i = x - half, j = y + dy; i <= x + half; ++i) {
            const bool isInside = i >= 0 && i < mask.width() && j >= 0 && j < mask.height();
            if (isInside ? mask.at(i, j) : isOutsideSet)
                return true;
        }
    }
    return false;
}

/// Widths within a word, at its end, and beyond it.
void sizes()
{
    QTest::addColumn<int>("width");
    for (const int width : {1, 7, 63, 64, 65, 130})
        QTest::addRow("%d wide", width) << width;
}

} // namespace

class TestBitMask : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void rowsAreTaken_data() { sizes(); }
    void rowsAreTaken()
    {
        QFETCH(int, width);
        const BitMask mask = speckled(width, 5, 0.5);
        BitMask again(width, 5);
        for (int y = 0; y < 5; ++y) {
            std::vector<std::uint8_t> bytes(std::size_t(width), 0);
            for (int x = 0; x < width; ++x)
                bytes[std::size_t(x)] = mask.at(x, y) ? 1 : 0;
            again.setRow(y, bytes.data(), 0, width);
        }
        QVERIFY(isAs(again, [&](int x, int y) { return mask.at(x, y); }));
        const int third = width / 3; // from a place that is no byte's
        std::vector<std::uint8_t> ones(std::size_t(width), 1);
        BitMask part(width, 1);
        part.setRow(0, ones.data(), third, width);
        QVERIFY(isAs(part, [&](int x, int) { return x >= third; }));
    }
    void setsAreCombined_data() { sizes(); }
    void setsAreCombined()
    {
        QFETCH(int, width);
        const BitMask a = speckled(width, 6, 0.5), b = speckled(width, 7, 0.3).cropped({0, 1, width, 7});
        QVERIFY(isAs(a | b, [&](int x, int y) { return a.at(x, y) || b.at(x, y); }));
        QVERIFY(isAs(a & b, [&](int x, int y) { return a.at(x, y) && b.at(x, y); }));
        QVERIFY(isAs(a - b, [&](int x, int y) { return a.at(x, y) && !b.at(x, y); }));
        QVERIFY(isAs(a.complement(), [&](int x, int y) { return !a.at(x, y); }));
        QCOMPARE(a.count() + a.complement().count(), 6 * width);
        int seen = 0;
        a.forEach([&](int x, int y) { seen += a.at(x, y); });
        QCOMPARE(seen, a.count());
        QCOMPARE(BitMask(width, 70).complement().count(), 70 * width);
        BitMask again(width, 6); // run by run
        for (int y = 0; y < 6; ++y)
            a.forEachRunInRow(y, [&](int x0, int x1) { again.setRun(y, x0, x1); });
        QVERIFY(isAs(again, [&](int x, int y) { return a.at(x, y); }));
    }
    void partsAreCutOutAndPadded_data() { sizes(); }
    void partsAreCutOutAndPadded()
    {
        QFETCH(int, width);
        const BitMask mask = speckled(width, 9, 0.4);
        const PixelRect part{width / 4, 2, width - width / 5, 8};
        QVERIFY(isAs(mask.cropped(part), [&](int x, int y) { return mask.at(part.x0 + x, part.y0 + y); }));
        const BitMask wide = mask.padded(3);
        QCOMPARE(wide.count(), mask.count());
        QVERIFY(isAs(wide.cropped({3, 3, 3 + width, 12}), [&](int x, int y) { return mask.at(x, y); }));
    }
    void discsDilateAndErode_data() { sizes(); }
    void discsDilateAndErode()
    {
        QFETCH(int, width);
        const BitMask few = speckled(width, 20, 0.02), most = speckled(width, 20, 0.97);
        for (const int radius : {1, 2, 4}) {
            QVERIFY(
                isAs(few.dilated(radius), [&](int x, int y) { return discMeets(few, x, y, radius, false); }));
            for (const bool isOutsideSet : {false, true})
                QVERIFY(isAs(most.eroded(radius, isOutsideSet), [&](int x, int y) {
                    return !discMeets(most.complement(), x, y, radius, !isOutsideSet);
                }));
        }
    }
    void neighboursAreCounted_data() { sizes(); }
    void neighboursAreCounted()
    {
        QFETCH(int, width);
        const BitMask mask = speckled(width, 12, 0.1);
        const auto around = [&](int x, int y, int reach) {
            int count = 0;
            for (int j = std::max(0, y - reach); j <= std::min(11, y + reach); ++j)
                for (int i = std::max(0, x - reach); i <= std::min(width - 1, x + reach); ++i)
                    count += mask.at(i, j);
            return count;
        };
        QVERIFY(isAs(mask.crowded(), [&](int x, int y) { return around(x, y, 1) >= 3; }));
        QVERIFY(isAs(mask.grown(), [&](int x, int y) { return around(x, y, 1) >= 1; }));
        QVERIFY(isAs(mask.grown(4), [&](int x, int y) { return around(x, y, 4) >= 1; }));
    }
    void columnsEndAtTheirPixels_data() { sizes(); }
    void columnsEndAtTheirPixels()
    {
        QFETCH(int, width);
        BitMask mask = speckled(width, 9, 0.15);
        mask.put(0, 4, false);
        mask.put(width - 1, 5, true);
        QVERIFY(!mask.at(0, 4));
        QVERIFY(mask.at(width - 1, 5));
        const std::vector<int> tops = mask.topOfColumns(), bottoms = mask.bottomOfColumns();
        QCOMPARE(int(tops.size()), width);
        QCOMPARE(int(bottoms.size()), width);
        for (int x = 0; x < width; ++x) {
            int top = -1, bottom = -1;
            for (int y = 0; y < mask.height(); ++y) {
                if (!mask.at(x, y))
                    continue;
                top = top < 0 ? y : top;
                bottom = y;
            }
            QCOMPARE(tops[std::size_t(x)], top);
            QCOMPARE(bottoms[std::size_t(x)], bottom);
        }
    }

    void runsAreSetAndFound_data() { sizes(); }
    void runsAreSetAndFound()
    {
        QFETCH(int, width);
        const int x0 = width / 3, x1 = width - width / 4;
        BitMask mask(width, 2);
        mask.setRun(1, x0, x1);
        QVERIFY(isAs(mask, [&](int x, int y) { return y == 1 && x >= x0 && x < x1; }));
        const PixelRect box = mask.bounds();
        QCOMPARE(box.x0, x0);
        QCOMPARE(box.x1, x1);
        QCOMPARE(box.y0, 1);
        QCOMPARE(box.y1, 2);
        QCOMPARE(mask.nextSet(0, 1), x0);
        QCOMPARE(mask.nextClear(x0, 1), x1);
        QCOMPARE(mask.lastSet(width, 1), x1 - 1);
        QCOMPARE(mask.nextSet(0, 0), width);
        QCOMPARE(mask.lastSet(width, 0), -1);
        mask -= BitMask(mask);
        QVERIFY(mask.isEmpty() && mask.bounds().isEmpty());
    }
};

ODOGRAPH_TEST(TestBitMask, QCoreApplication)
#include "tst_bit_mask.moc"
