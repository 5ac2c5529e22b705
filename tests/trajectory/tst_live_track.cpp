// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/live_track.h"
#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QTest>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

struct Seen
{
    std::size_t view;
    Observation observation;
};

/// All views' observations in the order in which they were taken, on the course's clock.
std::vector<Seen> inOrder(const std::vector<ViewTrack> &tracks)
{
    std::vector<Seen> all;
    for (std::size_t v = 0; v < tracks.size(); ++v) {
        for (const Observation &observation : tracks[v].observations) {
            all.push_back({v, observation});
            all.back().observation.time += tracks[v].startOffset;
        }
    }
    std::ranges::stable_sort(all, {}, [](const Seen &seen) { return seen.observation.time; });
    return all;
}

std::vector<LiveView> viewsOf(const std::vector<ViewTrack> &tracks)
{
    std::vector<LiveView> views;
    for (const ViewTrack &track : tracks)
        views.push_back({track.view, track.floorView});
    return views;
}

std::vector<LivePosition> follow(const std::vector<ViewTrack> &tracks, const RobotShape &shape)
{
    LiveTrack live(viewsOf(tracks), shape);
    std::vector<LivePosition> positions;
    for (const Seen &seen : inOrder(tracks)) {
        if (const auto position = live.add(seen.view, seen.observation))
            positions.push_back(*position);
    }
    return positions;
}

/// Root mean squares against the course, from a time on.
struct LiveErrors
{
    double positionM = 0, speedMps = 0;
    int points = 0;
};
LiveErrors errorsFrom(double fromS, const std::vector<LivePosition> &positions, const Course &course)
{
    LiveErrors errors;
    for (const LivePosition &position : positions) {
        const double t = toSeconds(position.sample.time);
        if (t < fromS || !position.point.valid)
            continue;
        const Truth truth = course(t);
        errors.positionM += (position.point.position - truth.position).squaredNorm();
        errors.speedMps += std::pow(position.point.speedMps - truth.velocity.norm(), 2);
        ++errors.points;
    }
    errors.positionM = std::sqrt(errors.positionM / std::max(1, errors.points));
    errors.speedMps = std::sqrt(errors.speedMps / std::max(1, errors.points));
    return errors;
}

constexpr double heightM = 0.06; // a body of that height: its silhouette's centre is filmed at half of it
const RobotShape givenHeight{heightM, std::nullopt, std::nullopt};

} // namespace

class TestLiveTrack : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void followsAtOnce_data();
    void followsAtOnce();
    void findsTheHeightItWasNotTold();
    void oneViewThatStallsIsNotWaitedFor();
    void unregisteredViewsAndUnseenRobotsGiveNoPlace();
    void aSpikeIsNotTakenAndARobotPutElsewhereIs();

private:
    std::mt19937 m_random{7};
    const Course m_eight = figureEight(1.0, 0.6, 8);
    ViewTrack filmed(const FloorView &view, double startS, double fps = 30)
    {
        FilmSettings settings;
        settings.startS = startS;
        settings.framesPerSecond = fps;
        return film(view.cameraInWorld().x() < 0 ? "A" : "B", view, m_eight, settings, m_random);
    }
};

void TestLiveTrack::followsAtOnce_data()
{
    QTest::addColumn<double>("laterS");
    QTest::addColumn<double>("fps");
    QTest::newRow("at one time") << 0.0 << 30.0;
    QTest::newRow("B a third of an interval later") << 0.011 << 30.0;
    QTest::newRow("B two thirds later, at 60 frames/s") << 0.011 << 60.0;
    QTest::newRow("B slower than A") << 0.005 << 24.0;
}

void TestLiveTrack::followsAtOnce()
{
    QFETCH(double, laterS);
    QFETCH(double, fps);
    const std::vector<ViewTrack> tracks{filmed(cameraA(), 0, std::max(30.0, fps)),
                                        filmed(cameraB(), laterS, fps)};
    const auto positions = follow(tracks, givenHeight);
    const LiveErrors errors = errorsFrom(1, positions, m_eight);
    // One position a picture of the faster view, within a twentieth.
    const double rate = std::max(30.0, fps);
    QVERIFY2(errors.points > 0.95 * 9 * rate && errors.points < 1.05 * 9 * rate,
             qPrintable(QString::number(errors.points)));
    // 0.3 px at some 3 m and 950 px are 1 mm a view; filtered without looking ahead hardly less. The speed:
    // what a filter of constant acceleration lags behind at 5 m/s³.
    QVERIFY2(errors.positionM < 0.003, qPrintable(QString::number(errors.positionM)));
    QVERIFY2(errors.speedMps < 0.05, qPrintable(QString::number(errors.speedMps)));
}

void TestLiveTrack::findsTheHeightItWasNotTold()
{
    const std::vector<ViewTrack> tracks{filmed(cameraA(), 0), filmed(cameraB(), 0.01)};
    const LiveErrors errors = errorsFrom(3, follow(tracks, {}), m_eight);
    QVERIFY(errors.points > 200);
    QVERIFY2(errors.positionM < 0.004, qPrintable(QString::number(errors.positionM)));
}

void TestLiveTrack::oneViewThatStallsIsNotWaitedFor()
{
    std::vector<ViewTrack> tracks{filmed(cameraA(), 0), filmed(cameraB(), 0.01)};
    for (ViewTrack *stalled : {&tracks[0], &tracks[1]}) {
        std::vector<ViewTrack> without = tracks;
        auto &observations = without[stalled == &tracks[0] ? 0 : 1].observations;
        std::erase_if(observations, [](const Observation &each) { return each.time > 4s && each.time < 7s; });
        const auto positions = follow(without, givenHeight);
        int alone = 0;
        Nanoseconds last{0}, longest{0};
        for (const LivePosition &position : positions) {
            alone += std::popcount(position.sample.views) == 1;
            longest = std::max(longest, position.sample.time - last);
            last = position.sample.time;
        }
        QVERIFY2(alone > 70, qPrintable(QString::number(alone))); // of 90
        QVERIFY2(longest < 300ms, qPrintable(QString::number(toSeconds(longest))));
        QVERIFY(errorsFrom(1, positions, m_eight).positionM < 0.004);
    }
}

void TestLiveTrack::unregisteredViewsAndUnseenRobotsGiveNoPlace()
{
    std::vector<ViewTrack> tracks{filmed(cameraA(), 0), filmed(cameraB(), 0.01)};
    tracks[0].floorView.reset();
    const auto one = follow(tracks, givenHeight);
    QVERIFY(errorsFrom(1, one, m_eight).points > 250);
    QCOMPARE(one.back().sample.views, 2u);

    for (Observation &observation : tracks[1].observations)
        observation.found = false;
    const auto unseen = follow(tracks, givenHeight);
    QVERIFY(unseen.size() > 250);
    for (const LivePosition &position : unseen) {
        QVERIFY(!position.sample.position && !position.point.valid && !position.isSpike);
        QVERIFY(hasFlag(position.sample.flags, SampleFlag::Lost));
    }
    tracks[1].floorView.reset();
    QVERIFY(follow(tracks, givenHeight).empty());
}

void TestLiveTrack::aSpikeIsNotTakenAndARobotPutElsewhereIs()
{
    std::vector<ViewTrack> tracks{filmed(cameraA(), 0), filmed(cameraB(), 0)};
    const auto moveTo = [&](std::size_t from, std::size_t to, const Eigen::Vector2d &by) {
        for (ViewTrack &track : tracks) {
            for (std::size_t i = from; i < to; ++i) {
                const Eigen::Vector2d place = m_eight(i / 30.0).position + by;
                track.observations[i].ellipse.centrePx =
                    *track.floorView->pixelFromWorld({place.x(), place.y(), heightM / 2});
            }
        }
    };
    moveTo(120, 122, {0.2, 0});
    moveTo(200, 300, {0, 0.3});
    const auto positions = follow(tracks, givenHeight);
    QCOMPARE(positions.size(), std::size_t(300));
    QVERIFY(positions[120].isSpike && positions[121].isSpike && !positions[119].isSpike &&
            !positions[122].isSpike);
    QVERIFY((positions[121].point.position - m_eight(121 / 30.0).position).norm() < 0.02);
    QVERIFY(positions[200].isSpike && !positions[206].isSpike);
    QVERIFY((positions[215].point.position - m_eight(215 / 30.0).position - Eigen::Vector2d(0, 0.3)).norm() <
            0.02);
}

ODOGRAPH_TEST(TestLiveTrack, QCoreApplication)
#include "tst_live_track.moc"
