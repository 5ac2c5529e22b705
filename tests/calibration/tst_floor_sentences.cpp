// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/marker_assignment.h"
#include "core/calibration/joint_registration.h"
#include "core/calibration/world_axes.h"
#include "core/simulation/demo_testbed.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <set>

using namespace odo;
using Eigen::Vector2d;

namespace {

struct Given
{
    MarkerLayout layout{"floor", {{"O", {0, 0}}, {"U", {2.4, 0}}, {"V", {0, 1.8}}, {"D", {2.7, 2.0}}}};
    FloorView view = simulatedView({-0.9, -1.55, 2.0}, {1.2, 0.8, 0.0}, 1280, 720, 760);
    std::vector<MarkerPixel> pixels;

    Given()
    {
        for (const Marker &marker : layout.markers)
            pixels.push_back(
                {marker.label, *view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0})});
    }
    void scale(double factor)
    {
        for (Marker &marker : layout.markers)
            marker.pointInWorld *= factor;
    }
    /// The layout's marker and its pixel put elsewhere.
    void put(std::size_t marker, const Vector2d &position)
    {
        layout.markers[marker].pointInWorld = position;
        pixels[marker].pixel = *view.pixelFromWorld({position.x(), position.y(), 0});
    }
};

struct BadInput
{
    const char *kind;
    void (*spoil)(Given &);
    const char *why, *advice;
};

const BadInput badInputs[] = {
    {"too few", [](Given &g) { g.pixels.pop_back(); }, "they have 3 (O, U and V)",
     "mark more of the layout's markers"},
    {"names that the layout has not", [](Given &g) { g.pixels[3].label = 'X'; },
     "and the layout does not contain X", "by their names in the layout"},
    {"a label twice in the layout", [](Given &g) { g.layout.markers[1].label = 'O'; },
     "marker O appears twice in the layout", "a name of its own"},
    {"a label twice in the picture", [](Given &g) { g.pixels[1].label = 'O'; },
     "marker O appears twice in the image", "a name of its own"},
    {"a pixel that is no number", [](Given &g) { g.pixels[2].pixel.x() = NAN; },
     "the pixel of marker V is not a finite number", "correct the pixels"},
    {"a place that is no number", [](Given &g) { g.layout.markers[2].pointInWorld.x() = INFINITY; },
     "the position of marker V is not a finite number", "correct the layout"},
    {"one place twice",
     [](Given &g) {
         g.layout.markers[1].pointInWorld = {0.0005, 0};
     },
     "markers O and U have the same floor position", "correct the layout"},
    {"one pixel twice", [](Given &g) { g.pixels[1].pixel = g.pixels[0].pixel; },
     "markers O and U are on the same pixel", "at its own position in the image"},
    {"too close",
     [](Given &g) {
         g.put(1, {0.02, 0.01});
     },
     "markers O and U are only 22.4 mm apart", "spread the markers"},
    {"on one line",
     [](Given &g) {
         g.put(2, {0.9, 0});
         g.put(3, {1.6, 0});
     },
     "U, V and D lie on one line", "no three are in line"},
    {"nearly on one line",
     [](Given &g) {
         g.put(2, {0.9, 0.005});
         g.put(3, {1.6, -0.005});
     },
     "O, U and D lie on one line", "no three are in line"},
    {"mirrored",
     [](Given &g) {
         for (Marker &m : g.layout.markers)
             m.pointInWorld.y() *= -1;
     },
     "mirrored", "check"},
    {"metres for mm", [](Given &g) { g.scale(1e-3); }, "only 2.0 mm above the floor",
     "its numbers look like metres, with the camera 2.00 m"},
    {"a thousand times too large", [](Given &g) { g.scale(1e3); }, "would be 2000 m above the floor",
     "its numbers look like thousandths of a mm"},
    {"two labels exchanged", [](Given &g) { std::swap(g.pixels[1].pixel, g.pixels[2].pixel); }, "",
     "with U and V swapped they fit"},
};

} // namespace

class TestFloorSentences : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void eachKindOfBadInputHasItsOwnSentence()
    {
        std::set<std::string> sentences;
        for (const BadInput &bad : badInputs) {
            Given given;
            bad.spoil(given);
            const auto registration = registerFloor(given.layout, given.pixels, given.view.camera(), true);
            QVERIFY2(!registration.has_value(), bad.kind);
            const Error &error = registration.error();
            QVERIFY2(error.why.english().find(bad.why) != std::string::npos,
                     (std::string(bad.kind) + ": " + error.message()).c_str());
            QVERIFY2(error.advice.english().find(bad.advice) != std::string::npos,
                     (std::string(bad.kind) + ": " + error.message()).c_str());
            QVERIFY2(!error.advice.english().empty() &&
                         error.what.english() == "the floor cannot be registered",
                     bad.kind);
            QVERIFY2(sentences.insert(error.message()).second, bad.kind);
            qInfo("%s: %s", bad.kind, error.message().c_str());
        }
        QVERIFY(sentences.size() >= 12);
    }
    void aSmallFloorIsDoubtedNotRefused()
    {
        Given given;
        given.scale(0.1); // centimetres read as mm
        const auto registration = registerFloor(given.layout, given.pixels, given.view.camera(), true);
        QVERIFY(registration.has_value());
        QVERIFY(registration->verdict.english().find("The camera would be only 200.0 mm above the floor") !=
                std::string::npos);
    }
};

ODOGRAPH_TEST(TestFloorSentences, QCoreApplication)
#include "tst_floor_sentences.moc"
