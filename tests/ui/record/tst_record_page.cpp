// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/steady_now.h"
#include "core/project/project.h"
#include "core/project/project_locks.h"
#include "core/project/repositories.h"
#include "core/workflow/record/live_trial.h"
#include "tests/support/datagram_receiver.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "tests/ui/support/busy_watch.h"
#include "tests/ui/support/circle_lesson.h"
#include "tests/ui/support/person.h"
#include "ui/record/internal/health_watch.h"
#include "ui/record/internal/live_board.h"
#include "ui/record/internal/live_image_area.h"
#include "ui/record/internal/run_card.h"
#include "ui/record/internal/run_results.h"
#include "ui/record/record_page.h"
#include "ui/views/present/present_source.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <future>

using namespace odo;

namespace {

/// Whatever else this machine has.
CameraAccess simulatedCameras()
{
    CameraAccess access;
    access.list = [] {
        std::vector<CameraDescription> cameras = listCameras();
        std::erase_if(cameras, [](const CameraDescription &camera) { return camera.kind != "simulated"; });
        return cameras;
    };
    return access;
}

constexpr int startMs = 10000, runMs = 20000; // longest waits, on a busy machine

} // namespace

class TestRecordPage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void recordsByKeyAndTheNextTeamIsUp();
    void theSecondsBeforeThePressAreRecorded();
    void theRobotStartsAndEndsTheRun();
    void motionStartsARunThatEndsAfterATime();
    void withoutAFloorNothingStartsByItself();
    void theRobotOfTheTeamThatIsUpDrives_data();
    void theRobotOfTheTeamThatIsUpDrives();
    void placesAreSentWhereThatIsChosen();
    void aCountdownIsCalledOff();
    void closingWhileRecordingKeepsWhatThereIs();
    void withoutCamerasItSaysSo();
    void theOthersRunWithoutACameraThatCannotBeOpened();
    void withoutAnyPictureNothingIsRecorded();
    void aChoiceIsKeptInTheProject();
    void whatCannotBeginIsTold();
    void theWindowDoesNotWaitForTheProject();
    void anUnregisteredCameraLeadsToTestbed();

private:
    void show(bool readOnly = false, CameraAccess access = simulatedCameras());
    void waitForTheRobot();
    template <class Widget>
    Widget *part() const
    {
        return m_page->findChild<Widget *>();
    }
    QPushButton *button() const { return m_page->findChild<QPushButton *>(QStringLiteral("recordButton")); }
    QString warning() const { return part<WarningBar>()->words(); }
    std::vector<TrialRecord> trials() const { return *m_project->trials().all(); }
    void chooseStart(const QVariant &data);
    QComboBox *choice(const QString &accessibleName) const;
    template <class Box>
    Box *box(const QString &accessibleName) const;
    QSpinBox *before() const;

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    std::unique_ptr<RecordPage> m_page;
};

void TestRecordPage::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("Odograph"));
    QCoreApplication::setApplicationName(QStringLiteral("tst_record_page"));
}

void TestRecordPage::init()
{
    QSettings().clear();
    m_folder = std::make_unique<QTemporaryDir>();
    m_project =
        std::move(*Project::create(m_folder->filePath(QStringLiteral("lesson.odo")).toStdString(), "Lesson"));
    test::addCircleLesson(*m_project);
}

void TestRecordPage::cleanup()
{
    m_page.reset();
    m_project.reset();
}

void TestRecordPage::show(bool readOnly, CameraAccess access)
{
    m_page = std::make_unique<RecordPage>(*m_project, readOnly, std::move(access));
    m_page->resize(1282, 640);
    m_page->refresh();
    m_page->show();
}

void TestRecordPage::waitForTheRobot()
{
    QTRY_VERIFY_WITH_TIMEOUT(part<LiveMap>()->latestPosition(0).has_value(), startMs);
}

void TestRecordPage::chooseStart(const QVariant &data)
{
    for (QComboBox *box : part<RunCard>()->findChildren<QComboBox *>()) {
        if (box->accessibleName() == QStringLiteral("When the recording begins"))
            box->setCurrentIndex(box->findData(data));
    }
}

void TestRecordPage::recordsByKeyAndTheNextTeamIsUp()
{
    show();
    QVERIFY(warning().isEmpty());
    BusyWatch busy;
    waitForTheRobot();
    const auto images = m_page->findChildren<LiveImageArea *>();
    QCOMPARE(images.size(), 2);
    for (const LiveImageArea *live : images)
        QTRY_VERIFY_WITH_TIMEOUT(live->hasFrame(), startMs);
    // The robot's centre is known to some millimetres; what the filter is off in a curve adds some.
    QTRY_VERIFY_WITH_TIMEOUT(std::abs((*part<LiveMap>()->latestPosition(0) - test::circleMiddle).norm() -
                                      test::circleRadiusM) < 0.02,
                             startMs);

    const NextRun up = part<RunCard>()->run();
    QCOMPARE(up.team, std::string("Falcon"));
    QCOMPARE(up.trial, std::string("Falcon 1"));
    PresentSource &presentation = m_page->presentation();
    QCOMPARE(presentation.run().team, QStringLiteral("Falcon"));
    // 1.1 m/s all the way; the causal filter is off by some hundredths
    QTRY_VERIFY(std::abs(QLocale().toDouble(presentation.speed(0)) - 1.1) < 0.2);
    const std::unique_ptr<QWidget> map(presentation.makeMap());
    QTRY_VERIFY(dynamic_cast<LiveMap &>(*map).latestPosition(0));
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs);
    QSignalSpy changed(m_page.get(), &RecordPage::changed);
    QTest::keyClick(m_page.get(), Qt::Key_F9);
    QVERIFY(m_page->isRecording());
    QCOMPARE(button()->text(), QStringLiteral("Stop"));
    QVERIFY(!part<RunCard>()->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(trials().size() == 1 && trials().front().durationS > 2.5, runMs);
    QTest::keyClick(m_page.get(), Qt::Key_F9);
    QCOMPARE(button()->text(), QStringLiteral("Record"));

    const auto *result = part<RunResultCard>();
    QTRY_VERIFY2_WITH_TIMEOUT(result->words().startsWith(QStringLiteral("Final")),
                              qPrintable(result->words()), runMs);
    QCOMPARE(result->trial(), QStringLiteral("Falcon 1"));
    QVERIFY2(busy.longestMs() < longestAllowedMs(),
             qPrintable(QStringLiteral("the event loop stood for %1 ms").arg(busy.longestMs())));

    QCOMPARE(trials().size(), std::size_t(1));
    const TrialRecord trial = trials().front();
    QVERIFY(!trial.unfinished);
    QCOMPARE(trial.teamName, std::string("Falcon"));
    const auto recordings = *m_project->trials().recordings(trial.id);
    QCOMPARE(recordings.size(), std::size_t(2));
    QVERIFY(isStepMeasured(recordings[1]));
    const auto analyses = *m_project->analyses().currentMetrics(trial.id);
    QCOMPARE(analyses.size(), std::size_t(1));
    const auto top =
        std::ranges::find(analyses.front().profile.metrics, std::string("max_speed"), &Metric::name);
    QVERIFY2(std::abs(top->value - 1.1) < 0.1,
             qPrintable(QString::number(top->value))); // 1.1 m/s all the way
    QCOMPARE(part<RunCard>()->run().team, std::string("Otter"));
    QCOMPARE(part<RunCard>()->run().trial, std::string("Otter 1"));
    QVERIFY(part<RunCard>()->isEnabled());
    QCOMPARE(changed.size(), 2); // recorded, measured
    // the projector still has the run that has just ended
    const PresentedRun presented = m_page->presentation().run();
    QCOMPARE(presented.team, QStringLiteral("Falcon"));
    QVERIFY(presented.more.contains(QStringLiteral("Falcon 1")));
    QCOMPARE(presented.robots.size(), std::size_t(1));
    QVERIFY(!presented.robots.front().results.empty());
}

QSpinBox *TestRecordPage::before() const
{
    for (QSpinBox *box : part<RunCard>()->findChildren<QSpinBox *>()) {
        if (box->accessibleName() == QStringLiteral("Seconds recorded before the start"))
            return box;
    }
    return nullptr;
}

/// Two seconds are kept, and the trial is stopped as soon as it is in the project: it has them, and knows
/// when the button was pressed. The choice outlives the window.
void TestRecordPage::theSecondsBeforeThePressAreRecorded()
{
    show();
    QCOMPARE(before()->value(), 0);
    QCOMPARE(before()->text(), QStringLiteral("off"));
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs);
    before()->setFocus();
    QTest::keyClick(before(), Qt::Key_Up);
    QTest::keyClick(before(), Qt::Key_Up);
    QCOMPARE(before()->value(), 2);
    QVERIFY2(
        part<StartCard>()->words().startsWith(QStringLiteral("F9 records, with the 2 s before; F9 stops")),
        qPrintable(part<StartCard>()->words()));
    waitForTheRobot();
    const Nanoseconds running = steadyNow();
    QTRY_VERIFY_WITH_TIMEOUT(steadyNow() - running > std::chrono::milliseconds(2200), startMs);
    button()->click();
    QTRY_VERIFY_WITH_TIMEOUT(trials().size() == 1 && trials().front().durationS > 1.5, runMs);
    button()->click();
    QTRY_VERIFY_WITH_TIMEOUT(!m_page->isRecording(), runMs);
    const TrialRecord trial = trials().front();
    QVERIFY(!trial.unfinished);
    // An interval may be missing, and what a frame takes to arrive is more.
    const double startS = QString::fromStdString(trial.variables.at(startVariable)).toDouble();
    QVERIFY2(startS > 1.8 && startS < 2.1, qPrintable(QString::number(startS)));
    chooseStart(3); // nobody is late after a countdown
    QVERIFY(!before()->isEnabled());
    QVERIFY2(part<StartCard>()->words().startsWith(QStringLiteral("F9 records, F9 stops")),
             qPrintable(part<StartCard>()->words()));
    show();
    QCOMPARE(before()->value(), 2);
}

void TestRecordPage::theRobotStartsAndEndsTheRun()
{
    show();
    waitForTheRobot();
    NextRun run = part<RunCard>()->run();
    run.task = "Circle";
    part<RunCard>()->setRun(run);
    chooseStart(-1);
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs); // not while pictures are late
    button()->click();
    QVERIFY(!m_page->isRecording());
    QVERIFY2(part<StartCard>()->words().contains(QStringLiteral("Waiting for the robot at “Lap”")),
             qPrintable(part<StartCard>()->words()));
    QTRY_VERIFY_WITH_TIMEOUT(m_page->isRecording(), runMs);
    QTRY_VERIFY_WITH_TIMEOUT(!m_page->isRecording(), runMs);
    const auto *result = part<RunResultCard>();
    QTRY_VERIFY2_WITH_TIMEOUT(result->words().startsWith(QStringLiteral("Final")),
                              qPrintable(result->words()), runMs);
    const auto analyses = *m_project->analyses().currentMetrics(trials().front().id);
    const auto lap =
        std::ranges::find(analyses.front().profile.metrics, std::string("best_lap"), &Metric::name);
    QVERIFY(lap != analyses.front().profile.metrics.end());
    QVERIFY2(std::abs(lap->value - 2 * M_PI * test::circleRadiusM / 1.1) < 0.05,
             qPrintable(QString::number(lap->value)));
}

template <class Box>
Box *TestRecordPage::box(const QString &accessibleName) const
{
    for (Box *each : part<RunCard>()->findChildren<Box *>()) {
        if (each->accessibleName() == accessibleName)
            return each;
    }
    return nullptr;
}

QComboBox *TestRecordPage::choice(const QString &accessibleName) const
{
    return box<QComboBox>(accessibleName);
}

/// The robot circles all the time, so it starts as soon as the button is pressed; and ends two seconds later.
void TestRecordPage::motionStartsARunThatEndsAfterATime()
{
    show();
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs);
    QComboBox *ends = choice(QStringLiteral("When the recording ends"));
    auto *after = box<QDoubleSpinBox>(QStringLiteral("Seconds after the start that end the recording"));
    QVERIFY(!after->isVisible());
    chooseStart(-2);
    ends->setCurrentIndex(ends->findText(QStringLiteral("after a time")));
    QVERIFY(after->isVisible());
    after->setValue(2);
    waitForTheRobot();
    QTest::keyClick(m_page.get(), Qt::Key_F9);
    QVERIFY(!m_page->isRecording());
    QVERIFY2(
        part<StartCard>()->words().startsWith(QStringLiteral("Waiting until something moves on the floor.")),
        qPrintable(part<StartCard>()->words()));
    QTRY_VERIFY_WITH_TIMEOUT(m_page->isRecording(), runMs);
    QCOMPARE(part<StartCard>()->words(), QStringLiteral("Ends 2 s after the start, or with F9"));
    QTRY_VERIFY_WITH_TIMEOUT(button()->text() == QStringLiteral("Record"), runMs);
    QTRY_VERIFY_WITH_TIMEOUT(trials().size() == 1 && !trials().front().unfinished, runMs);
    // Two seconds after the start, with what the tick and the last frames take on a busy machine.
    const TrialRecord trial = trials().front();
    QVERIFY(trial.variables.contains(startVariable));
    const double startS = QString::fromStdString(trial.variables.at(startVariable)).toDouble(),
                 afterS = trial.durationS - startS;
    QVERIFY2(startS > 0 && startS < 1.5 && afterS > 1 && afterS < 4,
             qPrintable(QStringLiteral("%1 %2").arg(startS).arg(afterS)));
}

void TestRecordPage::withoutAFloorNothingStartsByItself()
{
    m_project =
        std::move(*Project::create(m_folder->filePath(QStringLiteral("bare.odo")).toStdString(), "Bare"));
    QVERIFY(m_project->cameras().add({0, "A", "sim:A"}));
    show();
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs);
    chooseStart(-2);
    QVERIFY(!button()->isEnabled());
    QCOMPARE(part<StartCard>()->words(), QStringLiteral("Register a camera to the floor, or begin at once"));
    chooseStart(0);
    QVERIFY(button()->isEnabled());
}

void TestRecordPage::theRobotOfTheTeamThatIsUpDrives_data()
{
    QTest::addColumn<RobotRecord>("robot");
    RobotRecord red, rover;
    red.name = "Red";
    red.colour = RgbColour{0xd7, 0x23, 0x28};
    red.heightMode = RobotRecord::Height::Given;
    red.heightM = 0.12;
    rover.name = "Rover"; // of any look
    QTest::newRow("of another colour, taller") << red;
    QTest::newRow("without a colour") << rover;
}

/// Nothing but blue robots drove before the simulated cameras once, whoever was up.
void TestRecordPage::theRobotOfTheTeamThatIsUpDrives()
{
    QFETCH(RobotRecord, robot);
    const auto added = m_project->robots().add(robot);
    QVERIFY(added && m_project->teams().add({0, "Heron", "9A", "", {}, {added->id}}));
    TeamRecord falcon = *m_project->teams().find("Falcon");
    falcon.robots = {m_project->robots().all()->front().id};
    QVERIFY(m_project->teams().set(falcon));
    show();
    waitForTheRobot(); // the blue one
    part<RunCard>()->setRun(part<RunCard>()->lineUp().run("9A", "Heron"));
    QCOMPARE(part<RunCard>()->robots().size(), std::size_t(1));
    const auto circles = [this] {
        const auto at = part<LiveMap>()->latestPosition(0);
        return at && std::abs((*at - test::circleMiddle).norm() - test::circleRadiusM) < 0.03;
    };
    QTRY_VERIFY_WITH_TIMEOUT(circles(), startMs);
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs);
    QTest::keyClick(m_page.get(), Qt::Key_F9);
    QTRY_VERIFY_WITH_TIMEOUT(trials().size() == 1 && trials().front().durationS > 4.5, runMs); // once round
    QTest::keyClick(m_page.get(), Qt::Key_F9);
    const auto *result = part<RunResultCard>();
    QTRY_VERIFY2_WITH_TIMEOUT(result->words().startsWith(QStringLiteral("Final")),
                              qPrintable(result->words()), runMs);
    const auto analyses = *m_project->analyses().current(trials().front().id);
    QCOMPARE(analyses.size(), std::size_t(1));
    const std::vector<ProfilePoint> &points = analyses.front().profile.points;
    std::size_t found = 0;
    double worst = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        found += points[i].valid;
        if (points[i].valid)
            worst = std::max(
                worst, std::abs((points[i].position - test::circleMiddle).norm() - test::circleRadiusM));
    }
    qInfo("%zu frames, found in %zu, at most %.1f mm beside the circle", points.size(), found, 1e3 * worst);
    // It was recorded from when the team was chosen on; two frames may have been on their way.
    // a busy machine paints fewer
    QVERIFY(points.size() >= 45 && found + 2 >= points.size() &&
            double(found) >= 0.98 * double(points.size()));
    QVERIFY(worst <= 0.01);
}

void TestRecordPage::placesAreSentWhereThatIsChosen()
{
    const odo::test::DatagramReceiver receiver(true);
    show();
    waitForTheRobot();
    SentPositions sent;
    sent.isOn = true;
    sent.target.port = receiver.port;
    sent.choose();
    m_page->followNetwork(); // as when the preferences are closed
    QVERIFY(!receiver.next().empty());
    sent.target.interface = "gone0";
    sent.choose();
    QSignalSpy failed(m_page.get(), &RecordPage::failed);
    m_page->followNetwork();
    QCOMPARE(failed.size(), 1);
    waitForTheRobot(); // it is followed all the same
}

void TestRecordPage::aCountdownIsCalledOff()
{
    show();
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs);
    chooseStart(10);
    QTest::keyClick(m_page.get(), Qt::Key_F9);
    QCOMPARE(button()->text(), QStringLiteral("Cancel"));
    QTest::keyClick(m_page.get(), Qt::Key_Escape);
    QCOMPARE(button()->text(), QStringLiteral("Record"));
    QVERIFY(trials().empty());
}

void TestRecordPage::closingWhileRecordingKeepsWhatThereIs()
{
    show();
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs);
    waitForTheRobot();
    button()->click();
    QTRY_VERIFY_WITH_TIMEOUT(trials().size() == 1 && trials().front().durationS > 1, runMs);
    m_page->hide(); // another mode: the run goes on
    QVERIFY(m_page->isRecording());
    m_page.reset(); // does not wait for the hashes: the next opening makes them
    QCOMPARE(trials().size(), std::size_t(1));
    QVERIFY(!trials().front().unfinished);
    const auto recordings = m_project->trials().recordings(trials().front().id);
    for (const RecordingRecord &recording : *recordings)
        QVERIFY2(recording.frameTimes.size() > 10 && recording.bytes > 0, // a busy machine paints fewer
                 qPrintable(QStringLiteral("%1 pictures, %2 bytes")
                                .arg(recording.frameTimes.size())
                                .arg(recording.bytes)));
}

void TestRecordPage::withoutCamerasItSaysSo()
{
    CameraAccess none;
    none.list = [] { return std::vector<CameraDescription>(); };
    show(false, none);
    QTRY_COMPARE_WITH_TIMEOUT(part<QStackedWidget>()->currentIndex(), 1, startMs);
    QVERIFY(!m_page->isRecording());

    show(true);
    QTRY_VERIFY_WITH_TIMEOUT(warning().contains(QStringLiteral("is read-only")), startMs);
    QVERIFY(!button()->isEnabled());
}

void TestRecordPage::theOthersRunWithoutACameraThatCannotBeOpened()
{
    const auto isThere = std::make_shared<std::atomic<bool>>(false);
    CameraAccess access = simulatedCameras();
    access.open = [isThere](const std::string &uri) -> Result<std::unique_ptr<CameraSource>> {
        if (uri == "sim:A" && !*isThere)
            return test::saidFailure(ErrorCode::Unavailable, "camera " + uri, "another program uses it",
                                     "close that program");
        return openCamera(uri);
    };
    show(false, access);
    QTRY_COMPARE_WITH_TIMEOUT(
        warning(), QStringLiteral("Camera A: camera sim:A: another program uses it; close that program."),
        startMs);
    waitForTheRobot(); // the other one sees it
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs);
    button()->click();
    QTRY_VERIFY_WITH_TIMEOUT(trials().size() == 1 && trials().front().durationS > 1, runMs);
    *isThere = true;
    QTRY_VERIFY_WITH_TIMEOUT(warning().isEmpty(), startMs);
    const auto images = m_page->findChildren<LiveImageArea *>();
    for (const LiveImageArea *live : images)
        QTRY_VERIFY_WITH_TIMEOUT(live->hasFrame(), startMs);
    button()->click();
    QTRY_VERIFY_WITH_TIMEOUT(!trials().front().unfinished, runMs);
    const auto recordings = m_project->trials().recordings(trials().front().id);
    QCOMPARE(recordings->size(), std::size_t(2)); // from where it came
    QVERIFY(recordings->front().frameTimes.size() < recordings->back().frameTimes.size());
    QCOMPARE(recordings->front().widthPx, recordings->back().widthPx);
}

void TestRecordPage::withoutAnyPictureNothingIsRecorded()
{
    CameraAccess access = simulatedCameras();
    access.open = [](const std::string &uri) -> Result<std::unique_ptr<CameraSource>> {
        return test::saidFailure(ErrorCode::Unavailable, "camera " + uri, "it was unplugged",
                                 "plug it in again");
    };
    show(false, access);
    QTRY_COMPARE_WITH_TIMEOUT(part<StartCard>()->words(), QStringLiteral("No camera sends frames"), startMs);
    QVERIFY(!button()->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(warning().startsWith(QStringLiteral("Camera A: camera sim:A: it was unplugged")),
                             startMs);
}

void TestRecordPage::aChoiceIsKeptInTheProject()
{
    show();
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs);
    Person person({[](QDialog &asked) {
        const auto boxes = asked.findChildren<QComboBox *>();
        boxes[0]->setCurrentIndex(boxes[0]->findData(QStringLiteral("sim:B")));
        boxes[1]->setCurrentIndex(0); // not used
        press(asked);
    }});
    m_page->actions()[1]->trigger();
    QVERIFY(person.isDone());
    QCOMPARE(m_project->cameras().find("A")->deviceUri, std::string("sim:B"));
    QCOMPARE(m_project->cameras().find("B")->deviceUri, std::string());
    QTRY_COMPARE_WITH_TIMEOUT(m_page->findChildren<LiveImageArea *>().size(), 1, startMs);
}

/// Another program records into the project just now.
void TestRecordPage::whatCannotBeginIsTold()
{
    show();
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs);
    const auto lock = RecordingLock::take(m_project->mediaFolder());
    QVERIFY(lock);
    QSignalSpy failed(m_page.get(), &RecordPage::failed);
    button()->click();
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, startMs);
    QVERIFY(failed.front().front().value<Error>().why.english().find("is being recorded into it now") !=
            std::string::npos);
    QVERIFY(!m_page->isRecording());
    QVERIFY(trials().empty());
    QCOMPARE(button()->text(), QStringLiteral("Record"));
    QVERIFY(part<RunCard>()->isEnabled());
}

/// The project's disk may be slow: whoever holds the turn to write holds up the recording's thread, not the
/// window.
void TestRecordPage::theWindowDoesNotWaitForTheProject()
{
    show();
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs);
    const auto turn = WriteTurn::of(m_project->file());
    std::promise<void> go;
    std::promise<void> held;
    std::thread slow([&] {
        const HeldTurn lock(*turn);
        held.set_value();
        go.get_future().wait();
    });
    held.get_future().wait();
    button()->click(); // would hang here, as long as the disk does
    QVERIFY(m_page->isRecording());
    const auto images = m_page->findChildren<LiveImageArea *>();
    QTRY_VERIFY_WITH_TIMEOUT(images.front()->hasFrame(), startMs);
    button()->click();
    QVERIFY(part<StartCard>()->words().startsWith(QStringLiteral("Writing the last frames")));
    go.set_value();
    slow.join();
    QTRY_VERIFY_WITH_TIMEOUT(!m_page->isRecording(), runMs);
}

void TestRecordPage::anUnregisteredCameraLeadsToTestbed()
{
    m_project =
        std::move(*Project::create(m_folder->filePath(QStringLiteral("bare.odo")).toStdString(), "Bare"));
    QVERIFY(m_project->cameras().add({0, "A", "sim:A"}));
    show();
    QTRY_VERIFY_WITH_TIMEOUT(warning().startsWith(QStringLiteral("Camera A is not registered to the floor")),
                             startMs);
    QSignalSpy asked(m_page.get(), &RecordPage::testbedRequested);
    part<WarningBar>()->findChild<QPushButton *>()->click();
    QCOMPARE(asked.size(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(button()->isEnabled(), startMs); // it can be recorded all the same
    QVERIFY(!part<LiveMap>()->latestPosition(0));
}

ODOGRAPH_TEST(TestRecordPage, QApplication)
#include "tst_record_page.moc"
