// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/occlusions.h"
#include "tests/support/registered_test.h"
#include "tests/trajectory/synthetic_run.h"

#include <QTest>
#include <numbers>

using namespace odo;
using namespace odo::test;

/// What is said of stretches in which a view does not measure the whole of a robot.
class TestOcclusions : public QObject
{
    Q_OBJECT

    static constexpr double durationS = 4, radiusM = 0.12;
    static inline const FloorView viewA = cameraA();

    /// A robot that rests, measured by two views; view 0 sees a disc of radiusM in each frame of its own.
    struct Filmed
    {
        std::string name;
        Profile profile;
        std::vector<Observation> seen;

        Filmed(std::string itsName, const Eigen::Vector2d &position) : name(std::move(itsName))
        {
            Run run = exactly([position](double) { return Truth{position, {}, {}}; }, durationS);
            const double distanceM =
                (Eigen::Vector3d(position.x(), position.y(), 0) - viewA.cameraInWorld()).norm();
            const double radiusPx = radiusM * viewA.camera().intrinsics().fxPx / distanceM;
            for (Sample &sample : run.samples) {
                sample.views = 3;
                Observation &observation = seen.emplace_back();
                observation.frame = sample.frame;
                observation.time = sample.time;
                observation.found = true;
                observation.areaPx = std::numbers::pi * radiusPx * radiusPx;
            }
            profile.samples = std::move(run.samples);
            profile.points = std::move(run.points);
        }

        /// View 0 does not measure it; what it sees there is changed.
        template <class Change>
        Filmed &without(double fromS, double toS, Change change)
        {
            for (std::size_t i = 0; i < seen.size(); ++i) {
                if (toSeconds(seen[i].time) < fromS - 1e-6 || toSeconds(seen[i].time) > toS + 1e-6)
                    continue;
                profile.samples[i].views = 2;
                change(seen[i]);
            }
            return *this;
        }
        Filmed &lost(double fromS, double toS)
        {
            return without(fromS, toS, [](Observation &one) { one.found = false; });
        }
        Filmed &scaled(double fromS, double toS, double factor)
        {
            return without(fromS, toS, [factor](Observation &one) { one.areaPx *= factor; });
        }
    };

    /// The sentences of each robot, with "; " between them.
    static std::vector<std::string> said(const std::vector<Filmed> &robots, const FloorView *view = &viewA)
    {
        const std::vector<OcclusionView> views{{"A", view, {}}, {"B", nullptr, {}}};
        std::vector<OcclusionRobot> all;
        for (const Filmed &robot : robots)
            all.push_back({robot.name, &robot.profile, {robot.seen, {}}});
        std::vector<std::string> sentences;
        for (const auto &its : findOcclusions(views, all)) {
            std::string &words = sentences.emplace_back();
            for (const Occlusion &one : its)
                words += (words.empty() ? "" : "; ") + occlusionSentence(one).english();
        }
        return sentences;
    }

    // Camera A looks from (-2.2, -2.6) over the origin: along that line the second place is nearer to it.
    static inline const Eigen::Vector2d far{0, 0}, near{-0.11, -0.13}, aside{0.8, -0.6};

private Q_SLOTS:
    void nothingIsSaidOfWhatIsMeasured()
    {
        QCOMPARE(said({{"Red 2", far}, {"Blue 1", near}}), (std::vector<std::string>{"", ""}));
        // of a view that is not registered
        QCOMPARE(said({Filmed("Red 2", far).lost(1, 2)}, nullptr), std::vector<std::string>{""});
        QCOMPARE(said({}), std::vector<std::string>());
        const OcclusionRobot notTracked{"Red 2", nullptr, {}};
        const OcclusionView view{"A", &viewA, {}};
        QCOMPARE(findOcclusions({&view, 1}, {&notTracked, 1}).front().size(), std::size_t(0));
    }

    void theOneBehindIsHiddenAndTheOneBeforeIsOneWithIt()
    {
        QCOMPARE(said({Filmed("Red 2", far).lost(1, 1.5), Filmed("Blue 1", near)}),
                 (std::vector<std::string>{"hidden behind Blue 1 in view A (1.00 s to 1.50 s)", ""}));
        QCOMPARE(said({Filmed("Red 2", far).scaled(1, 1.5, 0.6), Filmed("Blue 1", near)}).front(),
                 std::string("partly hidden behind Blue 1 in view A (1.00 s to 1.50 s)"));
        QCOMPARE(said({Filmed("Red 2", far), Filmed("Blue 1", near).lost(1, 1.5)}),
                 (std::vector<std::string>{"", "outline merged with Red 2 in view A (1.00 s to 1.50 s)"}));
    }

    void ofSeveralTheNearestIsNamed()
    {
        QCOMPARE(
            said({Filmed("Red 2", far).lost(1, 1.5), Filmed("Green 3", 2 * near), Filmed("Blue 1", near)})
                .front(),
            std::string("hidden behind Blue 1 in view A (1.00 s to 1.50 s)"));
        QCOMPARE(said({Filmed("Red 2", far).lost(1, 1.5), Filmed("Green 3", aside)}).front(),
                 std::string("not visible in view A (1.00 s to 1.50 s)"));
    }

    void withoutAnotherRobotTheOutlineTells()
    {
        QCOMPARE(said({Filmed("Red 2", far).scaled(1, 2, 0.6)}).front(),
                 std::string("outline smaller than usual in view A (1.00 s to 2.00 s)"));
        QCOMPARE(said({Filmed("Red 2", far).scaled(1, 2, 1.7)}).front(),
                 std::string("outline larger than usual in view A (1.00 s to 2.00 s)"));
        QCOMPARE(said({Filmed("Red 2", far).scaled(1, 1.5, 0.6).lost(1.5, 2)}).front(),
                 std::string("not visible in view A (1.00 s to 2.00 s)"));
        QCOMPARE(
            said({Filmed("Red 2", far).without(1, 2, [](Observation &one) { one.touchesBorder = true; })})
                .front(),
            std::string("cut by the frame's edge in view A (1.00 s to 2.00 s)"));
    }

    void whatLeadsToItBelongsToIt()
    {
        Filmed red("Red 2", far);
        red.scaled(1, 1.3, 0.8).lost(1.4, 1.8).scaled(1.9, 2.1, 0.8);
        Filmed blue("Blue 1", near);
        // where it is is known for a part of the time alone
        for (std::size_t i = 0; i < blue.profile.points.size(); ++i)
            blue.profile.points[i].valid = toSeconds(blue.profile.samples[i].time) > 1.35 &&
                                           toSeconds(blue.profile.samples[i].time) < 1.85;
        QCOMPARE(said({red, blue}).front(), std::string("hidden behind Blue 1 in view A (1.00 s to 2.10 s)"));
        QCOMPARE(said({Filmed("Red 2", far).lost(1, 1.5).lost(2, 2.5)}).front(),
                 std::string(
                     "not visible in view A (1.00 s to 1.50 s); not visible in view A (2.00 s to 2.50 s)"));
    }

    void momentsAndWhatNoViewCanSeeAreLeftOut()
    {
        QCOMPARE(said({Filmed("Red 2", far).lost(1, 1.07)}).front(), std::string());  // three frames
        QCOMPARE(said({Filmed("Red 2", {30, 0}).lost(1, 2)}).front(), std::string()); // beyond the frame
        Filmed shortView("Red 2", far);
        shortView.lost(3, 4);
        shortView.seen.resize(80); // that ended at 2.6 s
        QCOMPARE(said({shortView}).front(), std::string());
        Filmed nowhere("Red 2", far);
        nowhere.lost(1, 2);
        for (ProfilePoint &point : nowhere.profile.points)
            point.valid = false;
        QCOMPARE(said({nowhere}).front(), std::string());
        Filmed elsewhere("Red 2", far); // which the views' disagreement says
        elsewhere.without(1, 2, [](Observation &) {});
        for (Sample &sample : elsewhere.profile.samples)
            sample.flags = flagBit(SampleFlag::ViewsDisagree);
        QCOMPARE(said({elsewhere}).front(), std::string());
    }

    void anUnsureSampleCountsAsNotMeasured()
    {
        Filmed red = Filmed("Red 2", far).scaled(1, 2, 0.5);
        for (Sample &sample : red.profile.samples) {
            if (sample.views == 2)
                sample.flags = flagBit(SampleFlag::LowScore);
            sample.views = 3;
        }
        QCOMPARE(said({red}).front(), std::string("outline smaller than usual in view A (1.00 s to 2.00 s)"));
    }

    void aSpikesReasonSaysWhatHidTheRobot()
    {
        const std::vector<Occlusion> occlusions{
            {{fromSeconds(1), fromSeconds(2)}, OcclusionCause::HiddenBehind, "A", "Blue 1"}};
        QCOMPARE(reasonAmong(occlusions, {0, fromSeconds(1.5), 0, foreignWords("jump of 84 mm")}).english(),
                 std::string("jump of 84 mm; hidden behind Blue 1 in view A"));
        QCOMPARE(reasonAmong(occlusions, {0, fromSeconds(2.5), 0, foreignWords("jump of 84 mm")}).english(),
                 std::string("jump of 84 mm"));
        QCOMPARE(std::string(occlusionCauseName(OcclusionCause::OutlineTooLarge)),
                 std::string("outline_too_large"));
    }
};

ODOGRAPH_TEST(TestOcclusions, QCoreApplication)
#include "tst_occlusions.moc"
