// SPDX-License-Identifier: GPL-3.0-or-later
// Takes every picture of the manual anew, from the demo lesson, and holds their names against those of
// docs/manual/pictures. They go to the folder ODOGRAPH_PICTURES, or to one that is thrown away.
// docs/manual/make_pictures runs this program.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/demo.h"
#include "tests/manual/picture_book.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/history/history_page.h"
#include "ui/main_window/internal/import_dialogs.h"
#include "ui/main_window/internal/import_lesson_dialog.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/language.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/preferences/preferences_dialog.h"
#include "ui/main_window/workspace.h"
#include "ui/models/timeline.h"
#include "ui/record/internal/run_results.h"
#include "ui/record/record_page.h"
#include "ui/report/report_dialog.h"
#include "ui/review/review_desk.h"
#include "ui/review/review_page.h"
#include "ui/testbed/check/camera_position_dialog.h"
#include "ui/testbed/floor/floor_wizard.h"
#include "ui/testbed/lens/lens_wizard.h"
#include "ui/views/present/present_window.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/spike_list.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int patienceMs = 120'000;
constexpr Nanoseconds second{1'000'000'000};
const QString eight = QStringLiteral("figure-eight"),
              reflections = QStringLiteral("figure-eight with reflections");

/// Whatever day it is, the pictures show the trials of one day, and the cameras of the simulated testbed.
void settleProject(const QString &project)
{
    QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("dates"));
    database.setDatabaseName(project);
    QVERIFY(database.open());
    const QDateTime first({2026, 11, 20}, {9, 15});
    QSqlQuery query(database);
    for (const char *change :
         {"UPDATE trial SET date_ms = %1 + id * 360000", "UPDATE intrinsics SET made_ms = %1 + id * 60000",
          "UPDATE registration SET made_ms = %1 + id * 120000",
          "UPDATE camera SET device_uri = 'sim:' || name"}) {
        QString words = QString::fromLatin1(change);
        if (words.contains(u'%'))
            words = words.arg(first.toMSecsSinceEpoch());
        QVERIFY2(query.exec(words), qPrintable(query.lastError().text()));
    }
}

void copyFolder(const QString &from, const QString &to)
{
    std::filesystem::copy(from.toStdString(), to.toStdString(), std::filesystem::copy_options::recursive);
}

/// Until the default button can be pressed; then it is.
void pressNext(QDialog &dialog)
{
    QTRY_VERIFY_WITH_TIMEOUT(
        std::ranges::any_of(dialog.findChildren<QPushButton *>(),
                            [](auto *button) { return button->isDefault() && button->isEnabled(); }),
        patienceMs);
    press(dialog);
}

} // namespace

class TestManualPictures : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void theFirstLesson();
    void camerasAndMounting();
    void lensCalibration();
    void floorRegistration();
    void importing();
    void review();
    void spikes();
    void compare();
    void history();
    void tasks();
    void reports();
    void preferences();
    void warning();
    void recording(); // adds a trial of today, so it comes last
    void cleanupTestCase();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    QString project() const { return path(QStringLiteral("lesson/demo.odo")); }
    QStringList calibrationImages(const QString &camera) const;
    void showTrial(const QString &trial, Nanoseconds at);
    void takeDock(const char *name, const QString &picture);
    void takeOwnMetrics(const HistoryPage &page);
    ReviewPage &reviewPage() { return *m_book->window().findChild<ReviewPage *>(); }

    // Its name is in some of the pictures, and shall be the same each time.
    QDir m_folder{QDir::temp().filePath(QStringLiteral("odograph-manual"))};
    std::unique_ptr<PictureBook> m_book;
};

void TestManualPictures::initTestCase()
{
    beginWithoutSettings();
    installLanguage(*qApp, QStringLiteral("en"));
    applyAppearance(*qApp, Theme::Light);
    QApplication::setCursorFlashTime(0);
    m_folder.removeRecursively();
    QVERIFY(m_folder.mkpath(QStringLiteral(".")));
    const QString told = qEnvironmentVariable("ODOGRAPH_PICTURES"),
                  demo = qEnvironmentVariable("ODOGRAPH_DEMO");
    if (demo.isEmpty()) {
        const auto made = makeDemo(path(QStringLiteral("lesson")).toStdString(), {});
        QVERIFY2(made, made ? "" : made.error().message().c_str());
    } else {
        copyFolder(demo, path(QStringLiteral("lesson")));
    }
    settleProject(project());
    const QString images = told.isEmpty() ? path(QStringLiteral("pictures")) : told;
    QVERIFY(QDir().mkpath(images));
    m_book = std::make_unique<PictureBook>(images);
    m_book->takeWindow(QStringLiteral("welcome"));
    m_book->open(project());
}

QStringList TestManualPictures::calibrationImages(const QString &camera) const
{
    QStringList files;
    const QDir folder(path(QStringLiteral("lesson/calibration")));
    for (const QString &name : folder.entryList({camera + QStringLiteral("_*.png")}))
        files << folder.filePath(name);
    return files;
}

void TestManualPictures::showTrial(const QString &trial, Nanoseconds at)
{
    m_book->showPage(WindowMode::Review);
    QVERIFY(m_book->window().showTrial(trial.toStdString()));
    waitFor(m_book->window());
    reviewPage().timeline().setCurrentTime(at);
    waitFor(m_book->window());
}

void TestManualPictures::theFirstLesson()
{
    m_book->showPage(WindowMode::Start);
    m_book->takeWindow(QStringLiteral("start"));
    showTrial(eight, 3 * second);
    m_book->takeWindow(QStringLiteral("review"));
    auto *help = m_book->window().findChild<QAction *>(QStringLiteral("help"));
    help->trigger();
    m_book->window().findChild<QAction *>(QStringLiteral("lesson"))->trigger();
    m_book->takeWindow(QStringLiteral("lesson"));
    help->trigger();
    QTest::mouseClick(button(m_book->window(), "Leave the lesson"), Qt::LeftButton);
    m_book->fitWindow(); // the help had made it wider
}

void TestManualPictures::camerasAndMounting()
{
    m_book->showPage(WindowMode::Testbed);
    m_book->takeWindow(QStringLiteral("testbed"));
    m_book->takeDialog("expectedAccuracy", QStringLiteral("accuracy"), [](QDialog &dialog) {
        QTest::mouseClick(button(dialog, "Advice"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!says(dialog, "Trying other positions"), patienceMs);
    });
    m_book->showPage(WindowMode::Record);
    const auto *record = m_book->window().findChild<QPushButton *>(QStringLiteral("recordButton"));
    QTRY_VERIFY_WITH_TIMEOUT(record->isEnabled(), patienceMs); // the cameras run
    m_book->takeDialog("chooseCameras", QStringLiteral("cameras"), [](QDialog &dialog) {
        QTRY_VERIFY_WITH_TIMEOUT(!says(dialog, "Searching for cameras"), patienceMs);
    });
    m_book->takeDialog("doctor", QStringLiteral("doctor"), [](QDialog &dialog) {
        QTRY_VERIFY_WITH_TIMEOUT(button(dialog, "Check again")->isEnabled(), patienceMs);
    });
}

void TestManualPictures::lensCalibration()
{
    m_book->showPage(WindowMode::Testbed);
    m_book->takeDialog("printTargets", QStringLiteral("targets"));
    m_book->takeDialog("calibrate", QString(), [this](QDialog &dialog) {
        dynamic_cast<LensWizard &>(dialog).source().addFiles(calibrationImages(QStringLiteral("A")));
        QTRY_VERIFY_WITH_TIMEOUT(
            std::ranges::none_of(dialog.findChildren<QComboBox *>(),
                                 [](auto *box) { return box->currentText().startsWith(u"Looking"); }),
            patienceMs);
        m_book->take(dialog, QStringLiteral("lens_source"));
        pressNext(dialog);
        QTRY_VERIFY_WITH_TIMEOUT(button(dialog, "Next >")->isEnabled(), patienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(says(dialog, "RMS so far: "), patienceMs);
        m_book->take(dialog, QStringLiteral("lens_pictures"));
        pressNext(dialog);
        QTRY_VERIFY_WITH_TIMEOUT(button(dialog, "Save")->isEnabled(), patienceMs);
        m_book->take(dialog, QStringLiteral("lens_result"));
    });
}

void TestManualPictures::floorRegistration()
{
    m_book->showPage(WindowMode::Testbed);
    m_book->takeDialog("newLayout", QStringLiteral("layout"));
    m_book->takeDialog("register", QString(), [this](QDialog &dialog) {
        const auto trial = m_book->window().workspace().project()->trials().find("circle");
        const auto recordings = m_book->window().workspace().project()->trials().recordings(trial->id);
        dynamic_cast<FloorWizard &>(dialog).source().setFile(QString::fromStdString(
            m_book->window().workspace().project()->resolve(recordings->front()).string()));
        m_book->take(dialog, QStringLiteral("floor_source"));
        pressNext(dialog);
        QTRY_VERIFY_WITH_TIMEOUT(button(dialog, "Save")->isEnabled(), patienceMs);
        m_book->take(dialog, QStringLiteral("floor_markers"));
    });
    m_book->takeDialog("registerTogether", QStringLiteral("together"));
    m_book->takeDialog("checkMoved", QStringLiteral("moved"), [](QDialog &dialog) {
        QPushButton *check = button(dialog, "Check");
        QTest::mouseClick(check, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(
            check->isEnabled() && !dynamic_cast<CameraPositionDialog &>(dialog).isRunning(), patienceMs);
    });
    m_book->takeDialog("revisions", QStringLiteral("revisions"));
}

void TestManualPictures::recording()
{
    m_book->showPage(WindowMode::Record);
    auto &page = *m_book->window().findChild<RecordPage *>();
    auto *team = named<QComboBox>(page, "Team of this run");
    // its plain robot takes a busy machine the least
    team->setCurrentIndex(team->findText(QStringLiteral("Otter")));
    for (QComboBox *box : page.findChildren<QComboBox *>())
        if (const int circle = box->findText(QStringLiteral("Circle")); circle >= 0)
            box->setCurrentIndex(circle);
    auto *record = page.findChild<QPushButton *>(QStringLiteral("recordButton"));
    QTRY_VERIFY_WITH_TIMEOUT(record->isEnabled(), patienceMs);
    m_book->takeWindow(QStringLiteral("record"));
    QTest::mouseClick(record, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(page.isRecording(), patienceMs);
    // never still: some seconds into the run
    m_book->take(m_book->window(), QStringLiteral("record_running"));
    QTest::mouseClick(record, Qt::LeftButton);
    auto *result = page.findChild<RunResultCard *>();
    QTRY_VERIFY_WITH_TIMEOUT(!page.isRecording() && result->words().startsWith(QStringLiteral("Final")) &&
                                 record->isEnabled(),
                             patienceMs);
    m_book->take(m_book->window(), QStringLiteral("record_result"));
    waitFor(m_book->window());
}

void TestManualPictures::importing()
{
    showTrial(eight, 3 * second);
    m_book->takeDialog("import", QStringLiteral("import"), [this](QDialog &dialog) {
        dialog.findChildren<QLineEdit *>().at(0)->setText(QStringLiteral("Run 1"));
        auto &open = *m_book->window().workspace().project();
        const auto trial = open.trials().find("circle");
        const auto recordings = open.trials().recordings(trial->id);
        for (int view = 0; view < 2; ++view)
            dialog.findChildren<PathField *>().at(view)->setPath(
                QString::fromStdString((*recordings)[std::size_t(view)].path));
    });
    const Instant lesson(std::chrono::sys_days(std::chrono::year(2026) / 3 / 9) + std::chrono::hours(9));
    ImportLessonDialog many({{},
                             {QStringLiteral("Falcon"), QStringLiteral("Otter")},
                             {QStringLiteral("Red 2"), QStringLiteral("Blue 1")},
                             {{QStringLiteral("A"), {}}, {QStringLiteral("B"), {}}}},
                            {QStringLiteral("circle")},
                            {{{"IMG_0456.MOV", "PXL_1234.mp4"}, lesson, 24.3},
                             {{"IMG_0457.MOV", "PXL_1235.mp4"}, lesson + std::chrono::minutes(3), 31.8},
                             {{"IMG_0458.MOV", "PXL_1236.mp4"}, lesson + std::chrono::minutes(7), 22.6}});
    m_book->take(many, QStringLiteral("import_lesson"));
    m_book->takeDialog("addRobot", QStringLiteral("add_robot"));
    m_book->takeDialog("importTracks", QStringLiteral("import_tracks"));
    m_book->takeDialog("track", QStringLiteral("track"));
    m_book->takeDialog("synchronise", QStringLiteral("synchronise"));
}

void TestManualPictures::review()
{
    showTrial(eight, 3 * second);
    reviewPage().timeline().setSelection(TimeSpan{2 * second, 5 * second});
    m_book->takeWindow(QStringLiteral("range"));
    reviewPage().timeline().setSelection(std::nullopt);
    auto *disagreement = m_book->window().findChild<QAction *>(QStringLiteral("viewsDisagreement"));
    disagreement->trigger();
    m_book->takeWindow(QStringLiteral("disagreement"));
    disagreement->trigger();
    takeDock("dataDock", QStringLiteral("data"));
    takeDock("intervalDock", QStringLiteral("frame_intervals"));
    takeDock("smoothingDock", QStringLiteral("smoothing"));
    named<QToolButton>(m_book->window(), "In millimetres: How was this computed?")->click();
    auto *passport = m_book->window().findChild<QDialog *>(QStringLiteral("explanation"));
    QVERIFY(passport);
    m_book->take(*passport, QStringLiteral("passport"));
    delete passport;
    auto *present = m_book->window().findChild<QAction *>(QStringLiteral("present"));
    present->trigger();
    auto *presentation = m_book->window().findChild<PresentWindow *>();
    QTRY_VERIFY_WITH_TIMEOUT(presentation && presentation->isSettled(), patienceMs);
    m_book->take(*presentation, QStringLiteral("present"));
    presentation->close();
}

/// Of its own, so that it shows enough.
void TestManualPictures::takeDock(const char *name, const QString &picture)
{
    auto *dock = m_book->window().findChild<QDockWidget *>(QString::fromLatin1(name));
    dock->setFloating(true);
    dock->resize(800, 250);
    dock->show();
    waitFor(m_book->window());
    m_book->take(*dock->widget(), picture);
    reviewPage().desk().resetLayout();
}

void TestManualPictures::spikes()
{
    showTrial(reflections, 3 * second);
    auto *table = m_book->window().findChild<SpikeList *>()->table();
    QTRY_VERIFY(table->model()->rowCount() > 0);
    table->setFocus();
    table->selectRow(0);
    m_book->takeWindow(QStringLiteral("spikes"));
    QTest::keyClick(table, Qt::Key_Return);
    for (QWidget *other : QApplication::topLevelWidgets())
        if (auto *dialog = qobject_cast<QDialog *>(other); dialog && dialog->isVisible()) {
            m_book->take(*dialog, QStringLiteral("explanation"));
            dialog->reject();
        }
}

void TestManualPictures::compare()
{
    m_book->showPage(WindowMode::Compare);
    QVERIFY(m_book->window().compareTrials({eight, reflections}));
    m_book->takeWindow(QStringLiteral("compare"));
}

void TestManualPictures::history()
{
    m_book->showPage(WindowMode::History);
    auto *page = m_book->window().findChild<HistoryPage *>();
    auto *table = page->findChild<QTableView *>(QStringLiteral("trials"));
    QTRY_VERIFY(table->model()->rowCount() > 3);
    table->selectRow(0);
    m_book->takeWindow(QStringLiteral("history"));
    auto *tabs = page->findChild<QTabWidget *>();
    tabs->setCurrentIndex(1);
    waitFor(m_book->window());
    m_book->takeWindow(QStringLiteral("results"));
    takeOwnMetrics(*page);
    tabs->setCurrentIndex(2);
    waitFor(m_book->window());
    for (QComboBox *box : page->findChildren<QComboBox *>())
        if (const int task = box->findText(QStringLiteral("Figure eight")); task >= 0 && box->isVisible())
            box->setCurrentIndex(task);
    m_book->takeWindow(QStringLiteral("teams"));
    tabs->setCurrentIndex(0);
    m_book->takeDialog("classes", QStringLiteral("classes"));
    m_book->takeDialog("robots", QStringLiteral("robots"));
    m_book->takeDialog("changes", QStringLiteral("changes"));
}

void TestManualPictures::takeOwnMetrics(const HistoryPage &page)
{
    Person person({[this](QDialog &dialog) {
        QTest::mouseClick(button(dialog, "Add"), Qt::LeftButton);
        auto *rows = dialog.findChild<QTableWidget *>();
        const QStringList row{QStringLiteral("energy_per_kg"), QStringLiteral("J/kg"),
                              QStringLiteral("0.5 * max_speed^2")};
        for (int column = 0; column < row.size(); ++column)
            rows->item(0, column)->setText(row.at(column));
        m_book->take(dialog, QStringLiteral("own_metrics"));
        dialog.done(QDialog::Rejected);
    }});
    named<QPushButton>(page, "Which metrics are shown")->menu()->actions().constLast()->trigger();
}

void TestManualPictures::tasks()
{
    m_book->takeDialog("tasks", QStringLiteral("tasks"));
}

void TestManualPictures::reports()
{
    showTrial(eight, 3 * second);
    m_book->takeDialog("report", QStringLiteral("report"), [this](QDialog &dialog) {
        ReportPreview &preview = dynamic_cast<ReportDialog &>(dialog).preview();
        QTRY_VERIFY_WITH_TIMEOUT(preview.isSettled() && !preview.images().isEmpty(), patienceMs);
        m_book->write(preview.images().front().scaledToWidth(900, Qt::SmoothTransformation),
                      QStringLiteral("report_page"));
    });
    m_book->showPage(WindowMode::History);
    m_book->takeDialog("report", QStringLiteral("report_class"), [](QDialog &dialog) {
        ReportPreview &preview = dynamic_cast<ReportDialog &>(dialog).preview();
        QComboBox *subject = dialog.findChildren<QComboBox *>().first();
        subject->setCurrentIndex(subject->findText(QStringLiteral("A class")));
        QTRY_VERIFY_WITH_TIMEOUT(preview.isSettled() && !preview.images().isEmpty(), patienceMs);
    });
    showTrial(eight, 3 * second);
    m_book->takeDialog("export", QStringLiteral("export"));
    m_book->takeDialog("backups", QStringLiteral("backups"));
    m_book->takeDialog("exportVideo", QStringLiteral("export_video"));
}

void TestManualPictures::preferences()
{
    m_book->takeDialog("preferences", QStringLiteral("preferences"), [this](QDialog &dialog) {
        auto *tabs = dialog.findChild<QTabWidget *>();
        tabs->setCurrentIndex(PreferencesDialog::Keys);
        m_book->take(dialog, QStringLiteral("keys"));
        tabs->setCurrentIndex(PreferencesDialog::General);
    });
    applyAppearance(*qApp, Theme::Dark);
    showTrial(eight, 3 * second);
    m_book->takeWindow(QStringLiteral("dark"));
    applyAppearance(*qApp, Theme::Light);
}

void TestManualPictures::warning()
{
    QFile broken(path(QStringLiteral("holiday.odo")));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("this is no project, and never was one");
    broken.close();
    showTrial(eight, 3 * second);
    m_book->window().beginOpening(broken.fileName().toStdString());
    QTRY_VERIFY_WITH_TIMEOUT(!m_book->window().workspace().isBusy() &&
                                 m_book->window().findChild<MessageBar *>()->isVisible(),
                             patienceMs);
    m_book->take(*m_book->window().findChild<MessageBar *>(), QStringLiteral("message"));
    auto *list = m_book->window().findChild<QAction *>(QStringLiteral("messages"));
    list->trigger();
    m_book->take(*m_book->window().findChild<MessagePanel *>(), QStringLiteral("messages"));
    list->trigger(); // the next pictures are of something else
}

/// A picture that is no longer taken, or that nobody has taken over into the manual yet.
void TestManualPictures::cleanupTestCase()
{
    if (!m_book)
        return;
    QStringList made = m_book->names(), kept;
    made.sort();
    for (const QString &file :
         QDir(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR") + QStringLiteral("/docs/manual/pictures"))
             .entryList({QStringLiteral("*.png")}))
        kept << QFileInfo(file).completeBaseName();
    kept.sort();
    m_book.reset();
    m_folder.removeRecursively();
    if (qEnvironmentVariableIsEmpty("ODOGRAPH_PICTURES"))
        QCOMPARE(made, kept);
}

ODOGRAPH_TEST(TestManualPictures, QApplication)
#include "tst_manual_pictures.moc"
