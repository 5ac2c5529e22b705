// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/import/import_trial_job.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/project_content.h"
#include "ui/main_window/internal/import_dialogs.h"
#include "ui/main_window/internal/window_bars.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/testbed/floor/floor_wizard.h"
#include "ui/testbed/lens/lens_wizard.h"
#include "ui/views/widgets/form_fields.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

void setFile(QDialog &dialog, int number, const QString &file)
{
    dialog.findChildren<PathField *>().at(number)->setPath(file);
}

/// Until the default button can be pressed.
void waitForNext(QDialog &dialog)
{
    QTRY_VERIFY_WITH_TIMEOUT(
        std::ranges::any_of(dialog.findChildren<QPushButton *>(),
                            [](auto *button) { return button->isDefault() && button->isEnabled(); }),
        60'000);
}

/// A wizard writes its pictures before it closes.
void waitUntilClosed(QDialog &dialog)
{
    QTRY_VERIFY_WITH_TIMEOUT(!dialog.isVisible(), 60'000);
}

} // namespace

/// What a class does with the window from an empty project to the exported track, by its menus and dialogs,
/// each with bad input on the way, which is told in words and leaves the project as it was.
class TestWindowFlows : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void makesAProject();
    void importsALayout();
    void addsARobot();
    void registersANewCameraFromVideo();
    void calibratesAndCancels();
    void importsIntrinsics();
    void importsATrial();
    void refusesABadTrial_data();
    void refusesABadTrial();
    void cancelsTracking();
    void tracks();
    void synchronisesAgain();
    void exportsAndCopies();
    void cancelsTheDemo();
    void opensTheDemoThatIsThere();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    void write(const QString &name, const QByteArray &content) const;
    void renderMaterial() const;
    /// Triggers the action of this text and answers its dialogs; waits for the job that may follow.
    void run(const char *text, const QList<Answer> &answers);
    void runAndCancel(const char *text, const Answer &answer);
    QString message() const { return m_window->findChild<MessageBar *>()->text(); }
    Project &project() const { return *m_window->workspace().project(); }
    QStringList content() const { return contentOf(project()); }
    Answer importAnswer(const QString &trial, const QString &first, const QString &second, SyncBy sync) const;

    QTemporaryDir m_folder;
    SimulatedScene m_scene = demoTestbed(3);
    std::unique_ptr<MainWindow> m_window;
};

void TestWindowFlows::write(const QString &name, const QByteArray &content) const
{
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
}

void TestWindowFlows::renderMaterial() const
{
    const QStringList names{QStringLiteral("a.mkv"), QStringLiteral("b.mkv")};
    for (int camera = 0; camera < 2; ++camera)
        QVERIFY(renderVideo(m_scene, camera, path(names.at(camera)).toStdString(), {}, {}));
    SimulatedBoard board;
    const CameraModel &lens = m_scene.cameras[0].view.camera();
    int number = 0;
    for (const RigidTransform &pose : heldBoardPoses(lens, board, 6, 7)) {
        board.cameraFromBoard = pose;
        const QString name = QStringLiteral("board%1.png").arg(++number);
        QVERIFY(writeImage(renderBoard(lens, board, 1.5, 100), path(name).toStdString()));
    }
}

void TestWindowFlows::initTestCase()
{
    test::beginWithoutSettings();
    QLocale::setDefault(QLocale::c());
    m_scene.durationS = 1.5;
    SimulatedRobot robot;
    robot.name = "red";
    robot.colour = *parseColour("#d72328");
    robot.motion = makeCircleMotion({1.5, 1.1}, 0.5, 1.0, 0.5);
    m_scene.robots.push_back(robot);
    renderMaterial();
    write(QStringLiteral("layout.csv"), "label,x_mm,y_mm\nO,0,0\nU,3000,0\nV,0,2200\nD,3000,2200\n");
    write(QStringLiteral("broken.csv"), "label,x_mm\nO,0\n");
    write(QStringLiteral("novideo.mkv"), "this is no video");
    write(QStringLiteral("broken.yaml"), "image_width: 640\ncamera_matrix: [[[[\n");
    m_window = std::make_unique<MainWindow>();
    m_window->show();
}

void TestWindowFlows::run(const char *text, const QList<Answer> &answers)
{
    QTRY_VERIFY2(test::actionOf(*m_window, text),
                 text); // the pages of a project that was just made are still to come
    test::run(*m_window, test::actionOf(*m_window, text), answers);
}

void TestWindowFlows::runAndCancel(const char *text, const Answer &answer)
{
    const auto press = connect(&m_window->workspace(), &Workspace::jobStarted, this, [this] {
        for (const QAction *action : m_window->findChildren<QAction *>())
            if (action->text() == QStringLiteral("&Import trial from videos…"))
                QVERIFY2(!action->isEnabled(), "one job at a time");
        QTest::mouseClick(m_window->findChild<JobIndicator *>()->findChild<QPushButton *>(), Qt::LeftButton);
    });
    run(text, {answer});
    disconnect(press);
}

void TestWindowFlows::makesAProject()
{
    run("New project…", {chooseFile(path(QStringLiteral("nowhere/x.odo")))});
    QVERIFY(!m_window->workspace().project());
    run("New project…", {chooseFile(path(QStringLiteral("class")))});
    QVERIFY2(m_window->workspace().project(), qPrintable(message()));
    QVERIFY(QFile::exists(path(QStringLiteral("class.odo"))));
    QCOMPARE(m_window->windowTitle(), QStringLiteral("class — Odograph"));
}

void TestWindowFlows::importsALayout()
{
    const QStringList before = content();
    run("Import marker layout…", {chooseFile(path(QStringLiteral("broken.csv")))});
    QVERIFY2(message().contains(QLatin1String("broken.csv")), qPrintable(message()));
    QCOMPARE(content(), before);
    run("Import marker layout…", {chooseFile(path(QStringLiteral("layout.csv"))), [](QDialog &dialog) {
                                      dialog.findChild<QLineEdit *>()->setText(QStringLiteral("floor"));
                                      press(dialog);
                                  }});
    QCOMPARE(content(), before + QStringList(QStringLiteral("layout floor")));
    QCOMPARE(message(), QStringLiteral("Layout floor has 4 markers."));
}

void TestWindowFlows::addsARobot()
{
    const Answer red = [](QDialog &dialog) {
        dialog.findChild<QLineEdit *>()->setText(QStringLiteral("red"));
        dialog.findChildren<QComboBox *>().last()->setCurrentIndex(1); // its height is told
        dialog.findChild<QDoubleSpinBox *>()->setValue(60);
        press(dialog);
    };
    run("Add robot…", {red});
    const auto robot = project().robots().find("red");
    QVERIFY(robot);
    QCOMPARE(robot->heightM, 0.06);
    const QStringList before = content();
    run("Add robot…", {red});
    QVERIFY2(message().contains(QLatin1String("red")), qPrintable(message()));
    QCOMPARE(content(), before);
}

void TestWindowFlows::registersANewCameraFromVideo()
{
    const auto begin = [this](QDialog &dialog, const QString &camera, const QString &file) {
        for (QComboBox *box : dialog.findChildren<QComboBox *>())
            if (box->isEditable())
                box->setEditText(camera);
        dynamic_cast<FloorWizard &>(dialog).source().setFile(path(file));
        press(dialog);
    };
    const QStringList before = content();
    run("Register camera…", {[&](QDialog &dialog) {
            begin(dialog, QStringLiteral("A"), QStringLiteral("novideo.mkv"));
            QTRY_VERIFY_WITH_TIMEOUT(std::ranges::any_of(dialog.findChildren<QLabel *>(),
                                                         [](auto *label) {
                                                             return label->text().contains(QStringLiteral(
                                                                 "not a supported kind of video"));
                                                         }),
                                     60'000);
            dialog.reject();
        }});
    QCOMPARE(content(), before);
    for (const QString &camera : {QStringLiteral("A"), QStringLiteral("B")}) {
        run("Register camera…", {[&](QDialog &dialog) {
                begin(dialog, camera, camera.toLower() + QStringLiteral(".mkv"));
                waitForNext(dialog);
                press(dialog);
                waitUntilClosed(dialog);
            }});
        QVERIFY2(message().startsWith(QStringLiteral("Camera %1 is registered.").arg(camera)),
                 qPrintable(message()));
    }
    QCOMPARE(project().cameras().all()->size(), std::size_t(2));
}

void TestWindowFlows::calibratesAndCancels()
{
    const auto begin = [this](QDialog &dialog) {
        for (QComboBox *box : dialog.findChildren<QComboBox *>())
            if (box->isEditable())
                box->setEditText(QStringLiteral("C"));
        QStringList files;
        for (const QString &name : QDir(m_folder.path()).entryList({QStringLiteral("board*.png")}))
            files << path(name);
        dynamic_cast<LensWizard &>(dialog).source().addFiles(files);
        press(dialog);
    };
    const QStringList before = content();
    run("Calibrate camera…", {[&](QDialog &dialog) {
                                  begin(dialog);
                                  waitForNext(dialog);
                                  // queued: the question that follows is answered next
                                  QMetaObject::invokeMethod(&dialog, &QDialog::reject, Qt::QueuedConnection);
                              },
                              [](QDialog &question) { test::button(question, "Discard")->click(); }});
    QCOMPARE(content(), before);
    run("Calibrate camera…", {[&](QDialog &dialog) {
            begin(dialog);
            for (int page = 0; page < 2; ++page) {
                waitForNext(dialog);
                press(dialog);
            }
            waitUntilClosed(dialog);
        }});
    QVERIFY2(message().startsWith(QLatin1String("Camera C is calibrated.")), qPrintable(message()));
}

void TestWindowFlows::importsIntrinsics()
{
    const QString file = path(QStringLiteral("c.yaml"));
    QVERIFY(exportIntrinsics(project(), "C", file.toStdString()));
    const QStringList before = content();
    run("Import lens calibration…", {chooseFile(path(QStringLiteral("broken.yaml")))});
    QVERIFY2(message().contains(QLatin1String("broken.yaml")), qPrintable(message()));
    QCOMPARE(content(), before);
    run("Import lens calibration…", {chooseFile(file), enterText(QStringLiteral("D"))});
    const auto camera = project().cameras().find("D");
    QVERIFY2(camera, qPrintable(message()));
    QVERIFY(project().cameras().currentIntrinsics(camera->id)->has_value());

    write(QStringLiteral("two.toml"), "[left]\nsize = [640, 480]\n"
                                      "matrix = [[600, 0, 320], [0, 600, 240], [0, 0, 1]]\n"
                                      "distortions = [0, 0, 0, 0]\n"
                                      "[right]\nsize = [640, 480]\n"
                                      "matrix = [[700, 0, 320], [0, 700, 240], [0, 0, 1]]\n"
                                      "distortions = [0, 0, 0, 0]\n");
    run("Import lens calibration…",
        {chooseFile(path(QStringLiteral("two.toml"))), enterText(QStringLiteral("E")), [](QDialog &dialog) {
             auto *names = dialog.findChild<QComboBox *>();
             names->setCurrentText(QStringLiteral("right"));
             dialog.accept();
         }});
    const auto second = project().cameras().find("E");
    QVERIFY2(second, qPrintable(message()));
    QCOMPARE(project().cameras().currentIntrinsics(second->id)->value().calibration.intrinsics.fxPx, 700.0);
}

Answer TestWindowFlows::importAnswer(const QString &trial, const QString &first, const QString &second,
                                     SyncBy sync) const
{
    return [this, trial, first, second, sync](QDialog &dialog) {
        auto &import = dynamic_cast<ImportTrialDialog &>(dialog);
        import.findChildren<QLineEdit *>().at(0)->setText(trial);
        for (auto *box : import.findChildren<QComboBox *>())
            if (const int index = box->findText(QStringLiteral("By hand: time offset")); index >= 0)
                box->setCurrentIndex(box->findData(int(sync)));
        setFile(dialog, 0, path(first));
        setFile(dialog, 1, path(second));
        press(dialog);
    };
}

void TestWindowFlows::importsATrial()
{
    run("Import trial from videos…", {importAnswer(QStringLiteral("told"), QStringLiteral("a.mkv"),
                                                   QStringLiteral("b.mkv"), SyncBy::Given)});
    QVERIFY2(project().trials().find("told"), qPrintable(message()));
    QCOMPARE(project().trials().find("told")->syncMethod, std::string("told"));
    run("Import trial from videos…", {importAnswer(QStringLiteral("found"), QStringLiteral("a.mkv"),
                                                   QStringLiteral("b.mkv"), SyncBy::Automatic)});
    const auto found = project().trials().find("found");
    QVERIFY2(found, qPrintable(message()));
    QCOMPARE(project().trials().recordings(found->id)->size(), std::size_t(2));
    // Start stays, with its next step
    QCOMPARE(m_window->windowTitle(), QStringLiteral("class — Odograph"));
    QVERIFY(m_window->showTrial("found"));
    QTRY_VERIFY2(m_window->windowTitle().contains(QLatin1String("found")),
                 qPrintable(m_window->windowTitle()));
}

void TestWindowFlows::refusesABadTrial_data()
{
    QTest::addColumn<QString>("trial");
    QTest::addColumn<QString>("second");
    QTest::addColumn<QString>("words");
    QTest::newRow("no video") << "bad"
                              << "novideo.mkv"
                              << "novideo.mkv";
    QTest::newRow("no file") << "bad"
                             << "missing.mkv"
                             << "missing.mkv";
    QTest::newRow("name taken") << "told"
                                << "b.mkv"
                                << "told";
}

void TestWindowFlows::refusesABadTrial()
{
    QFETCH(QString, trial);
    QFETCH(QString, second);
    QFETCH(QString, words);
    const QStringList before = content();
    run("Import trial from videos…", {importAnswer(trial, QStringLiteral("a.mkv"), second, SyncBy::None)});
    QVERIFY2(message().contains(words), qPrintable(message()));
    QCOMPARE(content(), before);
}

void TestWindowFlows::cancelsTracking()
{
    QVERIFY(m_window->showTrial("told"));
    QTRY_VERIFY2(m_window->windowTitle().contains(QLatin1String("told")),
                 qPrintable(m_window->windowTitle()));
    const QStringList before = content();
    runAndCancel("Track…", press);
    QCOMPARE(message(), QStringLiteral("Cancelled. Nothing was changed."));
    QCOMPARE(content(), before);
}

void TestWindowFlows::tracks()
{
    run("Track…", {press});
    QVERIFY2(message().startsWith(QLatin1String("told is tracked: red in ")), qPrintable(message()));
    QCOMPARE(project().analyses().current(project().trials().find("told")->id)->size(), std::size_t(1));
}

void TestWindowFlows::synchronisesAgain()
{
    run("Synchronise…", {[](QDialog &dialog) {
            auto *how = dialog.findChild<QComboBox *>();
            how->setCurrentIndex(how->findData(int(SyncBy::Given)));
            dialog.findChild<QDoubleSpinBox *>()->setValue(0.01);
            press(dialog);
        }});
    QVERIFY2(
        message().startsWith(QLatin1String("told is synchronised. B: started 10.0 ms later, set by hand.")),
        qPrintable(message()));
    const auto trial = project().trials().find("told");
    QCOMPARE(trial->syncOffsetS, 0.01);
    QCOMPARE(project().trials().recordings(trial->id)->at(1).startOffsetS, 0.01);
    QCOMPARE(project().analyses().current(trial->id)->size(), std::size_t(1));
}

void TestWindowFlows::exportsAndCopies()
{
    const auto inMetres = [](QDialog &dialog) {
        test::named<QComboBox>(dialog, "Lengths in")->setCurrentText(QStringLiteral("m"));
        press(dialog);
    };
    run("Export…", {inMetres, chooseFile(path(QStringLiteral("track.csv")))});
    QFile exported(path(QStringLiteral("track.csv")));
    QVERIFY2(exported.open(QIODevice::ReadOnly), qPrintable(message()));
    const QByteArray track = exported.readAll();
    QVERIFY(track.count('\n') > 40 && track.startsWith("t_s,x_m,y_m,"));
    run("Save a copy as…", {chooseFile(path(QStringLiteral("copy")))});
    const auto copy =
        Project::open(path(QStringLiteral("copy.odo")).toStdString(), Project::Access::ReadOnly);
    QVERIFY2(copy, qPrintable(message()));
    QCOMPARE((*copy)->trials().all()->size(), std::size_t(2));
}

void TestWindowFlows::cancelsTheDemo()
{
    const QString folder = path(QStringLiteral("lessons"));
    QVERIFY(QDir().mkpath(folder));
    const QStringList before = content();
    runAndCancel("Open demo lesson…", chooseFile(folder));
    QCOMPARE(message(), QStringLiteral("Cancelled. Nothing was changed."));
    QCOMPARE(QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden), QStringList());
    QCOMPARE(content(), before);
}

/// The lesson takes 135 MB: one that was made before is offered first.
void TestWindowFlows::opensTheDemoThatIsThere()
{
    const QString lesson = path(QStringLiteral("copy.odo")), key = QStringLiteral("demoLesson");
    QSettings().setValue(key, lesson);
    run("Open demo lesson…", {[](QDialog &question) { question.reject(); }});
    QVERIFY(project().file() != lesson.toStdString());
    run("Open demo lesson…", {press});
    QTRY_COMPARE(project().file(), std::filesystem::path(lesson.toStdString()));
    QVERIFY(QSettings().value(QStringLiteral("recentProjects")).toStringList().contains(lesson));
    QSettings().remove(key);
}

ODOGRAPH_TEST(TestWindowFlows, QApplication)
#include "tst_window_flows.moc"
