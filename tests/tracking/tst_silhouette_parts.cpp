// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/silhouette_parts.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

namespace {

/// A rectangle of whole pixels. Its shadow has a number, which others that hang together with it have, too.
SeenSilhouette rectangle(int x0, int y0, int x1, int y1, int shadowPiece)
{
    SeenSilhouette silhouette;
    silhouette.box = {x0, y0, x1, y1};
    const double left = x0 - 0.5, top = y0 - 0.5, right = x1 - 0.5, bottom = y1 - 0.5;
    measureHull(silhouette, {{left, top}, {right, top}, {right, bottom}, {left, bottom}});
    silhouette.shadowPiece = shadowPiece;
    silhouette.meanChroma = Chroma(10, 0);
    return silhouette;
}

/// Its side is 35 px: what is nearer than 4 px is taken with it, by its shadow what is nearer than 17 px.
/// 1200 px².
SeenSilhouette body()
{
    return rectangle(100, 100, 140, 130, 1);
}

double rightOf(const SeenSilhouette &silhouette)
{
    return silhouette.moments.centrePx.x() + double(silhouette.supportPx.front());
}

} // namespace

class TestSilhouetteParts : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void fragmentsAreJoined_data()
    {
        QTest::addColumn<QList<int>>("box");
        QTest::addColumn<int>("piece");
        QTest::addColumn<bool>("isJoined");
        QTest::newRow("small and near") << QList{143, 112, 147, 118} << 2 << true;
        QTest::newRow("small and not quite near") << QList{150, 112, 154, 118} << 2 << false;
        QTest::newRow("small, of the same shadow") << QList{150, 112, 154, 118} << 1 << true;
        QTest::newRow("small, of the same shadow and far") << QList{160, 112, 164, 118} << 1 << false;
        QTest::newRow("small, and the hull grows by 30 %") << QList{155, 112, 159, 118} << 1 << true;
        QTest::newRow("slender as a cable, and the hull would grow")
            << QList{143, 45, 145, 185} << 2 << false;
        QTest::newRow("small, in the hull") << QList{110, 110, 120, 120} << 2 << true;
        QTest::newRow("large and near") << QList{141, 100, 156, 130} << 2 << false;
        QTest::newRow("large, in the hull: another robot in a corner of this one")
            << QList{105, 110, 135, 124} << 1 << false;
    }
    void fragmentsAreJoined()
    {
        QFETCH(QList<int>, box);
        QFETCH(int, piece);
        QFETCH(bool, isJoined);
        const SeenSilhouette part = rectangle(box[0], box[1], box[2], box[3], piece);
        std::vector<SeenSilhouette> seen{body(), part};
        joinFragments(seen);
        QCOMPARE(seen.size(), std::size_t(isJoined ? 1 : 2));
        if (!isJoined) {
            QCOMPARE(seen[0].moments.areaPx2, body().moments.areaPx2);
            QCOMPARE(seen[1].moments.areaPx2, part.moments.areaPx2);
            return;
        }
        const SeenSilhouette &whole = seen.front();
        QVERIFY(std::abs(rightOf(whole) - (std::max(140, box[2]) - 0.5)) < 1e-3);
        QCOMPARE(whole.box.x1, std::max(140, box[2]));
        QCOMPARE(whole.regions, 1); // it is one body, not a group of them
        QCOMPARE(whole.shadowPiece, 1);
    }

    /// A wheel on each side: each alone grows the hull by a tenth.
    void severalFragmentsAreJoinedAtOnce()
    {
        std::vector<SeenSilhouette> seen{body(), rectangle(143, 112, 147, 118, 2),
                                         rectangle(93, 112, 97, 118, 3), rectangle(200, 112, 204, 118, 4)};
        joinFragments(seen);
        QCOMPARE(seen.size(), std::size_t(2));
        QVERIFY(std::abs(rightOf(seen[0]) - 146.5) < 1e-3);
        QCOMPARE(seen[0].box.x0, 93);
        // 1200 px² and two trapezia, 30 and 6 px high and 7 px wide.
        QVERIFY(std::abs(seen[0].moments.areaPx2 - (1200 + 2 * 7 * 18)) < 1e-6);
        QCOMPARE(seen[1].box.x0, 200);
    }

    void whatReachesTooFarKeepsNoOtherAway()
    {
        std::vector<SeenSilhouette> seen{body(), rectangle(143, 45, 145, 185, 2),
                                         rectangle(93, 112, 97, 118, 3)};
        joinFragments(seen);
        QCOMPARE(seen.size(), std::size_t(2));
        QCOMPARE(seen[0].box.x0, 93);
        QCOMPARE(seen[0].box.x1, 140);
        QCOMPARE(seen[1].box.x0, 143);
    }

    void theFragmentOfTheSecondIsTheSecondsOwn()
    {
        std::vector<SeenSilhouette> seen{body(), rectangle(200, 100, 230, 130, 2),
                                         rectangle(233, 112, 237, 118, 3)};
        joinFragments(seen);
        QCOMPARE(seen.size(), std::size_t(2));
        QCOMPARE(seen[0].moments.areaPx2, body().moments.areaPx2);
        QVERIFY(std::abs(rightOf(seen[1]) - 236.5) < 1e-3);
        QCOMPARE(seen[1].shadowPiece, 2);
    }

    /// A camera on a mast that looks like the floor is not joined, and noted of the nearest body.
    void whatIsNearIsNoted_data()
    {
        QTest::addColumn<QList<int>>("box");
        QTest::addColumn<bool>("isNoted");
        QTest::newRow("14 px above") << QList{110, 76, 124, 86} << true;
        QTest::newRow("29 px above, beyond 0.8 sides") << QList{110, 61, 124, 71} << false;
        QTest::newRow("as large as a third of the body") << QList{105, 70, 130, 86} << false;
        QTest::newRow("nearer to another") << QList{158, 105, 165, 112} << false;
    }
    void whatIsNearIsNoted()
    {
        QFETCH(QList<int>, box);
        QFETCH(bool, isNoted);
        std::vector<SeenSilhouette> seen{body(), rectangle(170, 100, 200, 130, 2),
                                         rectangle(box[0], box[1], box[2], box[3], 3)};
        noteBeside(seen);
        QCOMPARE(seen.size(), std::size_t(3));
        QCOMPARE(seen[0].moments.areaPx2, body().moments.areaPx2);
        QCOMPARE(seen[0].isTrimmed, isNoted);
        QVERIFY(!seen[2].isTrimmed);
    }

    /// A lid and wheels below a side that looks like floor in shadow; a second body has its own shadow.
    void whatOneShadowConnectsIsJoined()
    {
        std::vector<SeenSilhouette> seen{body(), rectangle(200, 100, 230, 130, 2),
                                         rectangle(100, 140, 110, 150, 1), rectangle(130, 140, 140, 150, 1)};
        joinByShadow(seen);
        QCOMPARE(seen.size(), std::size_t(2));
        QVERIFY(std::abs(seen[0].moments.areaPx2 - 40 * 50) < 1e-6);
        QCOMPARE(seen[0].regions, 1);
        QCOMPARE(seen[0].shadowPiece, 1);
        QCOMPARE(seen[1].moments.areaPx2, 900.0);
    }

    void theShareApartIsNoted()
    {
        std::vector<SeenSilhouette> seen{body(), rectangle(200, 100, 230, 130, 2),
                                         rectangle(100, 140, 110, 150, 1), rectangle(130, 140, 140, 150, 1)};
        noteApart(seen);
        QCOMPARE(seen.size(), std::size_t(4));
        QVERIFY(std::abs(double(seen[0].shadowAmbiguity.apart) - 0.4) < 1e-6); // 1200 of 2000 px²
        QCOMPARE(seen[1].shadowAmbiguity.apart, 0.0F);
        QVERIFY(std::abs(double(seen[3].shadowAmbiguity.apart) - 0.95) < 1e-6); // 100 of them
    }

    void withoutFragmentsNothingIsJoined()
    {
        std::vector<SeenSilhouette> none;
        joinFragments(none);
        joinByShadow(none);
        noteApart(none);
        QVERIFY(none.empty());
        std::vector<SeenSilhouette> one{body()};
        joinFragments(one);
        QCOMPARE(one.size(), std::size_t(1));
        QCOMPARE(one.front().moments.areaPx2, 1200.0);
    }
};

ODOGRAPH_TEST(TestSilhouetteParts, QCoreApplication)
#include "tst_silhouette_parts.moc"
