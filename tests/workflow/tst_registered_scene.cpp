// SPDX-License-Identifier: GPL-3.0-or-later
// Clips of a camera that was pushed, or whose picture was mirrored, after its registration.
#include "core/workflow/track/registered_scene.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/video/image.h"
#include "core/video/image_reader.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/track/track_job.h"
#include "tests/support/registered_test.h"
#include "tests/support/simulated_set_up.h"
#include "tests/workflow/measured_scene.h"

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <functional>
#include <memory>

using namespace odo;
using namespace odo::test;

class TestRegisteredScene : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    RegisteredView m_view;
    std::unique_ptr<Project> m_project;

    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    /// The view, registered by an image of what it shows with each column and row taken from elsewhere.
    RegisteredView registeredBy(const std::string &name, const std::function<int(int, int)> &columnOf,
                                int rowsUp = 0)
    {
        const Frame frame = (*VideoReader::open(m_view.file))->frameAt(0).value();
        const int width = frame.y.width, height = frame.y.height;
        std::vector<std::uint32_t> pixels(std::size_t(width) * std::size_t(height));
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const std::uint32_t grey = frame.y.at(std::clamp(columnOf(x, width), 0, width - 1),
                                                      std::clamp(y + rowsUp, 0, height - 1));
                pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
                    0xff000000U | grey << 16 | grey << 8 | grey;
            }
        }
        RegisteredView view = m_view;
        view.registrationImage = path(name + ".png");
        if (!writeImage(fromScreen(pixels.data(), width, height, width * std::ptrdiff_t(4), {}),
                        view.registrationImage))
            qFatal("not written");
        view.registration = RegistrationRecord{};
        view.registration->id = 7;
        return view;
    }
    static std::vector<std::string> warned(const RegisteredView &view)
    {
        std::vector<std::string> sentences;
        for (const Message &one : sceneWarnings("run", {view}, changesSinceRegistration({view}, {})))
            sentences.push_back(one.english());
        return sentences;
    }

    /// The camera registered where it is in the project, by this image.
    void registerBy(const RegisteredView &view)
    {
        const RecordId camera = m_project->cameras().find("A")->id;
        RegistrationRecord record = m_project->cameras().currentRegistration(camera).value().value();
        record.image.path = view.registrationImage.string();
        if (!m_project->cameras().addRegistration(record))
            qFatal("not registered");
    }
    Result<TrackOutcome> tracked(bool again)
    {
        TrackSettings settings;
        settings.again = again;
        TrackJob job("run", settings);
        if (const auto done = runToEnd(job, *m_project, {}); !done)
            return tl::unexpected(done.error());
        return job.outcome();
    }
    double sigmaM()
    {
        const RecordId trial = m_project->trials().find("run")->id;
        const std::vector<AnalysisRecord> analyses = m_project->analyses().current(trial).value();
        return analyses.front().profile.points[5].sigmaXM;
    }
    static bool says(const std::vector<Message> &messages, const char *words)
    {
        return std::ranges::any_of(messages, [&](const Message &message) {
            return message.english().find(words) != std::string::npos;
        });
    }

private Q_SLOTS:
    void initTestCase()
    {
        SimulatedScene scene = demoTestbed(51);
        scene.durationS = 2;
        scene.robots = {
            demoRobot("robot", {.colour = demoBlue}, makeCircleMotion({1.5, 1.1}, 0.7, 0.7, 0.6))};
        const auto views = renderedViews(scene, m_folder.path().toStdString());
        QVERIFY2(views.has_value(), views ? "" : views.error().message().c_str());
        m_view = views->front();
        m_view.recording.cameraName = "A";
        m_project = Project::create(path("class.odo"), "Class").value();
        const RecordId layout = m_project->layouts().add(scene.floor.markers)->id;
        QVERIFY(registerSimulatedCamera(*m_project, scene.cameras[0], scene.floor.markers, layout));
        QVERIFY(addSimulatedRobot(*m_project, scene.robots[0]));
        ImportSettings settings;
        settings.trial = "run";
        settings.videos = {{"A", m_view.file}};
        ImportTrialJob import(settings);
        const auto imported = runToEnd(import, *m_project, {});
        QVERIFY2(imported, imported ? "" : imported.error().message().c_str());
        QVERIFY(import.warnings().empty());
    }
    void cleanupTestCase() { m_project.reset(); }

    void theSceneAsItWasIsNotMentioned()
    {
        const RegisteredView view = registeredBy("same", [](int x, int) { return x; });
        QVERIFY(warned(view).empty());
        QVERIFY(checkSameScene("run", {view}, changesSinceRegistration({view}, {})));
        RegisteredView without = view;
        without.registrationImage.clear();
        QVERIFY(!changesSinceRegistration({without}, {}).front());
        without.registrationImage = path("gone.png");
        QVERIFY(!changesSinceRegistration({without}, {}).front());
    }

    void aPushedCameraIsToldAndMeasuredOn()
    {
        const RegisteredView view = registeredBy(
            "pushed", [](int x, int) { return x + 4; }, 3);
        QCOMPARE(warned(view),
                 std::vector<std::string>{
                     "view 'A' in trial 'run': its scene is shifted by 5.0 px against the image by which its "
                     "camera was registered, so the camera was moved, and the stated errors were increased "
                     "by that; register the camera again in a frame of this video and reanalyse"});
        QVERIFY(checkSameScene("run", {view}, changesSinceRegistration({view}, {})));
    }

    void anotherSceneIsRefused()
    {
        const RegisteredView view = registeredBy("mirrored", [](int x, int width) { return width - 1 - x; });
        const auto checked = checkSameScene("run", {view}, changesSinceRegistration({view}, {}));
        QVERIFY(!checked);
        QCOMPARE(
            checked.error().message(),
            std::string("view 'A' in trial 'run': it is mirrored against the image by which its camera "
                        "was registered; use the file as the camera wrote it, or register the camera again "
                        "in a frame of this video"));
        QCOMPARE(warned(view), std::vector<std::string>{checked.error().message()});
        const RegisteredView panned = registeredBy("panned", [](int x, int) { return x + 200; });
        const auto far = checkSameScene("run", {panned}, changesSinceRegistration({panned}, {}));
        QVERIFY(!far);
        QCOMPARE(far.error().why.english(), std::string("its scene is shifted by 200 px against the image by "
                                                        "which its camera was registered"));
    }

    void whatIsNotedHoldsForItsRegistration()
    {
        const RegisteredView view = registeredBy("noted", [](int x, int) { return x; });
        std::vector<ObservationSeries> series(2);
        series.front().algorithm = "silhouette 1; leap 1 before 3 (0.100 m)";
        noteShift(view, 3.25, series);
        for (const ObservationSeries &one : series) {
            QCOMPARE(notedShift(one, 7), std::optional(3.25));
            QCOMPARE(notedShift(one, 8), std::nullopt);
        }
        QCOMPARE(notedShift({}, 7), std::nullopt);
    }

    /// The errors grow, the verdict says why, and both hold for what is analysed again, until the camera is
    /// registered as it was in this clip.
    void aTrialIsDoubtedFromThere()
    {
        registerBy(registeredBy("as it was", [](int x, int) { return x; }));
        const auto before = tracked(false);
        QVERIFY2(before, before ? "" : before.error().message().c_str());
        const double sigma = sigmaM();
        QVERIFY(!says(before->warnings, "its scene is shifted"));

        registerBy(registeredBy(
            "pushed before", [](int x, int) { return x + 4; }, 3));
        for (const bool again : {false, true}) {
            const auto after = tracked(again);
            QVERIFY2(after, after ? "" : after.error().message().c_str());
            QVERIFY(says(after->warnings, "its scene is shifted by 5.0 px"));
            QCOMPARE(int(after->verdict.level()), int(CheckLevel::Doubtful));
            QVERIFY2(sigmaM() > 3 * sigma, qPrintable(QString::number(sigmaM() / sigma)));
        }

        registerBy(registeredBy("as it is", [](int x, int) { return x; }));
        const auto registered = tracked(true);
        QVERIFY(registered && !says(registered->warnings, "its scene is shifted"));
        QVERIFY(std::abs(sigmaM() / sigma - 1) < 0.01);
    }

    void aMirroredClipIsNotMeasured()
    {
        registerBy(registeredBy("mirror", [](int x, int width) { return width - 1 - x; }));
        const auto refused = tracked(false);
        QVERIFY(!refused);
        QCOMPARE(refused.error().why.english(),
                 std::string("it is mirrored against the image by which its camera was registered"));
    }

    /// By so much as a turn that shifts the image so.
    void theErrorsHoldTheShift()
    {
        constexpr double shiftPx = 5;
        const FloorView &exact = *m_view.floorView, wide = widenedByShift(exact, shiftPx);
        const Eigen::Vector2d pixel(exact.camera().intrinsics().cxPx, exact.camera().intrinsics().cyPx);
        const auto at = wide.locate(pixel, Eigen::Matrix2d::Zero(), 0),
                   before = exact.locate(pixel, Eigen::Matrix2d::Zero(), 0),
                   besides = exact.locate(pixel + Eigen::Vector2d(0, shiftPx), Eigen::Matrix2d::Zero(), 0);
        const Eigen::Vector2d off = besides->pointInWorld - before->pointInWorld;
        const Eigen::Matrix2d added = at->calibrationCovariance - before->calibrationCovariance;
        const double sigmas = std::sqrt(off.dot(added.inverse() * off));
        QVERIFY2(std::abs(sigmas - 1) < 0.05, qPrintable(QString::number(sigmas)));
    }
};

ODOGRAPH_TEST(TestRegisteredScene, QCoreApplication)
#include "tst_registered_scene.moc"
