// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/analyser.h"

#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

const RobotShape given{0.06, 0.26, 0.19};

/// A run with one false sighting, of frame 100.
ViewTrack spikedView()
{
    std::mt19937 random(5);
    ViewTrack view = film("A", cameraA(), figureEight(1.1, 0.7, 7), {}, random);
    view.observations[100].ellipse.centrePx.x() += 60;
    view.observations[200].found = false;
    return view;
}

Profile analysed(const std::vector<ManualOverride> &overrides)
{
    AnalysisOptions options;
    options.overrides = overrides;
    return analyse({spikedView()}, given, options).value();
}

} // namespace

class TestOverrides : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void listsKeepOneWordAFrame()
    {
        const std::vector<ManualOverride> two = withOverride(withOverride({}, {7, true}), {3, false});
        QVERIFY((two == std::vector<ManualOverride>{{3, false}, {7, true}}));
        QVERIFY((withOverride(two, {7, false}) == std::vector<ManualOverride>{{3, false}, {7, false}}));
        QVERIFY((withoutOverride(two, 3) == std::vector<ManualOverride>{{7, true}}));
        QVERIFY(withoutOverride(two, 5) == two);
    }

    void aSpikeIsLiftedAndSetBack()
    {
        const Profile program = analysed({}), lifted = analysed({{100, false}}), back = analysed({});
        QVERIFY(isRejected(program.samples[100].flags));
        QCOMPARE(program.spikes.size(), std::size_t(1));
        QCOMPARE(lifted.samples[100].flags, flagBit(SampleFlag::ByHand));
        QCOMPARE(lifted.spikes.size(), std::size_t(0));
        // The curve follows: it is drawn towards the measurement.
        const auto distance = [](const Profile &profile) {
            return (profile.points[100].position - *profile.samples[100].position).norm();
        };
        QVERIFY(distance(lifted) < distance(program) - 0.002);
        QCOMPARE(*lifted.samples[100].position, *program.samples[100].position); // raw as it was
        QCOMPARE(back.samples[100].flags, program.samples[100].flags);
        QCOMPARE(back.points[100].position, program.points[100].position);
    }

    void aGoodSampleIsCalledASpike()
    {
        const Profile profile = analysed({{50, true}});
        const Sample &sample = profile.samples[50];
        QVERIFY(isRejected(sample.flags));
        QVERIFY(hasFlag(sample.flags, SampleFlag::ByHand));
        QVERIFY(hasFlag(sample.flags, SampleFlag::Interpolated));
        QVERIFY(profile.points[50].sigmaXM > analysed({}).points[50].sigmaXM);
        QCOMPARE(profile.spikes.front().reason.english(), std::string("marked as a spike by hand"));
        QCOMPARE(*sample.position, *analysed({}).samples[50].position);
    }

    void whereNothingWasMeasuredNothingChanges()
    {
        const Profile plain = analysed({}), judged = analysed({{200, false}, {9999, true}});
        QCOMPARE(judged.samples[200].flags, plain.samples[200].flags);
        QCOMPARE(judged.points[200].position, plain.points[200].position);
    }
};

ODOGRAPH_TEST(TestOverrides, QCoreApplication)
#include "tst_overrides.moc"
