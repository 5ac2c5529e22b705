// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/trajectory/filmed_solid.h"

#include "core/trajectory/internal/body_direction.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <numbers>

using namespace odo;
using namespace odo::test;

namespace {

constexpr double pi = std::numbers::pi;

/// Longer to the front than to the rear, whose upper part sits to the rear.
SolidShape buggy()
{
    SolidShape shape;
    shape.form = SolidShape::Form::Levels;
    shape.levels = {SolidLevel{0.004, 0.05, 0.06, 0.09, 0.09}, SolidLevel{0.045, 0.10, 0.10, 0.07, 0.07},
                    SolidLevel{0.095, 0.03, 0.08, 0.05, 0.05}};
    shape.lengthM = 0.20;
    shape.widthM = 0.18;
    shape.topM = 0.095;
    return shape;
}

/// Stands for two seconds, turns on the spot by three quarters of a turn in three, stands for one, and drives
/// a curve.
Truth standsTurnsAndDrives(double t)
{
    constexpr double turnedRad = 1.5 * pi, radiusM = 0.8, speedMps = 0.4;
    const double share = std::clamp((t - 2) / 3, 0.0, 1.0), smooth = share * share * (3 - 2 * share),
                 drivenRad = std::max(0.0, t - 6) * speedMps / radiusM;
    const double heading = 0.3 + turnedRad * smooth + drivenRad, before = 0.3 + turnedRad;
    Truth truth;
    truth.position = Eigen::Vector2d(0.2, -0.1);
    if (drivenRad > 0)
        truth.position += radiusM * Eigen::Vector2d(std::sin(heading) - std::sin(before),
                                                    std::cos(before) - std::cos(heading));
    // what stands has a heading, too
    truth.velocity =
        (drivenRad > 0 ? speedMps : 1e-9) * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    return truth;
}

BodyPose truePose(double timeS)
{
    const Truth truth = standsTurnsAndDrives(timeS);
    return {fromSeconds(timeS), truth.position, headingOf(truth)};
}

struct HeadingErrors
{
    double rmsRad = 0, worstRad = 0, insideShare = 0;
};

HeadingErrors errorsOf(const ViewTrack &view, const std::vector<BodyAxis> &axes)
{
    HeadingErrors errors;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double off = std::remainder(
            axes[i].angleRad - headingOf(standsTurnsAndDrives(toSeconds(view.observations[i].time))), 2 * pi);
        errors.rmsRad += off * off / double(axes.size());
        errors.worstRad = std::max(errors.worstRad, std::abs(off));
        errors.insideShare += (std::abs(off) < 1.96 * axes[i].sigmaRad) / double(axes.size());
    }
    errors.rmsRad = std::sqrt(errors.rmsRad);
    return errors;
}

} // namespace

class TestAxisTrack : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// From a pose at its beginning, at its end, or between; also while it stands, where its motion tells
    /// nothing.
    void theHeadingFollowsTheOutlines_data()
    {
        QTest::addColumn<QList<double>>("known");
        QTest::newRow("from the first") << QList<double>{0.0};
        QTest::newRow("from the last") << QList<double>{9.5};
        QTest::newRow("from the middle of the turn") << QList<double>{3.5};
        QTest::newRow("from several") << QList<double>{1.0, 3.0, 5.5, 8.0};
    }
    void theHeadingFollowsTheOutlines()
    {
        QFETCH(QList<double>, known);
        std::mt19937 random(1);
        const std::vector<ViewTrack> views{
            filmSilhouette("A", cameraA(), buggy(), standsTurnsAndDrives, 0.2, random),
            filmSilhouette("B", cameraB(), buggy(), standsTurnsAndDrives, 0.2, random)};
        std::vector<BodyPose> poses;
        for (const double timeS : known)
            poses.push_back(truePose(timeS));
        const auto axes = trackDirection(views, buggy(), {}, poses);
        QCOMPARE(axes.size(), views.size());
        for (std::size_t v = 0; v < views.size(); ++v) {
            QCOMPARE(axes[v].size(), views[v].observations.size());
            const HeadingErrors errors = errorsOf(views[v], axes[v]);
            // 0.2 px of noise at the corners of an outline of 60 px are half a degree a picture, smoothed
            // over several of them: 0.002 and 0.009 rad when this was written. A degree and two are allowed;
            // a flip would be 180.
            QVERIFY2(errors.rmsRad < 0.0175 / 2 && errors.worstRad < 0.035,
                     qPrintable(QStringLiteral("%1 %2").arg(errors.rmsRad).arg(errors.worstRad)));
            QVERIFY2(errors.insideShare > 0.8, qPrintable(QString::number(errors.insideShare)));
        }
    }

    void whereNothingIsSeenTheHeadingIsUnknown()
    {
        std::mt19937 random(2);
        std::vector<ViewTrack> views{
            filmSilhouette("A", cameraA(), buggy(), standsTurnsAndDrives, 0.2, random)};
        for (Observation &observation : views.front().observations)
            observation.found = false;
        const auto axes = trackDirection(views, buggy(), {}, {truePose(1)});
        for (const BodyAxis &axis : axes.front())
            QVERIFY(axis.sigmaRad > unknownAxisSigmaRad);
    }
};

ODOGRAPH_TEST(TestAxisTrack, QCoreApplication)
#include "tst_axis_track.moc"
