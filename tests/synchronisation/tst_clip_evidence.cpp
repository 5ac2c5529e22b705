// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/clip_evidence.h"
#include "tests/support/registered_test.h"
#include "tests/synchronisation/synthetic_light.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr OffsetRange tenSeconds{0, 10};

/// Turns and changes its speed, never twice alike.
Course wandering(double phase, Eigen::Vector2d middle)
{
    return [=](double t) {
        Truth truth;
        truth.position =
            middle + Eigen::Vector2d(0.5 * std::sin(0.61 * t + phase) + 0.2 * std::sin(1.7 * t + 2 * phase),
                                     0.4 * std::cos(0.43 * t + phase) + 0.15 * std::sin(1.3 * t));
        return truth;
    };
}

Course straight()
{
    return [](double t) {
        Truth truth;
        truth.position = {-0.6 + 0.1 * t, 0.1 + 0.02 * t};
        return truth;
    };
}

Course roundAndRound()
{
    return [](double t) {
        Truth truth;
        truth.position = 0.5 * Eigen::Vector2d(std::cos(2.5 * t), std::sin(2.5 * t));
        return truth;
    };
}

/// Two registered views of some robots, of which the second was begun later.
struct Filmed
{
    std::vector<NamedView> views{2};
    std::vector<NamedRobot> robots;
    std::vector<std::string> names;
    std::vector<ClipEvidence> evidence{2};
    double offsetS = 0;

    Filmed(const std::vector<Course> &courses, const std::vector<RgbColour> &colours, double theOffsetS,
           double durationS = 10)
        : offsetS(theOffsetS)
    {
        std::mt19937 random(7);
        views[0].floorView = cameraA();
        views[1].floorView = cameraB();
        for (std::size_t v = 0; v < 2; ++v) {
            FilmSettings settings;
            settings.durationS = durationS;
            settings.startS = v == 0 ? 0 : offsetS;
            for (const Course &course : courses)
                views[v].robots.push_back(
                    film("A", *views[v].floorView, course, settings, random).observations);
        }
        for (std::size_t r = 0; r < courses.size(); ++r) {
            robots.push_back({colours[r], 0.06});
            names.push_back('R' + std::to_string(r + 1));
        }
    }

    void flash(const std::vector<LightStep> &first, const std::vector<LightStep> &second)
    {
        std::mt19937 random(8);
        LightFilm film;
        evidence[0].light = lightCourseOf(filmLight(first, film, random));
        film.startS = offsetS;
        evidence[1].light = lightCourseOf(filmLight(second, film, random));
    }
    void flash(const std::vector<LightStep> &steps) { flash(steps, steps); }

    Result<FoundOffset> find()
    {
        auto tracks = motionTracks(views, robots, names);
        for (std::size_t v = 0; v < 2; ++v)
            evidence[v].tracks = std::move(tracks[v]);
        return findClipOffset(evidence[0], evidence[1], tenSeconds);
    }
};

const RgbColour red{215, 35, 40};

} // namespace

class TestClipEvidence : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theMotionIsFinerThanTheFlash();
    void theFlashHelpsWhereTheMotionDoesNotTell();
    void theFlashPicksAmongOffsetsThatFitAlike();
    void saysWhenTheyDisagree();
    void saysWhenNothingTells();
    void likeRobotsAreNotTakenForOneAnother();
    void likeRobotsThatLeaveNothingToCompare();
    void oneRobotOfTwoLikeOnes();
    void repeatedFramesShowNoPosition();
    void worksWithoutAnyRobot();
};

void TestClipEvidence::theMotionIsFinerThanTheFlash()
{
    Filmed filmed({wandering(0, {0, 0})}, {red}, 0.321);
    filmed.flash({{4, 1.5}, {4.4, 1}});
    const auto found = filmed.find();
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY(found->from == OffsetSource::Motion);
    QVERIFY(std::abs(found->clock.offsetS - 0.321) < 0.002);
    // in it is what a rate of 0.1 % that the motion cannot tell would make at the ends
    QVERIFY2(found->clock.sigmaS < 0.004, qPrintable(QString::number(found->clock.sigmaS)));
    QVERIFY(found->remarks.empty());
}

void TestClipEvidence::theFlashHelpsWhereTheMotionDoesNotTell()
{
    Filmed filmed({straight()}, {red}, 0.321);
    filmed.flash({{4, 1.5}, {4.4, 1}});
    const auto found = filmed.find();
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY(found->from == OffsetSource::Flash);
    QVERIFY(std::abs(found->clock.offsetS - 0.321) < 3 * found->clock.sigmaS);
    QCOMPARE(found->remarks.size(), std::size_t(1));
    QVERIFY2(found->remarks[0].english().find("straight at constant speed") != std::string::npos,
             found->remarks[0].english().c_str());
}

void TestClipEvidence::theFlashPicksAmongOffsetsThatFitAlike()
{
    Filmed filmed({roundAndRound()}, {red}, 0.321, 20);
    QVERIFY(!filmed.find());
    filmed.flash({{4, 1.5}, {4.4, 1}});
    const auto found = filmed.find();
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY(found->from == OffsetSource::Motion);
    QVERIFY(std::abs(found->clock.offsetS - 0.321) < 0.002 && found->clock.sigmaS < 0.002);
}

void TestClipEvidence::saysWhenTheyDisagree()
{
    Filmed filmed({wandering(0, {0, 0})}, {red}, 0.321);
    filmed.flash({{4, 1.5}}, {{4.2, 1.5}});
    const auto found = filmed.find();
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY(found->from == OffsetSource::Motion && std::abs(found->clock.offsetS - 0.321) < 0.002);
    QCOMPARE(found->remarks.size(), std::size_t(1));
    QVERIFY2(found->remarks[0].english().find("the motion gives a time offset of 0.3") == 0,
             found->remarks[0].english().c_str());
    QVERIFY2(found->remarks[0].english().find("flash of light gives 0.1") != std::string::npos,
             found->remarks[0].english().c_str());
}

void TestClipEvidence::saysWhenNothingTells()
{
    Filmed filmed({straight()}, {red}, 0.321);
    const auto found = filmed.find();
    QVERIFY(!found);
    QCOMPARE(found.error().code, ErrorCode::Undetermined);
    QVERIFY2(found.error().why.english().find(
                 "straight at constant speed, so every time offset fits, and neither view shows") !=
                 std::string::npos,
             found.error().why.english().c_str());
    QCOMPARE(found.error().advice.english(),
             std::string("flash the room lights once while both cameras record, or give --sync SECONDS"));
}

void TestClipEvidence::likeRobotsAreNotTakenForOneAnother()
{
    // The second robot runs the first one's course 1.2 s later: taken for it, it would tell that offset, and
    // well. The second view calls it by the first one's name, and changes its mind half-way.
    const Course leader = wandering(0, {-0.3, 0}), follower = [leader](double t) { return leader(t - 1.2); };
    Filmed filmed({leader, follower}, {red, red}, 0.321);
    auto &second = filmed.views[1].robots;
    for (std::size_t i = 0; i < second[0].size() / 2; ++i)
        std::swap(second[0][i], second[1][i]);
    auto found = filmed.find();
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY2(std::abs(found->clock.offsetS - 0.321) < 0.003,
             qPrintable(QString::number(found->clock.offsetS)));

    // Never the right names at all.
    for (std::size_t i = second[0].size() / 2; i < second[0].size(); ++i)
        std::swap(second[0][i], second[1][i]);
    found = filmed.find();
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY2(std::abs(found->clock.offsetS - 0.321) < 0.003,
             qPrintable(QString::number(found->clock.offsetS)));
}

void TestClipEvidence::likeRobotsThatLeaveNothingToCompare()
{
    // Each view sees one of the two for most of the time: which, it cannot know.
    const Course leader = wandering(0, {0, 0}), follower = [leader](double t) { return leader(t - 1.2); };
    Filmed filmed({leader, follower}, {red, red}, 0.321);
    for (std::size_t i = 30; i < filmed.views[0].robots[0].size(); ++i) {
        filmed.views[0].robots[0][i].found = false;
        filmed.views[1].robots[1][i].found = false;
    }
    const auto found = filmed.find();
    QVERIFY(!found);
    QCOMPARE(found.error().code, ErrorCode::Undetermined);
}

void TestClipEvidence::oneRobotOfTwoLikeOnes()
{
    // The project knows two like robots, and one of them ran; each view gave it another name.
    Filmed filmed({wandering(0, {0, 0}), wandering(1, {0, 0})}, {red, red}, 0.321);
    for (std::size_t v = 0; v < 2; ++v) {
        auto &robots = filmed.views[v].robots;
        for (Observation &observation : robots[1])
            observation.found = false;
    }
    std::swap(filmed.views[1].robots[0], filmed.views[1].robots[1]);
    const auto found = filmed.find();
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY(std::abs(found->clock.offsetS - 0.321) < 0.002);
}

/// As where the image of a view was frozen for a time: the robot was elsewhere then.
void TestClipEvidence::repeatedFramesShowNoPosition()
{
    Filmed filmed({wandering(0.3, {0, 0})}, {RgbColour{}}, 1.3);
    std::vector<Observation> &seen = filmed.views[1].robots.front();
    for (std::size_t i = 100; i < 112; ++i) {
        seen[i].ellipse = seen[99].ellipse;
        seen[i].duplicateFrame = true;
    }
    const auto tracks = motionTracks(filmed.views, filmed.robots, filmed.names);
    for (const TimedPosition &position : tracks[1].front().positions)
        QVERIFY(position.timeS < toSeconds(seen[99].time) + 1e-6 ||
                position.timeS > toSeconds(seen[111].time) + 1e-6);
    QCOMPARE(tracks[1].front().positions.size(), seen.size() - 12);
}

void TestClipEvidence::worksWithoutAnyRobot()
{
    std::mt19937 random(9);
    std::vector<ClipEvidence> evidence(2);
    LightFilm film;
    const std::vector<LightStep> steps{{4, 1.5}, {4.4, 1}};
    for (ClipEvidence &view : evidence) {
        view.whyNoTracks = foreignWords("the project has no robot to track");
        view.light = lightCourseOf(filmLight(steps, film, random));
        film.startS += 0.5;
    }
    const auto found = findClipOffset(evidence[0], evidence[1], tenSeconds);
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QVERIFY(found->from == OffsetSource::Flash &&
            std::abs(found->clock.offsetS - 0.5) < 3 * found->clock.sigmaS);
    evidence[1].light = {};
    const auto none = findClipOffset(evidence[0], evidence[1], tenSeconds);
    QVERIFY(!none);
    QVERIFY2(none.error().why.english().find("no robot to track, and only one of the views") !=
                 std::string::npos,
             none.error().why.english().c_str());
}

ODOGRAPH_TEST(TestClipEvidence, QCoreApplication)
#include "tst_clip_evidence.moc"
