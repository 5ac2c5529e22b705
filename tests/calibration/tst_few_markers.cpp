// SPDX-License-Identifier: GPL-3.0-or-later
// Few markers under a known lens, marked and measured with more or less care, and with one that is wrong: is
// what the registration states of the floor true, and is the wrong one named?
#include "core/calibration/floor_registration.h"
#include "core/calibration/intrinsics_influence.h"
#include "tests/calibration/floor_set_ups.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <Eigen/LU>
#include <QTest>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

/// How well the markers are marked and measured, and how far one of them is off.
struct Care
{
    double noisePx, tapeM, wrongM;
};

struct Outcome
{
    int registered = 0, refused = 0, named = 0, misnamed = 0, within = 0, points = 0;

    double inside() const { return points > 0 ? double(within) / points : 0; }
};

/// How many of the points among the markers are as near as the registration alone states: 95 % of χ²(2).
void readBack(const FloorView &truth, const FloorView &view, std::mt19937 &random, Outcome &outcome)
{
    for (int i = 0; i < 20; ++i) {
        const Vector2d point(0.3 + 2.4 * share(random), 0.3 + 1.6 * share(random));
        const auto pixel = shownPixel(truth, point);
        const auto read = pixel ? view.locate(*pixel, Eigen::Matrix2d::Zero(), 0) : std::nullopt;
        if (!read)
            continue;
        const Vector2d off = read->pointInWorld - point;
        ++outcome.points;
        outcome.within += off.dot(read->calibrationCovariance.inverse() * off) < 5.991 ? 1 : 0;
    }
}

void addSetUp(std::size_t markers, const Care &care, std::mt19937 &random, Outcome &outcome)
{
    const FloorView truth = drawnFloorView(drawnLens(LensKind::Webcam, random), random);
    MarkedFloor floor(truth, Arrangement::AllRound, markers, care.tapeM, care.noisePx, random);
    if (floor.pixels.size() < markers)
        return;
    const double direction = 2 * EIGEN_PI * share(random);
    Marker &wrong = floor.layout.markers[markers / 2];
    wrong.pointInWorld += care.wrongM * Vector2d(std::cos(direction), std::sin(direction));
    const auto registration = registerFloor(floor.layout, floor.pixels, truth.camera(), true);
    if (!registration) {
        ++outcome.refused;
        return;
    }
    ++outcome.registered;
    const std::string words = registration->verdict.english();
    if (contains(words, "from where the others expect it"))
        ++(contains(words, "Marker " + wrong.label + " is") && care.wrongM > 0 ? outcome.named
                                                                               : outcome.misnamed);
    readBack(truth, floorViewOf(*registration, truth.camera(), floor.pixels), random, outcome);
}

Outcome drawn(std::size_t markers, const Care &care)
{
    std::mt19937 random(unsigned(500 + markers));
    const int rounds = std::max(1, qEnvironmentVariableIntValue("ODOGRAPH_FEW_MARKERS"));
    Outcome outcome;
    for (int i = 0; i < 60 * rounds; ++i)
        addSetUp(markers, care, random, outcome);
    qInfo("%zu markers: %d registered, %d refused; %d named, %d misnamed; inside %.1f %%", markers,
          outcome.registered, outcome.refused, outcome.named, outcome.misnamed, 100 * outcome.inside());
    return outcome;
}

} // namespace

class TestFewMarkers : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theFloorIsAsStated_data()
    {
        QTest::addColumn<int>("markers");
        QTest::addColumn<double>("noisePx");
        QTest::addColumn<double>("tapeM");
        for (const int markers : {4, 5, 6, 8, 12}) {
            QTest::addRow("%d, careful", markers) << markers << 0.3 << 0.0;
            QTest::addRow("%d, taped to 3 mm", markers) << markers << 0.3 << 0.003;
            QTest::addRow("%d, marked to 1 px", markers) << markers << 1.0 << 0.001;
        }
    }
    void theFloorIsAsStated()
    {
        QFETCH(int, markers);
        QFETCH(double, noisePx);
        QFETCH(double, tapeM);
        const Outcome outcome = drawn(std::size_t(markers), {noisePx, tapeM, 0});
        // Points of one registration err together; two and four residuals reveal little of a careless person.
        const double least = markers == 4 ? 0.68 : markers == 5 ? 0.78 : 0.86;
        QVERIFY(outcome.registered >= 50);
        QVERIFY(outcome.inside() > (noisePx < 1 && tapeM == 0 ? 0.88 : least));
        QVERIFY(outcome.misnamed <= 0.02 * outcome.registered);
    }
    void aWrongMarkerIsNamedOrCosts_data()
    {
        QTest::addColumn<int>("markers");
        QTest::addColumn<double>("wrongM");
        for (const int markers : {5, 6, 7, 8, 12})
            for (const double wrongM : {0.02, 0.05, 0.1})
                QTest::addRow("%d, one off by %.0f mm", markers, 1000 * wrongM) << markers << wrongM;
    }
    void aWrongMarkerIsNamedOrCosts()
    {
        QFETCH(int, markers);
        QFETCH(double, wrongM);
        const Outcome outcome = drawn(std::size_t(markers), {0.3, 0.0005, wrongM});
        QVERIFY(outcome.misnamed <= 0.02 * outcome.registered); // few of its errors look like another's
        if (markers >= 6 && wrongM >= 0.05)
            QVERIFY(outcome.named >= 0.6 * outcome.registered);
        // five cannot name it, but most that are off by a hand's width are refused
        if (markers == 5 && wrongM >= 0.1)
            QVERIFY(outcome.refused >= 0.75 * (outcome.registered + outcome.refused));
    }
};

ODOGRAPH_TEST(TestFewMarkers, QCoreApplication)
#include "tst_few_markers.moc"
