// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/occlusions.h"
#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_trial.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

/// A robot that leaves all views: the metrics cover only the measured part, and a sentence says so.
class TestGaps : public QObject
{
    Q_OBJECT

    /// Along +x at 0.2 m/s, unseen by both views while the predicate says so.
    template <class Unseen>
    static Result<Profile> run(Unseen unseen)
    {
        std::mt19937 random(4);
        const Course course = [](double t) { return Truth{{-1 + 0.2 * t, 0.4}, {0.2, 0}, {0, 0}}; };
        auto a = film("A", cameraA(), course, {}, random), b = film("B", cameraB(), course, {}, random);
        for (ViewTrack *view : {&a, &b}) {
            for (Observation &observation : view->observations)
                observation.found = !unseen(toSeconds(observation.time));
        }
        return analyse({a, b}, RobotShape{0.06, 0.26, 0.19}, {});
    }
    static std::vector<std::string> sentences(const Result<Profile> &profile)
    {
        std::vector<std::string> sentences;
        for (const Message &each : describeGaps(*profile, AnalysisOptions().longestBridgedGap))
            sentences.push_back(each.english());
        return sentences;
    }

private Q_SLOTS:
    void leavesForGood()
    {
        const auto profile = run([](double t) { return t > 6.31; });
        QVERIFY(profile.has_value());
        QCOMPARE(sentences(profile).size(), std::size_t(1));
        QCOMPARE(
            sentences(profile).front(),
            std::string("no view sees it after 6.3 s (it was at X 0.26 m, Y 0.40 m); move or add a camera "
                        "to cover the whole task; the metrics cover only the measured part"));
        // What was seen is measured all the same.
        const auto pathLength =
            std::find_if(profile->metrics.begin(), profile->metrics.end(),
                         [](const Metric &metric) { return metric.name == "path_length"; });
        QVERIFY(std::abs(pathLength->value - 0.2 * 6.3) < 0.02);
        QVERIFY(pathLength->isAtLeast); // it was driving
    }

    void leavesAndComesBack()
    {
        const auto profile = run([](double t) { return t > 3.01 && t < 5.99; });
        QVERIFY(profile.has_value());
        QCOMPARE(sentences(profile).size(), std::size_t(1));
        QVERIFY(sentences(profile).front().starts_with(
            "no view sees it from 3.0 s to 6.0 s (it was at X -0.40 m, Y 0.40 m); move or add a camera"));
    }

    void framesThatAreMissing()
    {
        auto profile = run([](double) { return false; });
        std::erase_if(profile->samples, [](const Sample &sample) {
            return sample.time > std::chrono::seconds(2) && sample.time < std::chrono::seconds(5);
        });
        QCOMPARE(sentences(profile),
                 std::vector<std::string>{
                     "nothing was measured from 2.0 s to 5.0 s; the metrics cover only the measured part"});
    }

    void nothingIsSaidOfWhatIsBridged()
    {
        QCOMPARE(sentences(run([](double) { return false; })).size(), std::size_t(0));
        QCOMPARE(sentences(run([](double t) { return t > 3 && t < 4.3; })).size(), std::size_t(0));
        QCOMPARE(sentences(run([](double t) { return t > 9.7; })).size(), std::size_t(0));
        QCOMPARE(sentences(run([](double t) { return t < 4; })).size(),
                 std::size_t(0)); // it was brought in late
        QVERIFY(describeGaps({}, AnalysisOptions().longestBridgedGap).empty());
    }
};

ODOGRAPH_TEST(TestGaps, QCoreApplication)
#include "tst_gaps.moc"
