// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/bit_mask.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

namespace {

/// # is in the set.
BitMask drawn(const std::vector<std::string> &rows)
{
    BitMask mask(int(rows.front().size()), int(rows.size()));
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            if (rows[std::size_t(y)][std::size_t(x)] == '#')
                mask.set(x, y);
    return mask;
}

int pixelsOf(const ConnectedPart &part)
{
    int pixels = 0;
    for (const PixelRun &run : part)
        pixels += run.x1 - run.x0;
    return pixels;
}

} // namespace

class TestConnectedParts : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void nothingHasNoParts()
    {
        QVERIFY(connectedParts(BitMask(70, 3)).empty());
        QVERIFY(withoutHoles(BitMask(70, 3)).isEmpty());
    }

    void whatTouchesAtACornerIsOnePart()
    {
        const auto parts = connectedParts(drawn({"##...#", "..#...", "...#.#", "#....#"}));
        QCOMPARE(parts.size(), std::size_t(4));
        QCOMPARE(pixelsOf(parts[0]), 4);
        const PixelRect box = boundsOf(parts[0]);
        QVERIFY(box.x0 == 0 && box.y0 == 0 && box.x1 == 4 && box.y1 == 3);
        QVERIFY(contains(parts[0], 3, 2) && !contains(parts[0], 5, 2) && contains(parts[2], 5, 3));
        QCOMPARE(pixelsOf(parts[1]), 1);
        QCOMPARE(pixelsOf(parts[2]), 2);
        QCOMPARE(pixelsOf(parts[3]), 1);
    }

    /// Branches that meet only further down.
    void branchesAreJoined()
    {
        const auto parts = connectedParts(drawn({"#.#.#.#", "#.#.#.#", "#.###.#", "#.....#", "#######"}));
        QCOMPARE(parts.size(), std::size_t(2));
        QCOMPARE(pixelsOf(parts[0]), 15);
        QCOMPARE(pixelsOf(parts[1]), 7);
    }

    void holesAreFilled()
    {
        const BitMask ring = drawn({".###..", "#...#.", "#.#.#.", ".###.#", "......"});
        const BitMask filled = withoutHoles(ring);
        QCOMPARE(filled.count(), ring.count() + 5); // corners close it, and what lies in it is filled with it
        QVERIFY(filled.at(1, 1) && filled.at(3, 2) && !filled.at(0, 0) && !filled.at(4, 3) &&
                !filled.at(5, 2));
        const BitMask open = drawn({"###", "#..", "###"});
        QCOMPARE(withoutHoles(open).count(), open.count());
    }

    void whatIsEnclosedIsKnownFromTheRuns()
    {
        const auto encloses = [](const std::vector<std::string> &rows) {
            return enclosesAny(connectedParts(drawn(rows))[0]);
        };
        QVERIFY(encloses({".###.", "#...#", ".###."})); // corners close it
        QVERIFY(encloses({"##.##", "#.#.#", "#####"}));
        QVERIFY(!encloses({"###", "#..", "###"}));
        QVERIFY(!encloses({"#.#.#", "#.#.#", "#####", "#...#", "#...#"}));
        QVERIFY(!encloses({"#...#", ".#.#.", "..#..", ".#.#."}));
        QVERIFY(!encloses({"#"}));
    }
};

ODOGRAPH_TEST(TestConnectedParts, QCoreApplication)
#include "tst_connected_parts.moc"
