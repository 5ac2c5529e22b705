// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/body_heading.h"

#include "core/analysis/metrics.h"
#include "core/analysis/quantity_curve.h"
#include "core/trajectory/solid_choice.h"
#include "tests/support/registered_test.h"
#include "tests/trajectory/driven_course.h"
#include "tests/trajectory/filmed_solid.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr double pi = std::numbers::pi;

SolidShape boxOf(double lengthM, double widthM)
{
    SolidShape shape;
    shape.lengthM = lengthM;
    shape.widthM = widthM;
    shape.topM = 0.08;
    return shape;
}

/// As of the support of silhouettes, which a box of several levels explains.
SolidShape buggy()
{
    SolidShape shape;
    shape.form = SolidShape::Form::Levels;
    shape.levels = {SolidLevel{0.004, 0.08, 0.08, 0.07, 0.07}, SolidLevel{0.045, 0.11, 0.10, 0.06, 0.06},
                    SolidLevel{0.095, 0.03, 0.08, 0.05, 0.05}};
    shape.lengthM = 0.21;
    shape.widthM = 0.14;
    shape.topM = 0.095;
    return shape;
}

SolidShape cylinder()
{
    SolidShape shape = boxOf(0.18, 0.18);
    shape.form = SolidShape::Form::Cylinder;
    return shape;
}

/// As shadows at its foot make of a cylinder's silhouettes.
SolidShape nearlyRound()
{
    SolidShape shape = boxOf(0.18, 0.178);
    shape.form = SolidShape::Form::Levels;
    shape.levels = {SolidLevel{0.004, 0.085, 0.083, 0.09, 0.088}, SolidLevel{0.03, 0.09, 0.09, 0.089, 0.089},
                    SolidLevel{0.08, 0.088, 0.09, 0.088, 0.089}};
    shape.roundShare = 1;
    return shape;
}

enum class Look { Outline, Silhouette };

Profile filmed(const DrivenCourse &course, const SolidShape &shape, Look look, const RobotShape &given = {})
{
    std::mt19937 random(11);
    const auto film = look == Look::Outline ? filmSolid : filmSilhouette;
    std::vector<ViewTrack> views{film("A", cameraA(), shape, course.course(), 0.2, random),
                                 film("B", cameraB(), shape, course.course(), 0.2, random)};
    auto profile = analyse(views, given, {});
    if (!profile)
        qWarning("%s", profile.error().message().c_str());
    return profile ? *profile : Profile();
}

/// Shares of the points.
struct Coverage
{
    double ofBody = 0, headingHolds = 0, turnRateHolds = 0, worstRad = 0;
};

Coverage coverageOf(const Profile &profile, const DrivenCourse &course)
{
    Coverage coverage;
    const auto headings = headingsOf(profile);
    double known = 0;
    for (std::size_t i = 0; i < headings.size(); ++i) {
        const DrivenState truth = course.at(toSeconds(profile.samples[i].time));
        if (!headings[i] || !headings[i]->isOfBody)
            continue;
        const double away = std::abs(std::remainder(headings[i]->radians - *truth.truth.headingRad, 2 * pi));
        const auto rate = turnRateOf(profile.points[i]);
        known += 1;
        coverage.worstRad = std::max(coverage.worstRad, away);
        coverage.headingHolds += away <= 2 * *headings[i]->sigmaRad;
        coverage.turnRateHolds += std::abs(rate->value - truth.turnRateRadps) <= 2 * rate->sigma;
    }
    coverage.ofBody = known / static_cast<double>(headings.size());
    coverage.headingHolds /= known;
    coverage.turnRateHolds /= known;
    return coverage;
}

const Metric *metricOf(const Profile &profile, std::string_view name)
{
    const auto found = std::ranges::find(profile.metrics, name, &Metric::name);
    return found == profile.metrics.end() ? nullptr : &*found;
}

} // namespace

class TestBodyHeading : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// Its outlines are alike from all sides.
    void aRoundRobotHasADirectionOfMotion_data()
    {
        QTest::addColumn<Look>("look");
        QTest::addColumn<SolidShape>("shape");
        QTest::newRow("outlines") << Look::Outline << cylinder();
        QTest::newRow("silhouettes") << Look::Silhouette << cylinder();
        QTest::newRow("silhouettes with shadows") << Look::Silhouette << nearlyRound();
    }
    void aRoundRobotHasADirectionOfMotion()
    {
        QFETCH(Look, look);
        QFETCH(SolidShape, shape);
        const DrivenCourse course = spinsAndReverses();
        const Profile profile = filmed(course, shape, look);
        const auto headings = headingsOf(profile);
        QVERIFY(!headings.empty());
        for (const auto &heading : headings)
            QVERIFY(heading && !heading->isOfBody);
        QVERIFY(headings[30]->sigmaRad && std::abs(headings[30]->radians - 0.4) < 0.05);
        if (shape.form == SolidShape::Form::Cylinder) // what is uneven seems to move a little
            QVERIFY(!headings[90]->sigmaRad);         // it spins, which cannot be seen
    }

    /// One that is wider than long moves along its shorter side, unless its size says otherwise.
    void aWideBodyIsDirectedByItsMotion()
    {
        const DrivenCourse course = spinsAndReverses();
        const Coverage coverage = coverageOf(filmed(course, boxOf(0.14, 0.22), Look::Outline), course);
        QVERIFY(coverage.ofBody > 0.98 && coverage.headingHolds > 0.9 && coverage.worstRad < 0.2);
        RobotShape given;
        given.heightM = 0.08;
        given.lengthM = 0.22;
        given.widthM = 0.14;
        const Profile sideways = filmed(course, boxOf(0.14, 0.22), Look::Outline, given);
        const auto headings = headingsOf(sideways);
        QVERIFY(headings[30] && headings[30]->isOfBody);
        QVERIFY(std::abs(std::abs(std::remainder(headings[30]->radians - 0.4, 2 * pi)) - pi / 2) < 0.1);
    }

    /// One that only spins shows how it turns, but not where its front is.
    void aSpinAloneHasNoFront()
    {
        const DrivenCourse course({{3, 0, 2}, {3, 0, -1.5}, {4, 0, 0}}, {0.2, 0.1}, 0.4);
        const Profile profile = filmed(course, boxOf(0.24, 0.15), Look::Outline);
        for (const auto &heading : headingsOf(profile))
            QVERIFY(!heading || !heading->isOfBody);
        const Metric *turn = metricOf(profile, "max_turn_rate");
        QVERIFY(turn && std::abs(turn->value - 2) < 2 * *turn->sigma && *turn->sigma < 0.3);
    }

    /// No frame of the first view could be read, as of a video that is damaged throughout.
    void aFirstViewWithoutFramesHasNoHeadings()
    {
        std::mt19937 random(11);
        const DrivenCourse course = spinsAndReverses();
        std::vector<ViewTrack> views{
            filmSolid("A", cameraA(), boxOf(0.24, 0.15), course.course(), 0.2, random),
            filmSolid("B", cameraB(), boxOf(0.24, 0.15), course.course(), 0.2, random)};
        views.front().observations.clear();
        QVERIFY(explainedShare(views, {}) > 0.9); // of what the second view saw
        const auto profile = analyse(views, {}, {});
        QVERIFY(!profile);
        QCOMPARE(profile.error().why.english(), std::string("view A has no frame"));
    }

    void spinsAndReversesAreFollowed_data()
    {
        QTest::addColumn<SolidShape>("shape");
        QTest::addColumn<Look>("look");
        QTest::newRow("a box's outlines") << boxOf(0.24, 0.15) << Look::Outline;
        QTest::newRow("a box's silhouettes") << boxOf(0.24, 0.15) << Look::Silhouette;
        QTest::newRow("a buggy's silhouettes") << buggy() << Look::Silhouette;
    }
    void spinsAndReversesAreFollowed()
    {
        QFETCH(SolidShape, shape);
        QFETCH(Look, look);
        const DrivenCourse course = spinsAndReverses();
        const Profile profile = filmed(course, shape, look);
        const Coverage coverage = coverageOf(profile, course);
        const Metric *turn = metricOf(profile, "max_turn_rate");
        QVERIFY(turn);
        qInfo("of body %.2f, heading %.2f, turn rate %.2f, worst %.3f; fastest %.3f ± %.3f", coverage.ofBody,
              coverage.headingHolds, coverage.turnRateHolds, coverage.worstRad, turn->value, *turn->sigma);
        QVERIFY(coverage.ofBody > 0.98);
        QVERIFY(coverage.headingHolds > 0.9);
        QVERIFY(coverage.turnRateHolds > 0.9);
        QVERIFY(coverage.worstRad < 0.2);
        QVERIFY(std::abs(turn->value - 4) < 2 * *turn->sigma);
        QVERIFY(*turn->sigma < 1);
    }
};

ODOGRAPH_TEST(TestBodyHeading, QCoreApplication)
#include "tst_body_heading.moc"
