// SPDX-License-Identifier: GPL-3.0-or-later
// A school day in the window, on the demo project: the roster of a class comes in, three runs are imported
// and tracked, a spike is overruled, two runs are compared, the history is searched, and the project goes
// home in one file. All the while the window answers.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/demo_lesson.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/busy_watch.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/person.h"
#include "ui/compare/compare_page.h"
#include "ui/history/history_page.h"
#include "ui/main_window/internal/import_dialogs.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/models/timeline.h"
#include "ui/review/review_page.h"
#include "ui/views/widgets/form_fields.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

const QString bench = QStringLiteral("figure-eight with reflections"); // the run with spikes

/// What the window's thread was kept busy with by itself, not by what a test does in its place.
class TestSchoolDay : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cleanup();
    void theRosterComesIn();
    void threeRunsAreImportedAndTracked();
    void aSpikeIsOverruled();
    void twoRunsAreCompared();
    void theHistoryIsSearched();
    void theProjectGoesHome();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    QString message() const { return m_window->findChild<MessageBar *>()->text(); }
    Project &project() const { return *m_window->workspace().project(); }
    void command(const char *name, const QList<Answer> &answers)
    {
        test::run(*m_window, m_window->findChild<QAction *>(QString::fromLatin1(name)), answers);
        test::waitFor(*m_window);
    }
    Answer importAnswer(const QString &trial, const QString &team, const QString &videosOf) const;

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<BusyWatch> m_watch;
};

void TestSchoolDay::initTestCase()
{
    test::beginWithoutSettings();
    QLocale::setDefault(QLocale::c());
    QVERIFY(QDir().mkpath(path(QStringLiteral("home"))));
    QVERIFY(QDir().mkpath(path(QStringLiteral("school"))));
    const QString problem = test::provideDemoLesson(path(QStringLiteral("school")));
    QVERIFY2(problem.isEmpty(), qPrintable(problem));
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1366, 768);
    m_window->show();
    QVERIFY(m_window->openProject(path(QStringLiteral("school/demo.odo")).toStdString()));
    test::waitFor(*m_window);
    m_watch = std::make_unique<BusyWatch>();
}

/// After each part of the day.
void TestSchoolDay::cleanup()
{
    if (!m_watch)
        return;
    const double busyMs = m_watch->takeLongestMs();
    qInfo("the window's thread was busy for %.1f ms at most", busyMs);
    QVERIFY2(busyMs < longestAllowedMs(), qPrintable(QString::number(busyMs)));
}

void TestSchoolDay::theRosterComesIn()
{
    QFile roster(path(QStringLiteral("roster.csv")));
    QVERIFY(roster.open(QIODevice::WriteOnly));
    roster.write("class,team,pseudonym\n10A,Badger,Team 1\n10A,Heron,Team 2\n10A,Marten,\n");
    roster.close();
    command("importRoster", {chooseFile(roster.fileName())});
    const auto classes = project().teams().classes();
    QVERIFY2(classes && std::ranges::find(*classes, std::string("10A")) != classes->end(),
             qPrintable(message()));
    QVERIFY(project().teams().find("Marten"));
}

Answer TestSchoolDay::importAnswer(const QString &trial, const QString &team, const QString &videosOf) const
{
    return [=, this](QDialog &dialog) {
        auto &import = dynamic_cast<ImportTrialDialog &>(dialog);
        import.findChildren<QLineEdit *>().at(0)->setText(trial);
        for (auto *box : import.findChildren<QComboBox *>())
            if (const int index = box->findText(team); index >= 0)
                box->setCurrentIndex(index);
        const auto of = project().trials().find(videosOf.toStdString());
        const auto recordings = project().trials().recordings(of->id);
        for (int view = 0; view < 2; ++view)
            dialog.findChildren<PathField *>().at(view)->setPath(
                textOf(project().resolve((*recordings)[std::size_t(view)])));
        press(dialog);
    };
}

void TestSchoolDay::threeRunsAreImportedAndTracked()
{
    const char *teams[] = {"Badger", "Heron", "Marten"};
    const char *videos[] = {"circle", "straight", "figure-eight"};
    const char *robots[] = {"Blue 1", "Red 2", "Green 3"};
    for (int i = 0; i < 3; ++i) {
        const QString team = QString::fromLatin1(teams[i]), trial = team + QStringLiteral(" 1");
        command("import", {importAnswer(trial, team, QString::fromLatin1(videos[i]))});
        const auto stored = project().trials().find(trial.toStdString());
        QVERIFY2(stored, qPrintable(message()));
        QCOMPARE(QString::fromStdString(stored->teamName), team);
        QTRY_COMPARE(m_window->findChild<ReviewPage *>()->trial(), trial);
        test::waitFor(*m_window);
        command("track", {[&](QDialog &dialog) {
                    auto *list = dialog.findChild<QListWidget *>();
                    for (int row = 0; row < list->count(); ++row)
                        list->item(row)->setCheckState(list->item(row)->text() == QLatin1String(robots[i])
                                                           ? Qt::Checked
                                                           : Qt::Unchecked);
                    press(dialog);
                }});
        const auto analyses = project().analyses().current(stored->id);
        QVERIFY2(analyses && !analyses->empty(), qPrintable(message()));
    }
}

void TestSchoolDay::aSpikeIsOverruled()
{
    QVERIFY(m_window->showTrial(bench.toStdString()));
    test::waitFor(*m_window);
    auto *review = m_window->findChild<ReviewPage *>();
    const auto &profile = review->scene()->robots.front().analysis->profile;
    QVERIFY(!profile.spikes.empty());
    const auto frame = profile.samples[std::size_t(profile.spikes.front().sampleIndex)].frame;
    review->timeline().setCurrentFrame(frame);
    m_window->activateWindow(); // the dialogs had it
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    review->setFocus();
    QTest::keyClick(review, Qt::Key_U);
    // It stays for some seconds only, and to settle may take longer.
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains(QStringLiteral("is used")), qPrintable(message()), 60000);
    test::waitFor(*m_window);
    const auto &samples = review->scene()->robots.front().analysis->profile.samples;
    const auto sample = std::ranges::find(samples, frame, &Sample::frame);
    QVERIFY(hasFlag(sample->flags, SampleFlag::ByHand) && !isRejected(sample->flags));
}

void TestSchoolDay::twoRunsAreCompared()
{
    m_window->showMode(MainWindow::Mode::Compare);
    test::waitFor(*m_window);
    QVERIFY(m_window->compareTrials({QStringLiteral("figure-eight"), QStringLiteral("Marten 1")}));
    test::waitFor(*m_window);
    auto *compare = m_window->findChild<ComparePage *>();
    QVERIFY(compare->scene());
    QCOMPARE(compare->scene()->runCount(), std::size_t(2));
    QTest::keyClick(compare, Qt::Key_Space); // both play
    QTRY_VERIFY(compare->timeline().currentFrame() > 5);
    QTest::keyClick(compare, Qt::Key_Space);
    test::waitFor(*m_window);
}

void TestSchoolDay::theHistoryIsSearched()
{
    m_window->showMode(MainWindow::Mode::History);
    test::waitFor(*m_window);
    auto *history = m_window->findChild<HistoryPage *>();
    auto *search = history->findChild<QLineEdit *>(QStringLiteral("search"));
    auto *table = history->findChild<QTableView *>(QStringLiteral("trials"));
    QTRY_VERIFY(table->model()->rowCount() > 3);
    const int all = table->model()->rowCount();
    QTest::keyClicks(search, QStringLiteral("heron"));
    QTRY_COMPARE(table->model()->rowCount(), 2); // a trial of the demo lesson, and the one of this day
    search->clear();
    QTRY_COMPARE(table->model()->rowCount(), all);
    QTest::keyClick(table, Qt::Key_Down);
}

void TestSchoolDay::theProjectGoesHome()
{
    const auto trials = project().trials().all()->size();
    command("pack", {chooseFile(path(QStringLiteral("lesson")))});
    QVERIFY2(message().startsWith(QStringLiteral("Project packed into ")), qPrintable(message()));
    command("unpack",
            {chooseFile(path(QStringLiteral("lesson.zip"))), chooseFile(path(QStringLiteral("home")))});
    QVERIFY(QString::fromStdString(project().file().string()).startsWith(path(QStringLiteral("home"))));
    QCOMPARE(project().trials().all()->size(), trials);
    QVERIFY(m_window->showTrial("Marten 1"));
    test::waitFor(*m_window);
    const TrialScenePtr scene = m_window->findChild<ReviewPage *>()->scene();
    QVERIFY(scene && scene->robots.front().analysis);
    for (const SceneView &view : scene->views)
        QVERIFY(std::filesystem::exists(view.file));
}

} // namespace

ODOGRAPH_TEST(TestSchoolDay, QApplication)
#include "tst_school_day.moc"
