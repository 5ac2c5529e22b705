// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/frame_damage.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace std::chrono_literals;

namespace {

/// Of the frames with these numbers, ten a second.
std::vector<Observation> observationsOf(const std::vector<std::int64_t> &frames)
{
    std::vector<Observation> observations;
    for (const std::int64_t frame : frames) {
        Observation &one = observations.emplace_back();
        one.frame = frame;
        one.time = frame * 100ms;
        one.found = true;
    }
    return observations;
}

std::vector<Nanoseconds> times(int count)
{
    std::vector<Nanoseconds> times;
    for (int i = 0; i < count; ++i)
        times.push_back(i * 100ms);
    return times;
}

} // namespace

class TestFrameDamage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void countsWhatIsMissing()
    {
        const FrameDamage damage = damageOf(observationsOf({0, 1, 4, 5}), times(8));
        QCOMPARE(damage.frames, 4);
        QVERIFY(damage.span.begin == 200ms && damage.span.end == 700ms);
        QCOMPARE(damageOf(observationsOf({0, 1, 2}), times(3)).frames, 0);
    }

    void ofWhatWasNeverTrackedNothingIsKnown()
    {
        QCOMPARE(damageOf({}, times(8)).frames, 0);
        std::vector<Observation> none;
        insertDamaged(none, times(8));
        QVERIFY(none.empty());
    }

    void damagedFramesCountAsSuchInWhichNothingWasFound()
    {
        std::vector<Observation> observations = observationsOf({1, 3});
        insertDamaged(observations, times(5));
        QCOMPARE(observations.size(), std::size_t(5));
        for (std::size_t i = 0; i < observations.size(); ++i) {
            QCOMPARE(observations[i].frame, std::int64_t(i));
            QVERIFY(observations[i].time == times(5)[i]);
            QCOMPARE(observations[i].found, i == 1 || i == 3);
        }
        removeDamaged(observations);
        QCOMPARE(observations.size(), std::size_t(2));
        QCOMPARE(observations.back().frame, std::int64_t(3));
    }
};

ODOGRAPH_TEST(TestFrameDamage, QCoreApplication)
#include "tst_frame_damage.moc"
