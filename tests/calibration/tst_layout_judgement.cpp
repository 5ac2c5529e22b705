// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/marker_assignment.h"
#include "core/geometry/homography.h"
#include "core/simulation/demo_testbed.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <array>
#include <map>
#include <random>

using namespace odo;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// How many layouts are drawn: a sample, or with ODOGRAPH_LAYOUTS=1000000 what is claimed (docs/testing.md).
int drawCount()
{
    const int told = qEnvironmentVariableIntValue("ODOGRAPH_LAYOUTS");
    return told > 0 ? told : 3000;
}

/// A layout, a camera that sees all of it, and the pixels that somebody marked.
struct Case
{
    MarkerLayout layout;
    std::vector<MarkerPixel> pixels;
    FloorView view;
};

class Draws
{
public:
    explicit Draws(std::uint32_t seed) : m_random(seed) {}

    double share() { return std::uniform_real_distribution<double>(0, 1)(m_random); }
    double noise() { return std::normal_distribution<double>()(m_random); }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(m_random() % count); }

    /// Four to seven markers, none of the best four nearer than an eighth of the extent to the line of two
    /// others.
    MarkerLayout layout(std::size_t markers)
    {
        for (;;) {
            MarkerLayout layout{"floor", {}};
            std::vector<Vector2d> points;
            const double size = 1 + 4 * share();
            for (std::size_t i = 0; i < markers; ++i) {
                points.push_back(size * Vector2d(share(), share()));
                layout.markers.push_back({std::string(1, static_cast<char>('A' + i)), points.back()});
            }
            if (extentOf(points) > 0.4 * size && widestQuadrilateral(points).flatness > 0.125 &&
                areApart(points))
                return layout;
        }
    }

    /// Pixels with half a pixel of noise, by a camera that has all markers in its picture and does not look
    /// at them from beneath 10°.
    std::optional<Case> seen(const MarkerLayout &layout, double noisePx = 0.5)
    {
        Vector2d middle = Vector2d::Zero();
        for (const Marker &marker : layout.markers)
            middle += marker.pointInWorld / static_cast<double>(layout.markers.size());
        for (int tries = 0; tries < 40; ++tries) {
            const double direction = 2 * EIGEN_PI * share(), away = 0.5 + 5 * share(),
                         height = 0.8 + 3 * share();
            const Vector3d position(middle.x() + away * std::cos(direction),
                                    middle.y() + away * std::sin(direction), height);
            Case drawn{layout,
                       {},
                       simulatedView(position, {middle.x(), middle.y(), 0}, 1280, 720, 600 + 600 * share())};
            if (std::atan2(height, away) < 0.17 || !mark(drawn, noisePx))
                continue;
            return drawn;
        }
        return std::nullopt;
    }

private:
    static bool areApart(const std::vector<Vector2d> &points)
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if ((points[i] - points[j]).norm() < 0.08 * extentOf(points))
                    return false;
        return true;
    }

    bool mark(Case &drawn, double noisePx)
    {
        for (const Marker &marker : drawn.layout.markers) {
            const auto pixel =
                drawn.view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
            if (!pixel || pixel->x() < 0 || pixel->y() < 0 || pixel->x() > 1279 || pixel->y() > 719)
                return false;
            drawn.pixels.push_back({marker.label, *pixel + noisePx * Vector2d(noise(), noise())});
        }
        std::vector<Vector2d> points;
        for (const MarkerPixel &pixel : drawn.pixels)
            points.push_back(pixel.pixel);
        return extentOf(points) > 250;
    }

    std::mt19937 m_random;
};

/// Spoils a sound case; the name says how.
struct Fault
{
    const char *name;
    bool (*spoil)(Case &, Draws &);
};

void alignOnLine(Case &drawn, Draws &draws, std::size_t count)
{
    // Laid on the line of the first and the last, in the layout and in the picture.
    const Vector2d from = drawn.layout.markers.front().pointInWorld,
                   to = drawn.layout.markers[count - 1].pointInWorld;
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const Vector2d position =
            from + (static_cast<double>(i) / static_cast<double>(count - 1)) * (to - from);
        drawn.layout.markers[i].pointInWorld = position;
        drawn.pixels[i].pixel = *drawn.view.pixelFromWorld({position.x(), position.y(), 0}) +
                                0.3 * Vector2d(draws.noise(), draws.noise());
    }
}

const Fault faults[] = {
    {"all on one line",
     [](Case &drawn, Draws &draws) {
         alignOnLine(drawn, draws, drawn.pixels.size());
         return true;
     }},
    {"three of four on one line",
     [](Case &drawn, Draws &draws) {
         drawn.layout.markers.resize(4);
         drawn.pixels.resize(4);
         alignOnLine(drawn, draws, 3);
         return true;
     }},
    {"one place twice",
     [](Case &drawn, Draws &draws) {
         drawn.layout.markers[1].pointInWorld =
             drawn.layout.markers[0].pointInWorld + 1e-4 * Vector2d(draws.noise(), draws.noise());
         return true;
     }},
    {"one pixel twice",
     [](Case &drawn, Draws &draws) {
         drawn.pixels[1].pixel = drawn.pixels[0].pixel + 0.2 * Vector2d(draws.share(), draws.share());
         return true;
     }},
    {"too close",
     [](Case &drawn, Draws &draws) {
         drawn.layout.markers.resize(4);
         drawn.pixels.resize(4);
         std::vector<Vector2d> others;
         for (const std::size_t i : {0U, 2U, 3U})
             others.push_back(drawn.layout.markers[i].pointInWorld);
         const Vector2d near = others[0] + 0.007 * extentOf(others) * Vector2d(draws.share(), 0.5);
         drawn.layout.markers[1].pointInWorld = near;
         drawn.pixels[1].pixel =
             *drawn.view.pixelFromWorld({near.x(), near.y(), 0}) + Vector2d(draws.noise(), draws.noise());
         return true;
     }},
    {"mirrored",
     [](Case &drawn, Draws &) {
         for (Marker &marker : drawn.layout.markers)
             marker.pointInWorld.x() *= -1;
         return true;
     }},
    {"a thousand times too small",
     [](Case &drawn, Draws &) {
         for (Marker &marker : drawn.layout.markers)
             marker.pointInWorld /= 1000;
         return true;
     }},
    {"a thousand times too large",
     [](Case &drawn, Draws &) {
         for (Marker &marker : drawn.layout.markers)
             marker.pointInWorld *= 1000;
         return true;
     }},
    {"a place behind the camera",
     [](Case &drawn, Draws &draws) {
         // Every homography maps it to a pixel, where nothing is seen: the camera would have to look
         // backwards.
         const RigidTransform cameraFromWorld = drawn.view.cameraFromWorld();
         const Vector3d eye = cameraFromWorld.inverse().translation,
                        ahead = cameraFromWorld.rotation.conjugate() * Vector3d::UnitZ();
         const double flat = ahead.head<2>().norm();
         if (flat < 0.3)
             return false; // it looks down: its horizon is far above the picture
         const double back = (eye.z() * std::abs(ahead.z()) + 0.3 + draws.share()) / flat;
         const Vector2d forwards = ahead.head<2>() / flat,
                        position = eye.head<2>() - back * forwards +
                                   (draws.share() - 0.5) * Vector2d(-forwards.y(), forwards.x());
         const Vector3d inCamera = cameraFromWorld * Vector3d(position.x(), position.y(), 0);
         const Intrinsics &lens = drawn.view.camera().intrinsics();
         const std::size_t which = draws.below(drawn.pixels.size());
         drawn.layout.markers[which].pointInWorld = position;
         drawn.pixels[which].pixel =
             Vector2d(lens.cxPx, lens.cyPx) + lens.fxPx * Vector2d(inCamera.hnormalized());
         return true;
     }},
    {"a pixel above the horizon",
     [](Case &drawn, Draws &draws) {
         const RigidTransform cameraFromWorld = drawn.view.cameraFromWorld();
         const Vector3d ahead = cameraFromWorld.rotation.conjugate() * Vector3d::UnitZ();
         const double up = 0.01 + 0.15 * draws.share(), aside = 0.5 * (draws.share() - 0.5),
                      direction = std::atan2(ahead.y(), ahead.x()) + aside;
         const Vector3d sky(std::cos(direction), std::sin(direction), up);
         const auto pixel = drawn.view.camera().project(cameraFromWorld.rotation * sky);
         if (!pixel || pixel->y() < -360) // no person would click so far outside the picture
             return false;
         drawn.pixels[draws.below(drawn.pixels.size())].pixel = *pixel;
         return true;
     }},
    {"no number",
     [](Case &drawn, Draws &draws) {
         drawn.pixels[draws.below(4)].pixel.y() = std::nan("");
         return true;
     }},
    {"three markers",
     [](Case &drawn, Draws &) {
         drawn.pixels.resize(3);
         return true;
     }},
    {"a label twice",
     [](Case &drawn, Draws &) {
         drawn.pixels[2].label = drawn.pixels[0].label;
         return true;
     }},
};

Result<FloorRegistration> judged(const Case &drawn)
{
    return registerFloor(drawn.layout, drawn.pixels, drawn.view.camera(), true);
}

/// Shapes at pixels, in another order than the labels'.
std::vector<RoundMarker> shapesAt(const std::vector<MarkerPixel> &pixels)
{
    std::vector<RoundMarker> shapes;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Vector2d &pixel = pixels[(i + 2) % pixels.size()].pixel;
        shapes.push_back({RoundMarker::Kind::Ring, pixel, 0.05, {pixel, {0, 0}, 0}});
    }
    return shapes;
}

bool isEqual(const std::vector<MarkerPixel> &some, const std::vector<MarkerPixel> &others)
{
    return std::ranges::all_of(some, [&](const MarkerPixel &pixel) {
        const auto other = std::ranges::find(others, pixel.label, &MarkerPixel::label);
        return other != others.end() && other->pixel == pixel.pixel;
    });
}

} // namespace

class TestLayoutJudgement : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void soundLayoutsAreNotRefused()
    {
        Draws draws(1);
        int refused = 0, tried = 0;
        const int count = drawCount();
        while (tried < count) {
            const auto drawn = draws.seen(draws.layout(4 + draws.below(4)));
            if (!drawn)
                continue;
            Case measured = *drawn;
            for (Marker &marker : measured.layout.markers) // by a tape
                marker.pointInWorld += 0.002 * Vector2d(draws.noise(), draws.noise());
            ++tried;
            const auto registration = judged(measured);
            if (!registration && ++refused <= 5)
                qInfo("refused: %s", registration.error().message().c_str());
        }
        qInfo("%d of %d sound layouts refused", refused, tried);
        QVERIFY(refused <= tried / 1000);
    }
    void noDegenerateLayoutIsAccepted()
    {
        Draws draws(2);
        std::map<std::string, int> accepted;
        int tried = 0;
        const int count = drawCount();
        while (tried < count) {
            auto drawn = draws.seen(draws.layout(4 + draws.below(3)));
            if (!drawn)
                continue;
            for (const Fault &fault : faults) {
                Case spoilt = *drawn;
                if (!fault.spoil(spoilt, draws))
                    continue;
                ++tried;
                if (const auto registration = judged(spoilt)) {
                    if (++accepted[fault.name] <= 2)
                        qInfo("accepted (%s): %s", fault.name, registration->verdict.english().c_str());
                }
            }
        }
        int sum = 0;
        for (const auto &[name, times] : accepted) {
            qInfo("%s: %d accepted", name.c_str(), times);
            sum += times;
        }
        qInfo("%d of %d degenerate layouts accepted", sum, tried);
        QCOMPARE(sum, 0);
    }
    void ofAllOrdersOfFourNoneIsAcceptedThatThePictureCanTell()
    {
        Draws draws(3);
        int wrong = 0, indistinguishable = 0, tried = 0, given = 0, asked = 0, mistaken = 0;
        const int count = drawCount() / 12;
        while (tried < count) {
            const auto drawn = draws.seen(draws.layout(4), 0.2);
            if (!drawn)
                continue;
            ++tried;
            std::array<std::size_t, 4> order{0, 1, 2, 3};
            while (std::ranges::next_permutation(order).found) {
                Case swapped = *drawn;
                for (std::size_t i = 0; i < 4; ++i)
                    swapped.pixels[i].pixel = drawn->pixels[order[i]].pixel;
                const auto registration = judged(swapped);
                if (!registration)
                    continue;
                // Nobody can tell an order that fits to a pixel from the right one: a layout that looks
                // nearly the same turned. There the labels count, which a tag's number or a person gave.
                (registration->rmsPx < 1 ? indistinguishable : wrong) += 1;
                if (registration->rmsPx >= 1 && wrong <= 3)
                    qInfo("accepted at %.1f px: %s", registration->rmsPx,
                          registration->verdict.english().c_str());
            }
            if (tried % 10 != 0)
                continue;
            // Where nobody gave them, the program names the markers rightly or asks.
            const auto named =
                assignMarkers(shapesAt(drawn->pixels), drawn->layout, drawn->view.camera(), true);
            (named ? given : asked) += 1;
            mistaken += named && !isEqual(*named, drawn->pixels);
        }
        qInfo("%d layouts in 23 wrong orders: %d accepted, and %d that fit to a pixel; named by their places "
              "alone: %d, of them wrongly %d; asked: %d",
              tried, wrong, indistinguishable, given, mistaken, asked);
        QCOMPARE(wrong, 0);
        QCOMPARE(mistaken, 0);
    }
};

ODOGRAPH_TEST(TestLayoutJudgement, QCoreApplication)
#include "tst_layout_judgement.moc"
