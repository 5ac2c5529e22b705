// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/image_edges.h"
#include "core/calibration/internal/marker_assignment.h"
#include "core/calibration/internal/round_markers.h"
#include "core/calibration/internal/tag_prediction.h"
#include "core/calibration/marker_detection.h"
#include "tests/calibration/floor_views.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

/// Alike from no two sides.
MarkerLayout layout()
{
    return {"floor", {{"O", {0, 0}}, {"U", {2.4, 0}}, {"V", {0, 1.8}}, {"D", {2.7, 2.0}}, {"E", {0.9, 0.6}}}};
}

MarkerLayout rectangle()
{
    return {"floor", {{"O", {0, 0}}, {"U", {2.4, 0}}, {"V", {0, 1.8}}, {"D", {2.4, 1.8}}}};
}

/// Its tags, numbered in the layout's order.
std::vector<FloorTag> byPlace(const MarkerLayout &layout)
{
    std::vector<FloorTag> tags;
    for (const Marker &marker : layout.markers)
        tags.push_back({{TagFamily::AprilTag36h11, static_cast<int>(tags.size())}, marker.pointInWorld});
    return tags;
}

/// RMS of the distances, or nullopt where a marker is missing or another was taken for it.
std::optional<double> rmsOf(const std::vector<MarkerPixel> &found, const std::vector<MarkerPixel> &truth)
{
    double squares = 0;
    for (const MarkerPixel &marker : truth) {
        const auto seen = std::ranges::find(found, marker.label, &MarkerPixel::label);
        if (seen == found.end())
            return std::nullopt;
        squares += (seen->pixel - marker.pixel).squaredNorm() / static_cast<double>(truth.size());
    }
    return std::sqrt(squares);
}

MarkerSearch known(const DrawnView &view)
{
    return {view.scene.cameras[0].view.camera(), true, {}};
}

/// Shapes where a camera sees the markers, and some that are none, in another order.
std::vector<RoundMarker> shapesAt(const std::vector<MarkerPixel> &pixels, const std::vector<Vector2d> &others)
{
    std::vector<RoundMarker> shapes;
    const auto add = [&](const Vector2d &pixel) {
        shapes.push_back({RoundMarker::Kind::Ring, pixel, 0.05, {pixel, {0, 0}, 0}});
    };
    for (const Vector2d &other : others)
        add(other);
    for (const MarkerPixel &pixel : pixels)
        add(pixel.pixel);
    return shapes;
}

const FloorView &view()
{
    static const FloorView floor = simulatedView({-0.9, -1.55, 2.0}, {1.2, 0.8, 0.0}, 1280, 720, 860);
    return floor;
}

} // namespace

class TestMarkerSearch : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void ninetyFivePercentOfTheViewsAreFoundToAFifthOfAPixel_data()
    {
        QTest::addColumn<MarkerShape>("shape");
        QTest::newRow("tags") << MarkerShape::Tag;
        QTest::newRow("rings") << MarkerShape::Ring;
        QTest::newRow("dots") << MarkerShape::Dot;
    }
    void ninetyFivePercentOfTheViewsAreFoundToAFifthOfAPixel()
    {
        QFETCH(MarkerShape, shape);
        const int views = qEnvironmentVariableIntValue("ODOGRAPH_FLOOR_VIEWS") > 0
                              ? qEnvironmentVariableIntValue("ODOGRAPH_FLOOR_VIEWS")
                              : 12;
        int good = 0, wrong = 0;
        std::vector<double> errors;
        for (int i = 0; i < views; ++i) {
            const DrawnView drawn =
                drawFloorView(layout(), shape, 0.16, 1000 + static_cast<std::uint32_t>(i));
            const auto found = findMarkers(drawn.frame, layout(), known(drawn));
            const auto rms = found ? rmsOf(*found, drawn.truth) : std::nullopt;
            if (rms && *rms <= 0.2)
                ++good;
            else
                qInfo("view %d: %s", i,
                      found ? rms ? qPrintable(QString::number(*rms)) : "not all"
                            : found.error().message().c_str());
            if (rms)
                errors.push_back(*rms);
            wrong += rms && *rms > 3;
        }
        std::ranges::sort(errors);
        QVERIFY(!errors.empty());
        qInfo("%d of %d views good; median %.3f px, 95 %% %.3f px, worst %.3f px", good, views,
              errors[errors.size() / 2], errors[errors.size() * 95 / 100], errors.back());
        QVERIFY(good >= 0.95 * views - (views < 100 ? 1 : 0));
        QCOMPARE(wrong, 0);
    }
    void rightAmongOtherShapes()
    {
        const auto truth = markersIn(view(), layout(), 20);
        const auto shapes = shapesAt(truth, {{200, 100}, {900, 150}, {640, 600}, {90, 400}, {1100, 500}});
        const auto assigned = assignMarkers(shapes, layout(), view().camera(), true);
        QVERIFY2(assigned.has_value(), assigned ? "" : assigned.error().message().c_str());
        QVERIFY(rmsOf(*assigned, truth).value_or(99) < 1e-9);
    }
    void aHiddenMarkerIsLeftOut()
    {
        auto truth = markersIn(view(), layout(), 20);
        truth.erase(truth.begin() + 1);
        const auto assigned = assignMarkers(shapesAt(truth, {}), layout(), view().camera(), true);
        QVERIFY2(assigned.has_value(), assigned ? "" : assigned.error().message().c_str());
        QCOMPARE(assigned->size(), std::size_t(4));
        QVERIFY(rmsOf(*assigned, truth).value_or(99) < 1e-9);
    }
    void aRectangleAsksForOneMarkerAndIsContentWithIt()
    {
        const auto truth = markersIn(view(), rectangle(), 20);
        const auto shapes = shapesAt(truth, {});
        const auto unsure = assignMarkers(shapes, rectangle(), view().camera(), true);
        QVERIFY(!unsure.has_value());
        QCOMPARE(unsure.error().code, ErrorCode::Undetermined);
        QVERIFY(contains(unsure.error().message(), "in 2 ways"));
        QVERIFY(contains(unsure.error().message(), "mark by hand which of them is O"));
        for (const MarkerPixel &told : truth) {
            const auto sure = assignMarkers(shapes, rectangle(), view().camera(), true,
                                            {{told.label, told.pixel + Vector2d(6, -5)}});
            QVERIFY2(sure.has_value(), sure ? "" : sure.error().message().c_str());
            QVERIFY(rmsOf(*sure, truth).value_or(99) < 1e-9);
        }
    }
    void withoutALensFourMarkersAreAskedFor()
    {
        const auto truth = markersIn(view(), rectangle(), 20);
        const CameraModel assumed = CameraModel::assumed(1280, 720);
        QVERIFY(!assignMarkers(shapesAt(truth, {}), rectangle(), assumed, false).has_value());
    }
    void aHintThatNoShapeLiesAtIsTakenAsItIs()
    {
        auto truth = markersIn(view(), layout(), 20);
        const MarkerPixel told = truth[3];
        auto others = truth;
        others.erase(others.begin() + 3);
        const auto assigned = assignMarkers(shapesAt(others, {}), layout(), view().camera(), true, {told});
        QVERIFY(assigned.has_value());
        QVERIFY(rmsOf(*assigned, truth).value_or(99) < 1e-9);
    }
    void saysThatNothingFits()
    {
        const auto shapes = shapesAt({}, {{200, 100}, {900, 150}, {640, 600}, {90, 400}});
        MarkerLayout far = layout();
        far.markers[4].pointInWorld = {40, 40};
        const auto assigned = assignMarkers(shapes, far, view().camera(), true);
        QVERIFY(!assigned.has_value());
        QVERIFY(contains(assigned.error().message(), "fits the layout"));
        const auto three =
            assignMarkers({shapes.begin(), shapes.begin() + 3}, layout(), view().camera(), true);
        QVERIFY(!three.has_value());
        QVERIFY(contains(three.error().message(), "3 rings or dots were found, four are needed"));
    }
    void theMiddleOfADotIsNotThatOfItsEllipse()
    {
        // A large dot near the camera: the ellipse through its exact outline, corrected by the pose.
        std::vector<Vector2d> outline;
        for (int i = 0; i < 90; ++i) {
            const double angle = 2 * EIGEN_PI * i / 90;
            outline.push_back(
                *view().pixelFromWorld({0.1 + 0.15 * std::cos(angle), 0.1 + 0.15 * std::sin(angle), 0}));
        }
        const auto ellipse = ellipseThrough(outline);
        QVERIFY(ellipse.has_value());
        const Vector2d truth = *view().pixelFromWorld({0.1, 0.1, 0});
        QVERIFY((ellipse->centre - truth).norm() > 0.5);
        // The lens bends the outline away from an ellipse by some hundredths of a pixel.
        const auto middle = dotCentre(*ellipse, view());
        QVERIFY(middle.has_value());
        QVERIFY2((*middle - truth).norm() < 0.03, qPrintable(QString::number((*middle - truth).norm())));
    }
    void aDotBeyondTheHorizonHasNoMiddle()
    {
        const FloorView level = simulatedView({-0.9, -1.55, 1.0}, {5, 3, 0.9}, 1280, 720, 860);
        QVERIFY(!dotCentre({{640, 340}, {60, 40}, 0}, level).has_value());
    }
    void tagsTooSmallToReadAreForetold()
    {
        // Cells of 3 by 0.7 px, of which libapriltag makes nothing; three others tell where they are.
        DrawnView drawn = drawFloorView(layout(), MarkerShape::Tag, 0.16, 1019);
        QVERIFY(findTags(drawn.frame).size() < 4);
        const auto found = findMarkers(drawn.frame, layout(), known(drawn));
        QVERIFY2(found.has_value(), found ? "" : found.error().message().c_str());
        QCOMPARE(found->size(), std::size_t(5));
        QVERIFY(rmsOf(*found, drawn.truth).value_or(99) < 0.2);
        // A marker that does not lie there, and one in whose place another tag lies, are not foretold.
        MarkerLayout more = layout();
        more.markers.push_back({"F", {1.8, 1.2}});
        const auto without = findMarkers(drawn.frame, more, known(drawn));
        QVERIFY(without && without->size() == 5);
        QVERIFY(std::ranges::find(*without, std::string("F"), &MarkerPixel::label) == without->end());
        const auto tags = findTags(drawn.frame);
        QVERIFY(!tags.empty());
        more.markers[5].pointInWorld = layout().markers[std::size_t(tags.front().number)].pointInWorld;
        for (const SeenTag &tag :
             predictedTags(drawn.frame, byPlace(more), tags, drawn.scene.cameras[0].view.camera()))
            QVERIFY(tag.number != 5);
    }
    void ringsTooSmallForTheirHolesAreTakenForDots()
    {
        // 30 by 8 px, the hole 15 by 4.
        const DrawnView drawn = drawFloorView(layout(), MarkerShape::Ring, 0.16, 1019);
        const auto shapes = findRoundMarkers(drawn.frame);
        QVERIFY(std::ranges::count(shapes, RoundMarker::Kind::Ring, &RoundMarker::kind) < 5);
        const auto found = findMarkers(drawn.frame, layout(), known(drawn));
        QVERIFY2(found.has_value(), found ? "" : found.error().message().c_str());
        QVERIFY(rmsOf(*found, drawn.truth).value_or(99) < 0.2);
    }
    void nothingIsForetoldFromOneTagOrWithoutALens()
    {
        const DrawnView drawn = drawFloorView(layout(), MarkerShape::Tag, 0.16, 1002);
        auto tags = findTags(drawn.frame);
        QVERIFY(tags.size() >= 3);
        tags.resize(3);
        QVERIFY(predictedTags(drawn.frame, byPlace(layout()), tags, std::nullopt).empty());
        QVERIFY(!predictedTags(drawn.frame, byPlace(layout()), tags, drawn.scene.cameras[0].view.camera())
                     .empty());
        tags.resize(1);
        QVERIFY(predictedTags(drawn.frame, byPlace(layout()), tags, drawn.scene.cameras[0].view.camera())
                    .empty());
    }
};

ODOGRAPH_TEST(TestMarkerSearch, QCoreApplication)
#include "tst_marker_search.moc"
