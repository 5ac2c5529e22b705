// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/accuracy_map.h"
#include "tests/calibration/floor_views.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <limits>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

constexpr double unseen = std::numeric_limits<double>::quiet_NaN();

MarkerLayout layout()
{
    return {"floor", {{"O", {0, 0}}, {"U", {3, 0}}, {"V", {0, 2}}, {"D", {3, 2}}}};
}

/// σ of each place of a grid by a function of it.
template <class Function>
AccuracySummary summaryOf(Function sigma)
{
    const FloorGrid grid = gridOver(layout(), 0.5, 41);
    std::vector<double> values;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            values.push_back(sigma(grid.at(column, row)));
    return summariseAccuracy(grid, values, layout());
}

double worstOf(const PlannedCamera &camera, const std::vector<FloorView> &others)
{
    std::vector<FloorView> views = others;
    views.push_back(*plannedView(camera, layout()));
    const FloorGrid grid = gridOver(layout(), 0, 12);
    return summariseAccuracy(grid, accuracyMap(views, grid, 0.1).fusedSigmaM, layout()).worstM;
}

} // namespace

class TestCameraPlanning : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void saysMiddleAndWorst()
    {
        // Grows from 1 mm at O to 6 mm at D, and much beyond the markers, which does not count.
        const auto summary = summaryOf([](const Vector2d &at) {
            const bool among = at.x() > -1e-9 && at.y() > -1e-9 && at.x() < 3 + 1e-9 && at.y() < 2 + 1e-9;
            return among ? 0.001 + 0.005 * (at.x() / 3 + at.y() / 2) / 2 : 1.0;
        });
        QVERIFY(std::abs(summary.worstM - 0.006) < 1e-9);
        // the grid has a place within a step of the middle
        QVERIFY(std::abs(summary.middleM - 0.0035) < 1e-4);
        QCOMPARE(summary.seenPart, 1.0);
        QVERIFY(contains(summary.words.english(), "in the middle, ±6.0 mm in the corner near D."));
    }
    void saysWhatIsNotSeen()
    {
        const auto half = summaryOf([](const Vector2d &at) { return at.x() < 1.5 ? unseen : 0.002; });
        QVERIFY(half.seenPart > 0.4 && half.seenPart < 0.6);
        QVERIFY(contains(half.words.english(), "% of the floor between the markers is out of view."));
        const auto none = summaryOf([](const Vector2d &) { return unseen; });
        QCOMPARE(none.seenPart, 0.0);
        QVERIFY(std::isnan(none.worstM));
        QCOMPARE(none.words.english(), std::string("None of the floor between the markers is in view."));
        QVERIFY(std::isnan(summariseAccuracy({}, {}, {}).worstM));
    }
    void aCameraStandsWhereItWasPut()
    {
        PlannedCamera camera;
        camera.aimM = {1, 2};
        camera.moveCameraTo({-0.5, 0.25});
        QVERIFY((camera.footM() - Vector2d(-0.5, 0.25)).norm() < 1e-12);
        QVERIFY((camera.aimM - Vector2d(1, 2)).norm() == 0);
        const double before = camera.directionDegrees;
        camera.moveCameraTo(camera.aimM); // straight above
        QCOMPARE(camera.directionDegrees, before);
        QCOMPARE(camera.distanceM, 0.0);
    }
    void theBestPlaceIsNoWorseThanAnyTried()
    {
        PlannedCamera like;
        like.heightM = 2;
        like.fieldOfViewDegrees = 70;
        const CameraPositionSearch search{1.5, false, 0, 0.1};
        const auto best = bestCameraPosition(like, layout(), {}, search, {});
        QVERIFY2(best.has_value(), best ? "" : best.error().message().c_str());
        QCOMPARE(best->heightM, 2.0);
        const Vector2d foot = best->footM();
        QVERIFY2(foot.x() < 0 || foot.x() > 3 || foot.y() < 0 || foot.y() > 2,
                 "a tripod does not stand among the robots");
        QVERIFY(foot.x() > -1.5 - 1e-9 && foot.x() < 4.5 + 1e-9 && foot.y() > -1.5 - 1e-9 &&
                foot.y() < 3.5 + 1e-9);
        const double bestM = worstOf(*best, {});
        int compared = 0;
        for (int degrees = 0; degrees < 360; degrees += 10) {
            PlannedCamera other = like;
            other.aimM = {1.5, 1};
            other.distanceM = 2.4;
            other.directionDegrees = degrees;
            const Vector2d at = other.footM();
            const auto view = plannedView(other, layout());
            if (!view || at.x() < -1.5 || at.x() > 4.5 || at.y() < -1.5 || at.y() > 3.5)
                continue;
            const FloorGrid grid = gridOver(layout(), 0, 12);
            const auto summary =
                summariseAccuracy(grid, accuracyMap({&*view, 1}, grid, 0.1).fusedSigmaM, layout());
            if (summary.seenPart < 1)
                continue;
            ++compared;
            QVERIFY2(bestM <= summary.worstM * 1.0001, qPrintable(QString::number(degrees)));
        }
        QVERIFY(compared > 2);
    }
    void aSecondCameraGoesWhereTheFirstIsWeak()
    {
        PlannedCamera like;
        like.fieldOfViewDegrees = 70;
        const CameraPositionSearch search{1.5, false, 0, 0.1};
        const auto first = bestCameraPosition(like, layout(), {}, search, {});
        QVERIFY(first);
        const std::vector<FloorView> there{*plannedView(*first, layout())};
        const auto second = bestCameraPosition(like, layout(), there, search, {});
        QVERIFY(second);
        // Two at one place gain √2 at most; the second from elsewhere gains more.
        QVERIFY((second->footM() - first->footM()).norm() > 1);
        QVERIFY(worstOf(*second, there) < worstOf(*first, {}) / std::sqrt(2.0) * 1.0001);
    }
    void aCeilingIsTakenWhereItMayBe()
    {
        PlannedCamera like;
        like.heightM = 3.5;
        like.fieldOfViewDegrees = 75;
        const auto above = bestCameraPosition(like, layout(), {}, {0.5, true, 0, 0.1}, {});
        QVERIFY(above);
        QVERIFY(above->footM().x() > 0 && above->footM().x() < 3 && above->footM().y() > 0 &&
                above->footM().y() < 2);
    }
    void refusesWithTheReason()
    {
        PlannedCamera low;
        low.heightM = 0.06;
        low.fieldOfViewDegrees = 10;
        const auto nowhere = bestCameraPosition(low, layout(), {}, {0.2, false, 0, 0.1}, {});
        QVERIFY(!nowhere);
        QVERIFY(contains(nowhere.error().message(),
                         "no position within 0.2 m of the markers shows four of them"));
        PlannedCamera wrong;
        wrong.heightM = 0;
        const auto inTheGround = bestCameraPosition(wrong, layout(), {}, {}, {});
        QVERIFY(!inTheGround);
        QVERIFY(contains(inTheGround.error().message(), "its height above the floor cannot be 0.00 m"));
        QVERIFY(contains(bestCameraPosition({}, {"x", {{"O", {0, 0}}}}, {}, {}, {}).error().message(),
                         "the layout has 1 markers, four are needed"));
        const JobControl control;
        control.cancel.cancel();
        PlannedCamera like;
        like.fieldOfViewDegrees = 70;
        QCOMPARE(bestCameraPosition(like, layout(), {}, {}, control).error().code, ErrorCode::Cancelled);
    }
};

ODOGRAPH_TEST(TestCameraPlanning, QCoreApplication)
#include "tst_camera_planning.moc"
