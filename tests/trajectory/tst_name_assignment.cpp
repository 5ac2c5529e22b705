// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/chroma.h"
#include "core/trajectory/internal/name_evidence.h"
#include "core/trajectory/name_assignment.h"
#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <Eigen/Geometry>
#include <QtTest>
#include <set>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

constexpr RgbColour red{0xd7, 0x23, 0x28}, orangeRed{0xd8, 0x48, 0x1c}, blue{0x1f, 0x6f, 0xd0};

/// Runs to and fro along x at a given y, starting at −0.9 or 0.9.
Course shuttle(double y, double startX, double periodS)
{
    return [=](double t) {
        Truth truth;
        truth.position = {startX * std::cos(2 * M_PI * t / periodS), y};
        return truth;
    };
}

/// Runs up to x = 0 from one side, without reaching it, and back again.
Course bouncer(double y, double side, double periodS)
{
    return [=](double t) {
        Truth truth;
        truth.position = {side * (0.5 + 0.42 * std::cos(2 * M_PI * t / periodS)), y};
        return truth;
    };
}

struct Stretch
{
    double beginS, endS;
    bool contains(double t) const { return t >= beginS && t < endS; }
};

/// Observations of one view whose robots are one in the picture in some stretches (low score there), and
/// whose names the tracker exchanges behind each of the told ones.
struct FilmedView
{
    FloorView view;
    double startS = 0;
    std::vector<Stretch> together;
    std::set<int> exchangedAfter; ///< indices of stretches
    bool registered = true;
};

Vector2d chromaFor(RgbColour colour)
{
    return chromaOf(colour, FrameFormat{});
}

std::vector<NamedView> filmAll(const std::vector<FilmedView> &cameras, const std::vector<Course> &courses,
                               const std::vector<RgbColour> &shown, std::mt19937 &random,
                               const std::set<std::size_t> &exchangedFromStart = {})
{
    std::vector<NamedView> filmed;
    std::normal_distribution<double> noise(0, 1);
    for (std::size_t v = 0; v < cameras.size(); ++v) {
        const FilmedView &camera = cameras[v];
        FilmSettings settings;
        settings.startS = camera.startS;
        settings.noisePx = 0.5;
        NamedView view;
        if (camera.registered)
            view.floorView = camera.view;
        view.startOffset = fromSeconds(camera.startS);
        std::vector<std::vector<Observation>> truth;
        for (std::size_t r = 0; r < courses.size(); ++r) {
            truth.push_back(film("", camera.view, courses[r], settings, random).observations);
            for (Observation &observation : truth.back())
                observation.meanChroma = chromaFor(shown[r]) + 0.5 * Vector2d(noise(random), noise(random));
        }
        view.robots = truth;
        bool exchanged = exchangedFromStart.contains(v);
        std::size_t inside = camera.together.size();
        for (std::size_t i = 0; i < truth[0].size(); ++i) {
            const double t = toSeconds(truth[0][i].time) + camera.startS;
            std::size_t now = camera.together.size();
            for (std::size_t k = 0; k < camera.together.size(); ++k)
                now = camera.together[k].contains(t) ? k : now;
            if (now == camera.together.size() && inside != now && camera.exchangedAfter.contains(int(inside)))
                exchanged = !exchanged;
            inside = now;
            for (std::size_t slot = 0; slot < courses.size(); ++slot) {
                const std::size_t owner = exchanged && slot < 2 ? 1 - slot : slot;
                view.robots[slot][i] = truth[owner][i];
                if (now < camera.together.size() && slot < 2) {
                    view.robots[slot][i].score = 0.1;
                    view.robots[slot][i].meanChroma.setZero();
                }
            }
        }
        filmed.push_back(std::move(view));
    }
    return filmed;
}

/// How many sure observations in all views bear another name than the truth. Where colours are equal the
/// names as a whole may be either way round.
int wrongNames(const std::vector<NamedView> &views, const std::vector<FilmedView> &cameras,
               const std::vector<Course> &courses, bool eitherWay)
{
    std::array<int, 2> wrong{0, 0};
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t r = 0; r < courses.size(); ++r) {
            for (const Observation &observation : views[v].robots[r]) {
                if (!isSure(observation))
                    continue;
                const double t = toSeconds(observation.time) + cameras[v].startS;
                std::size_t nearest = 0;
                double least = 1e9;
                for (std::size_t other = 0; other < courses.size(); ++other) {
                    const Vector2d at = courses[other](t).position;
                    const double away = (*cameras[v].view.pixelFromWorld({at.x(), at.y(), 0.03}) -
                                         observation.ellipse.centrePx)
                                            .norm();
                    if (away < least) {
                        least = away;
                        nearest = other;
                    }
                }
                wrong[0] += nearest != r;
                wrong[1] += nearest != (r < 2 ? 1 - r : r);
            }
        }
    }
    return eitherWay ? std::min(wrong[0], wrong[1]) : wrong[0];
}

const std::vector<Stretch> fiveMeetings{{0.9, 1.3}, {2.8, 3.3}, {4.9, 5.3}, {6.8, 7.2}, {8.8, 9.3}};

} // namespace

class TestNameAssignment : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cutsAtLowScores();
    void joiningPrefersTheMotion();
    void oneViewExchanges_data();
    void oneViewExchanges();
    void bothViewsExchange();
    void oneViewAlone();
    void unregisteredView();
    void namedTheOtherWayRoundFromTheStart();
    void unlikeColoursAreLeftAlone();
    void wrongOffsetIsNotBelieved();
    void observationsAreKept();
    void sixOfOneLook();
    void oneOfTwoIsNamedOnce();
    void whoComesBackIsNoOther();
    void whereNothingDecidesIsDoubtful();
};

void TestNameAssignment::cutsAtLowScores()
{
    std::mt19937 random(1);
    auto filmed = filmAll({{cameraA(), 0, {{2, 3}}, {}}}, {shuttle(0, 0.9, 4), shuttle(0.35, -0.9, 4)},
                          {red, red}, random);
    const auto tracklets = cutIntoTracklets(filmed[0].robots[0], {std::chrono::milliseconds(500), 0});
    QCOMPARE(tracklets.size(), std::size_t(2));
    QCOMPARE(tracklets[0].last, std::size_t(59));
    QCOMPARE(tracklets[1].first, std::size_t(90));
    QVERIFY(std::abs(tracklets[1].begin.timeS - 3.5) < 1e-6);
    QVERIFY((tracklets[0].meanChroma - chromaFor(red)).norm() < 0.5);
    QVERIFY(cutIntoTracklets({}, {}).empty());
}

void TestNameAssignment::joiningPrefersTheMotion()
{
    const Tracklet::End end{1.0, {100, 100}, {200, 0}, 25};
    const Tracklet::End goesOn{1.3, {160, 101}, {200, 0}, 25}, comesTowards{1.3, {100, 125}, {-200, 0}, 25};
    QVERIFY(costOfJoining(end, goesOn) < 0.1);
    QVERIFY(costOfJoining(end, comesTowards) > 2);
    // After a long time anything may have happened.
    QVERIFY(costOfJoining(end, {5.0, {100, 125}, {-200, 0}, 25}) < 0.5);
}

void TestNameAssignment::oneViewExchanges_data()
{
    QTest::addColumn<bool>("equal");
    QTest::addColumn<bool>("bounce");
    QTest::addColumn<bool>("givesHeight");
    QTest::newRow("equal colours, passing") << true << false << true;
    QTest::newRow("equal colours, passing, height not told") << true << false << false;
    QTest::newRow("equal colours, turning back") << true << true << false;
    QTest::newRow("similar colours, passing") << false << false << true;
    QTest::newRow("similar colours, turning back") << false << true << false;
}

void TestNameAssignment::oneViewExchanges()
{
    QFETCH(bool, equal);
    QFETCH(bool, bounce);
    QFETCH(bool, givesHeight);
    const std::vector<Course> courses = bounce
                                            ? std::vector<Course>{bouncer(0, 1, 4), bouncer(0.2, -1, 4)}
                                            : std::vector<Course>{shuttle(0, 0.9, 4), shuttle(0.35, -0.9, 4)};
    const std::vector<RgbColour> colours{red, equal ? red : orangeRed};
    std::optional<double> height;
    if (givesHeight)
        height = 0.06;
    for (unsigned seed = 0; seed < 6; ++seed) {
        std::mt19937 random(seed);
        std::vector<FilmedView> cameras{{cameraA(), 0, fiveMeetings, {}},
                                        {cameraB(), 0.011, {{1.1, 1.4}, {6.9, 7.3}}, {}}};
        for (int k = 0; k < 5; ++k) {
            if (random() % 2)
                cameras[0].exchangedAfter.insert(k);
        }
        auto filmed = filmAll(cameras, courses, colours, random);
        assignNames(filmed, {{colours[0], height}, {colours[1], height}});
        QCOMPARE(wrongNames(filmed, cameras, courses, equal), 0);
    }
}

void TestNameAssignment::bothViewsExchange()
{
    // At the same meetings: only the motion tells, and it goes on.
    const std::vector<Course> courses{shuttle(0, 0.9, 4), shuttle(0.35, -0.9, 4)};
    std::mt19937 random(3);
    const std::vector<FilmedView> cameras{{cameraA(), 0, fiveMeetings, {0, 1, 3}},
                                          {cameraB(), 0.02, fiveMeetings, {0, 2, 3}}};
    auto filmed = filmAll(cameras, courses, {red, red}, random);
    QVERIFY(assignNames(filmed, {{red, 0.06}, {red, 0.06}}).renamed > 0);
    QCOMPARE(wrongNames(filmed, cameras, courses, true), 0);
}

void TestNameAssignment::oneViewAlone()
{
    const std::vector<Course> courses{shuttle(0, 0.9, 4), shuttle(0.35, -0.9, 4)};
    std::mt19937 random(4);
    const std::vector<FilmedView> cameras{{cameraA(), 0, fiveMeetings, {1, 2, 4}}};
    auto filmed = filmAll(cameras, courses, {red, red}, random);
    assignNames(filmed, {{red, {}}, {red, {}}});
    QCOMPARE(wrongNames(filmed, cameras, courses, true), 0);
}

void TestNameAssignment::unregisteredView()
{
    const std::vector<Course> courses{shuttle(0, 0.9, 4), shuttle(0.35, -0.9, 4)};
    std::mt19937 random(5);
    std::vector<FilmedView> cameras{{cameraA(), 0, fiveMeetings, {1, 2}},
                                    {cameraB(), 0, {{1.1, 1.4}}, {0}, false}};
    auto filmed = filmAll(cameras, courses, {red, orangeRed}, random);
    assignNames(filmed, {{red, {}}, {orangeRed, {}}});
    QCOMPARE(wrongNames(filmed, cameras, courses, false), 0);
}

void TestNameAssignment::namedTheOtherWayRoundFromTheStart()
{
    const std::vector<Course> courses{shuttle(0, 0.9, 4), shuttle(0.35, -0.9, 4)};
    for (const bool equal : {true, false}) {
        std::mt19937 random(6);
        const std::vector<FilmedView> cameras{{cameraA(), 0, {}, {}}, {cameraB(), 0, {{1.1, 1.4}}, {}}};
        // The camera's white balance turns both hues by 10°: only the order of the two is right.
        const std::vector<RgbColour> given{red, equal ? red : orangeRed};
        auto filmed = filmAll(cameras, courses, given, random,
                              equal ? std::set<std::size_t>{1} : std::set<std::size_t>{0, 1});
        for (NamedView &view : filmed) {
            for (auto &observations : view.robots) {
                for (Observation &observation : observations)
                    observation.meanChroma = Eigen::Rotation2Dd(0.17) * observation.meanChroma;
            }
        }
        assignNames(filmed, {{given[0], 0.06}, {given[1], 0.06}});
        QCOMPARE(wrongNames(filmed, cameras, courses, equal), 0);
    }
}

void TestNameAssignment::unlikeColoursAreLeftAlone()
{
    const std::vector<Course> courses{shuttle(0, 0.9, 4), shuttle(0.35, -0.9, 4)};
    std::mt19937 random(7);
    auto filmed =
        filmAll({{cameraA(), 0, fiveMeetings, {0}}, {cameraB(), 0, {}, {}}}, courses, {red, blue}, random);
    QCOMPARE(assignNames(filmed, {{red, {}}, {blue, {}}}).renamed, std::int64_t(0));
}

void TestNameAssignment::wrongOffsetIsNotBelieved()
{
    // Clips told to start together that do not: the floor contradicts everything, the motion does not.
    const std::vector<Course> courses{shuttle(0, 0.9, 4), shuttle(0.35, -0.9, 4)};
    std::mt19937 random(8);
    const std::vector<FilmedView> cameras{{cameraA(), 0, fiveMeetings, {}}, {cameraB(), 1.0, {}, {}}};
    auto filmed = filmAll(cameras, courses, {red, orangeRed}, random);
    filmed[1].startOffset = Nanoseconds{0};
    QCOMPARE(assignNames(filmed, {{red, 0.06}, {orangeRed, 0.06}}).renamed, std::int64_t(0));
}

void TestNameAssignment::observationsAreKept()
{
    const std::vector<Course> courses{shuttle(0, 0.9, 4), shuttle(0.35, -0.9, 4), shuttle(0.9, 0.5, 5)};
    std::mt19937 random(9);
    auto filmed = filmAll({{cameraA(), 0, fiveMeetings, {0, 3}}, {cameraB(), 0, {}, {}}}, courses,
                          {red, red, blue}, random);
    const auto before = filmed;
    assignNames(filmed, {{red, {}}, {red, {}}, {blue, {}}});
    for (std::size_t v = 0; v < before.size(); ++v) {
        for (std::size_t i = 0; i < before[v].robots[0].size(); ++i) {
            std::multiset<double> was, is;
            for (std::size_t r = 0; r < 3; ++r) {
                was.insert(before[v].robots[r][i].ellipse.centrePx.x());
                is.insert(filmed[v].robots[r][i].ellipse.centrePx.x());
                QCOMPARE(filmed[v].robots[r][i].frame, before[v].robots[r][i].frame);
            }
            QVERIFY(was == is);
            QCOMPARE(filmed[v].robots[2][i].ellipse.centrePx.x(),
                     before[v].robots[2][i].ellipse.centrePx.x());
        }
    }
}

void TestNameAssignment::sixOfOneLook()
{
    std::vector<Course> courses;
    for (int r = 0; r < 6; ++r)
        courses.push_back(shuttle(-0.75 + 0.3 * r, r % 2 ? -0.9 : 0.9, 4 + 0.3 * r));
    std::mt19937 random(10);
    const std::vector<FilmedView> cameras{{cameraA(), 0, {}, {}}, {cameraB(), 0.02, {}, {}}};
    auto filmed = filmAll(cameras, courses, std::vector<RgbColour>(6, red), random);
    // the second tracker found them in another order
    std::ranges::rotate(filmed[1].robots, filmed[1].robots.begin() + 2);
    std::swap(filmed[1].robots[0], filmed[1].robots[4]);
    const NameOutcome outcome = assignNames(filmed, std::vector<NamedRobot>(6));
    QVERIFY(outcome.renamed > 0);
    QCOMPARE(outcome.ambiguities.size(), std::size_t(0));
    QCOMPARE(wrongNames(filmed, cameras, courses, true), 0);
}

/// What both views see at one place is one robot, whatever else was told.
void TestNameAssignment::oneOfTwoIsNamedOnce()
{
    std::mt19937 random(11);
    auto filmed = filmAll({{cameraA(), 0, {}, {}}, {cameraB(), 0, {}, {}}},
                          {shuttle(0, 0.9, 4), shuttle(0.35, -0.9, 4)}, {red, red}, random);
    for (NamedView &view : filmed)
        for (Observation &observation : view.robots[1])
            observation.found = false;
    std::swap(filmed[1].robots[0], filmed[1].robots[1]);
    assignNames(filmed, std::vector<NamedRobot>(2));
    for (const std::size_t robot : {0u, 1u})
        QCOMPARE(std::ranges::any_of(filmed[0].robots[robot], &Observation::found),
                 std::ranges::any_of(filmed[1].robots[robot], &Observation::found));
}

/// A robot that was lost and has turned meanwhile, of two that were told.
void TestNameAssignment::whoComesBackIsNoOther()
{
    const Course turning = [](double t) {
        return Truth{t < 3 ? Vector2d(-0.9 + 0.5 * t, 0) : Vector2d(0.6 - 0.4 * (t - 3), 0.1), {}, {}};
    };
    std::mt19937 random(13);
    auto filmed = filmAll({{cameraA(), 0, {}, {}}, {cameraB(), 0, {}, {}}}, {turning, shuttle(0.35, -0.9, 4)},
                          {red, red}, random);
    for (NamedView &view : filmed)
        for (std::size_t i = 0; i < view.robots[0].size(); ++i) {
            const double timeS = toSeconds(view.robots[0][i].time);
            view.robots[1][i].found = false;
            if (timeS > 2.8 && timeS < 3.3)
                view.robots[0][i].found = false;
            if (timeS >= 3.3)
                std::swap(view.robots[0][i], view.robots[1][i]); // the tracker took the other slot for it
        }
    assignNames(filmed, std::vector<NamedRobot>(2));
    for (const NamedView &view : filmed)
        QVERIFY(std::ranges::none_of(view.robots[0], &Observation::found) ||
                std::ranges::none_of(view.robots[1], &Observation::found));
}

/// Two come together head on, stand, and leave to both sides: nobody who did not see them meanwhile can say
/// who went where.
void TestNameAssignment::whereNothingDecidesIsDoubtful()
{
    const auto meeting = [](double side) -> Course {
        return [side](double t) {
            Truth truth;
            truth.position = {side * (0.06 + 0.3 * std::pow(std::max(0.0, 3 - t), 2) / 2),
                              side * 0.3 * std::pow(std::max(0.0, t - 5), 2) / 2};
            return truth;
        };
    };
    std::mt19937 random(12);
    const std::vector<Stretch> together{{2.2, 6}};
    auto filmed = filmAll({{cameraA(), 0, together, {}}, {cameraB(), 0, together, {}}},
                          {meeting(1), meeting(-1)}, {red, red}, random);
    const NameOutcome outcome = assignNames(filmed, std::vector<NamedRobot>(2));
    QCOMPARE(outcome.ambiguities.size(), std::size_t(2));
    for (std::size_t robot = 0; robot < 2; ++robot) {
        QCOMPARE(outcome.ambiguities[robot].robot, robot);
        QVERIFY(std::abs(outcome.ambiguities[robot].fromS - 2.2) < 0.1);
        QVERIFY(std::abs(outcome.ambiguities[robot].toS - 6) < 0.1);
        QVERIFY((outcome.ambiguities[robot].others == std::vector<std::size_t>{1 - robot}));
    }
    // Passing one another they go on as they came.
    auto passing = filmAll({{cameraA(), 0, fiveMeetings, {}}, {cameraB(), 0, fiveMeetings, {}}},
                           {shuttle(0, 0.9, 4), shuttle(0.35, -0.9, 4)}, {red, red}, random);
    QCOMPARE(assignNames(passing, std::vector<NamedRobot>(2)).ambiguities.size(), std::size_t(0));
}

ODOGRAPH_TEST(TestNameAssignment, QCoreApplication)
#include "tst_name_assignment.moc"
