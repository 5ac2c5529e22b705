// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/verdict_repository.h"
#include "core/workflow/media_upkeep.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/project_content.h"
#include "tests/ui/support/stored_example.h"
#include "ui/history/history_page.h"
#include "ui/history/internal/mark_actions.h"
#include "ui/history/internal/teams_panel.h"
#include "ui/history/internal/trial_list.h"
#include "ui/models/results.h"
#include "ui/models/trial_model.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

using namespace odo;

namespace {

QComboBox *choice(const QWidget &page, const char *name)
{
    for (QComboBox *box : page.findChildren<QComboBox *>())
        if (box->accessibleName() == QLatin1String(name))
            return box;
    qFatal("no choice of %s", name);
}

} // namespace

class TestHistoryPage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void searchesAsYouType();
    void opensByEnterAndDoubleClick();
    void savesNotesAtOnce();
    void comparesWhatIsSelected();
    void marksTakeEffectAndAreTakenBack();
    void aTrialGoesWhileItIsBeingWrittenAbout();
    void tagsAreWrittenInPlace();
    void cellsAreEditedInPlace();
    void chosenColumnsAreShown();
    void theSelectionFollowsNewNames();
    void theBinIsEmptiedForGood();
    void verdictsAreComputedShownAndFiltered();
    void showsHowTeamsStand();
    void readsThousandsPieceByPiece();
    void whatIsReadOnlyIsNotMarked();
    void saysWhenThereIsNothing();
    void fitsIntoLittle();

private:
    /// A copy that a test may change.
    std::unique_ptr<Project> copy(const QString &name);
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

void TestHistoryPage::initTestCase()
{
    m_project = openStoredExample(m_folder.path().toStdString());
}

/// Where it is narrow the buttons have their icons alone; what is known of a trial is beside the list of
/// trials only.
void TestHistoryPage::fitsIntoLittle()
{
    HistoryPage page(*m_project);
    page.refresh();
    page.resize(1500, 600);
    page.show();
    auto *doubtful = page.findChild<QToolButton *>(QStringLiteral("doubtfulOnly"));
    QCOMPARE(doubtful->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    const int least = page.minimumSizeHint().width();
    QVERIFY2(least < 900, qPrintable(QString::number(least)));
    page.resize(least, 600);
    QTRY_COMPARE(doubtful->toolButtonStyle(), Qt::ToolButtonIconOnly);
    QCOMPARE(page.width(), least);
    page.resize(1500, 600);
    QTRY_COMPARE(doubtful->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    auto *detail = page.findChild<TrialDetail *>();
    QVERIFY(detail->isVisible());
    page.findChild<QTabWidget *>()->setCurrentIndex(1);
    QVERIFY(!detail->isVisible());
    page.findChild<QTabWidget *>()->setCurrentIndex(0);
    QVERIFY(detail->isVisible());
}

void TestHistoryPage::searchesAsYouType()
{
    HistoryPage page(*m_project);
    page.refresh();
    auto *table = page.findChild<QTableView *>(QStringLiteral("trials"));
    QCOMPARE(table->model()->rowCount(), 3);
    auto *search = page.findChild<QLineEdit *>(QStringLiteral("search"));
    QTest::keyClicks(search, QStringLiteral("heron"));
    QCOMPARE(table->model()->rowCount(), 1);
    QCOMPARE(table->model()->index(0, 0).data().toString(), QStringLiteral("Trial 2"));
    QTest::keyClicks(search, QStringLiteral(" nobody"));
    QCOMPARE(table->model()->rowCount(), 0);
    QVERIFY(!page.findChild<QPlainTextEdit *>()->isEnabled());
    search->clear();
    QCOMPARE(table->model()->rowCount(), 3);
}

void TestHistoryPage::opensByEnterAndDoubleClick()
{
    HistoryPage page(*m_project);
    page.refresh();
    page.selectTrial(QStringLiteral("Trial 2"));
    QSignalSpy chosen(&page, &HistoryPage::trialChosen);
    auto *table = page.findChild<QTableView *>(QStringLiteral("trials"));
    QTest::keyClick(table, Qt::Key_Return);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen.front().front().toString(), QStringLiteral("Trial 2"));
    Q_EMIT table->doubleClicked(table->currentIndex());
    QCOMPARE(chosen.count(), 2);
}

void TestHistoryPage::savesNotesAtOnce()
{
    HistoryPage page(*m_project);
    page.refresh();
    page.selectTrial(QStringLiteral("Trial 2"));
    auto *notes = page.findChild<QPlainTextEdit *>();
    QSignalSpy changed(&page, &HistoryPage::notesChanged);
    QTest::keyClicks(notes, QStringLiteral("slipped twice"));
    page.selectTrial(QStringLiteral("Trial 1")); // saves without waiting for the pause
    QCOMPARE(changed.count(), 1);
    QCOMPARE(m_project->trials().find("Trial 2")->notes, std::string("slipped twice"));
    QCOMPARE(m_project->trials().find("Trial 1")->notes, std::string("New wheels since trial 2."));
    QCOMPARE(notes->toPlainText(), QStringLiteral("New wheels since trial 2."));
    notes->appendPlainText(QStringLiteral("And a new motor."));
    QTRY_COMPARE(changed.count(), 2);
    QVERIFY(
        QString::fromStdString(m_project->trials().find("Trial 1")->notes).endsWith(QLatin1String("motor.")));
}

std::unique_ptr<Project> TestHistoryPage::copy(const QString &name)
{
    const auto file = std::filesystem::path(m_folder.filePath(name).toStdString());
    if (const auto saved = m_project->saveCopy(file); !saved)
        qFatal("%s", saved.error().message().c_str());
    return std::move(*Project::open(file, Project::Access::ReadWrite));
}

void TestHistoryPage::comparesWhatIsSelected()
{
    HistoryPage page(*m_project);
    page.refresh();
    page.selectTrial(QStringLiteral("Trial 2"));
    QPushButton *compare = test::button(page, "Compare");
    QVERIFY(!compare->isEnabled()); // one trial is not enough
    QSignalSpy wanted(&page, &HistoryPage::compareRequested);
    page.findChild<QTableView *>(QStringLiteral("trials"))->selectAll();
    QVERIFY(compare->isEnabled());
    compare->click();
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front().front().toStringList(), // the newest on top
             QStringList({QStringLiteral("Trial 1"), QStringLiteral("Trial 2"), QStringLiteral("Trial 3")}));
}

void TestHistoryPage::marksTakeEffectAndAreTakenBack()
{
    const auto project = copy(QStringLiteral("marks.odo"));
    const QStringList before = contentOf(*project);
    HistoryPage page(*project);
    page.refresh();
    auto *table = page.findChild<QTableView *>(QStringLiteral("trials"));
    page.selectTrial(QStringLiteral("Trial 2"));
    auto *marks = page.findChild<MarkActions *>();
    QSignalSpy changed(&page, &HistoryPage::trialsChanged);

    marks->star()->trigger();
    QVERIFY(project->trials().find("Trial 2")->starred);
    QCOMPARE(project->undoWords().english(), std::string("star Trial 2"));
    QCOMPARE(marks->star()->text(), QStringLiteral("Remove &star"));
    QCOMPARE(changed.count(), 0); // nobody else shows stars

    marks->bin()->trigger();
    QVERIFY(project->trials().find("Trial 2")->binned);
    QCOMPARE(table->model()->rowCount(), 2);
    QCOMPARE(changed.count(), 1);
    auto *place = choice(page, "Where");
    place->setCurrentIndex(2);
    QCOMPARE(table->model()->rowCount(), 1);
    QCOMPARE(marks->bin()->text(), QStringLiteral("Rest&ore"));
    place->setCurrentIndex(0);

    table->selectAll();
    marks->archive()->trigger();
    QCOMPARE(table->model()->rowCount(), 0);
    QCOMPARE(project->undoWords().english(), std::string("archive 2 trials"));

    for (int i = 0; i < 3; ++i)
        QVERIFY(project->undo());
    QCOMPARE(contentOf(*project), before);
    page.refresh();
    QCOMPARE(table->model()->rowCount(), 3);
}

void TestHistoryPage::aTrialGoesWhileItIsBeingWrittenAbout()
{
    const auto project = copy(QStringLiteral("written.odo"));
    HistoryPage page(*project);
    page.show();
    page.refresh();
    auto *table = page.findChild<QTableView *>(QStringLiteral("trials"));
    const QAbstractItemModelTester tester(table->model(),
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    page.selectTrial(QStringLiteral("Trial 2"));
    page.findChild<QPlainTextEdit *>()->setPlainText(QStringLiteral("wheel lost")); // is stored after a pause
    table->setCurrentIndex(table->currentIndex().siblingAtColumn(TrialModel::TagsColumn));
    table->edit(table->currentIndex());
    auto *tags = table->viewport()->findChild<QLineEdit *>();
    QVERIFY(tags);
    tags->setText(QStringLiteral("wet floor")); // is stored when something else is chosen
    page.findChild<MarkActions *>()->bin()->trigger();
    const auto binned = project->trials().find("Trial 2");
    QVERIFY(binned->binned);
    QCOMPARE(binned->notes, std::string("wheel lost"));
    QCOMPARE(binned->tags, std::vector<std::string>{"wet floor"});
    QCOMPARE(table->model()->rowCount(), 2);
    QCOMPARE(table->model()->index(0, 0).data(TrialModel::NameRole).toString(), QStringLiteral("Trial 1"));
    QCOMPARE(table->model()->index(1, 0).data(TrialModel::NameRole).toString(), QStringLiteral("Trial 3"));
}

void TestHistoryPage::tagsAreWrittenInPlace()
{
    const auto project = copy(QStringLiteral("tags.odo"));
    HistoryPage page(*project);
    page.refresh();
    page.selectTrial(QStringLiteral("Trial 1"));
    QAbstractItemModel *model = page.findChild<QTableView *>(QStringLiteral("trials"))->model();
    const QModelIndex tags = model->index(0, TrialModel::TagsColumn);
    QVERIFY(model->setData(tags, QStringLiteral("wet floor, final")));
    QCOMPARE(project->trials().find("Trial 1")->tags, (std::vector<std::string>{"final", "wet floor"}));
    QCOMPARE(tags.data().toString(), QStringLiteral("final, wet floor"));

    QSignalSpy opened(&page, &HistoryPage::trialChosen);
    auto *table = page.findChild<QTableView *>(QStringLiteral("trials"));
    table->setCurrentIndex(tags);
    table->edit(tags);
    auto *editor = table->viewport()->findChild<QLineEdit *>();
    editor->setText(QStringLiteral("wet floor"));
    page.findChild<QPlainTextEdit *>()->setPlainText(QStringLiteral("wheel lost"));
    page.saveNotes(); // as the pause does after which they are stored
    QCOMPARE(project->trials().find("Trial 1")->notes, std::string("wheel lost"));
    QCOMPARE(editor->text(), QStringLiteral("wet floor"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(tags.data().toString(), QStringLiteral("wet floor"));
    QCOMPARE(opened.count(), 0);

    QTest::keyClicks(page.findChild<QLineEdit *>(QStringLiteral("search")), QStringLiteral("wet"));
    QCOMPARE(model->rowCount(), 1);
    QSignalSpy failed(&page, &HistoryPage::failed);
    model->setData(model->index(0, TrialModel::TagsColumn), QString(300, u'x'));
    QCOMPARE(failed.count(), 1);
    QCOMPARE(project->trials().find("Trial 1")->tags.size(), std::size_t(1));
}

void TestHistoryPage::cellsAreEditedInPlace()
{
    const auto project = copy(QStringLiteral("cells.odo"));
    HistoryPage page(*project);
    page.refresh();
    page.selectTrial(QStringLiteral("Trial 2"));
    auto *table = page.findChild<QTableView *>(QStringLiteral("trials"));
    QSignalSpy opened(&page, &HistoryPage::trialChosen), changed(&page, &HistoryPage::trialsChanged),
        failed(&page, &HistoryPage::failed);
    const auto writeByF2 = [table](int column, const QString &text) {
        table->setCurrentIndex(table->currentIndex().siblingAtColumn(column));
        QTest::keyClick(table, Qt::Key_F2);
        auto *editor = table->viewport()->findChild<QLineEdit *>();
        QVERIFY(editor);
        editor->setText(text);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(!table->viewport()->findChild<QLineEdit *>());
    };
    writeByF2(TrialModel::NameColumn, QStringLiteral("Final"));
    QVERIFY(project->trials().find("Final"));
    QCOMPARE(table->currentIndex().data(TrialModel::NameRole).toString(), QStringLiteral("Final"));
    QCOMPARE(changed.count(), 1);
    writeByF2(TrialModel::TeamColumn, QStringLiteral("Falcon"));
    QCOMPARE(project->trials().find("Final")->teamName, std::string("Falcon"));
    const std::string task = project->trials().find("Final")->task;
    writeByF2(TrialModel::TaskColumn, QStringLiteral("Slalom")); // there is no such task
    QCOMPARE(failed.count(), 1);
    QCOMPARE(project->trials().find("Final")->task, task);
    QVERIFY(project->undo());
    QCOMPARE(project->trials().find("Final")->teamName, std::string("Heron"));

    // A double click opens the trial, as it does on every cell that is not written often.
    page.resize(1200, 600);
    page.show();
    const auto doubleClick = [table](int column) {
        const QPoint at = table->visualRect(table->currentIndex().siblingAtColumn(column)).center();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, at);
    };
    doubleClick(TrialModel::NameColumn);
    QCOMPARE(opened.count(), 1);
    QVERIFY(!table->viewport()->findChild<QLineEdit *>());
    doubleClick(TrialModel::TagsColumn);
    QCOMPARE(opened.count(), 1);
    QVERIFY(table->viewport()->findChild<QLineEdit *>());
}

void TestHistoryPage::chosenColumnsAreShown()
{
    const auto project = copy(QStringLiteral("columns.odo"));
    QVERIFY(project->trials().setVariables(project->trials().find("Trial 1")->id, {{"surface", "wood"}}));
    const auto choose = [](const HistoryPage &page, const char *column) {
        for (QMenu *menu : page.findChildren<QMenu *>()) {
            Q_EMIT menu->aboutToShow();
            for (QAction *action : menu->actions())
                if (action->text() == QLatin1String(column))
                    action->trigger();
        }
    };
    const auto isHidden = [](const HistoryPage &page, int column) {
        return page.findChild<QTableView *>(QStringLiteral("trials"))->isColumnHidden(column);
    };
    {
        HistoryPage page(*project);
        page.refresh();
        QVERIFY(isHidden(page, TrialModel::NotesColumn) && isHidden(page, TrialModel::ColumnCount));
        choose(page, "surface");
        QVERIFY(isHidden(page, TrialModel::NotesColumn) && !isHidden(page, TrialModel::ColumnCount));
    }
    HistoryPage page(*project); // it is remembered
    page.refresh();
    QVERIFY(isHidden(page, TrialModel::NotesColumn) && !isHidden(page, TrialModel::ColumnCount));
    choose(page, "surface");
    QVERIFY(isHidden(page, TrialModel::ColumnCount));
}

void TestHistoryPage::theSelectionFollowsNewNames()
{
    const auto project = copy(QStringLiteral("renamed.odo"));
    HistoryPage page(*project);
    page.refresh();
    page.selectTrial(QStringLiteral("Trial 3"));
    auto *table = page.findChild<QTableView *>(QStringLiteral("trials"));
    table->selectionModel()->select(table->model()->index(0, 0),
                                    QItemSelectionModel::Select | QItemSelectionModel::Rows);
    QCOMPARE(page.selectedTrials(), (QStringList{QStringLiteral("Trial 1"), QStringLiteral("Trial 3")}));
    QSignalSpy selected(&page, &HistoryPage::selectionChanged);
    QVERIFY(project->trials().setName(project->trials().find("Trial 3")->id, "Z"));
    page.refresh();
    QCOMPARE(page.selectedTrials(), (QStringList{QStringLiteral("Trial 1"), QStringLiteral("Z")}));
    QCOMPARE(selected.back().front().toStringList(), page.selectedTrials());
}

void TestHistoryPage::theBinIsEmptiedForGood()
{
    const auto project = copy(QStringLiteral("bin.odo"));
    QVERIFY(project->trials().setBinned(project->trials().find("Trial 3")->id, true));
    HistoryPage page(*project);
    page.refresh();
    auto *marks = page.findChild<MarkActions *>();
    QVERIFY(!marks->emptyBin()->isEnabled()); // not while other trials are shown
    choice(page, "Where")->setCurrentIndex(2);
    {
        Person person({[](QDialog &dialog) { dialog.reject(); }});
        marks->emptyBin()->trigger();
        QVERIFY(person.isDone());
    }
    QCOMPARE(project->trials().all()->size(), std::size_t(3));
    std::optional<BinContent> wanted;
    connect(&page, &HistoryPage::emptyBinRequested, this,
            [&](const BinContent &content) { wanted = content; });
    Person person({[](QDialog &dialog) {
        for (QAbstractButton *button : dialog.findChildren<QAbstractButton *>())
            if (button->text() == QLatin1String("&Remove for good"))
                button->click();
    }});
    marks->emptyBin()->trigger();
    QVERIFY(person.isDone());
    QVERIFY(wanted && wanted->trials.size() == 1 && wanted->trials.front().name == "Trial 3");
}

/// The example has none stored, as projects of older formats.
void TestHistoryPage::verdictsAreComputedShownAndFiltered()
{
    const auto project = copy(QStringLiteral("verdicts.odo"));
    auto trial = *project->trials().find("Trial 2");
    auto views = *project->trials().recordings(trial.id);
    trial.syncMethod = views[1].syncMethod = "none";
    QVERIFY(project->trials().setSync(trial, views));
    HistoryPage page(*project);
    page.refresh();
    QTRY_VERIFY(page.isSettled());
    auto *table = page.findChild<QTableView *>(QStringLiteral("trials"));
    const auto cell = [&](int row, int role = Qt::DisplayRole) {
        return table->model()->index(row, TrialModel::VerdictColumn).data(role).toString();
    };
    QCOMPARE(cell(1), QStringLiteral("✕ bad"));
    QVERIFY(cell(1, Qt::ToolTipRole).contains(QStringLiteral("synchronised")));
    QVERIFY(cell(2).isEmpty()); // not analysed
    QVERIFY(project->verdicts().missing(Instant::min(), Instant::max())->empty());

    auto *filter = page.findChild<QToolButton *>(QStringLiteral("doubtfulOnly"));
    filter->setChecked(true);
    const auto names = [&] {
        QStringList shown;
        for (int row = 0; row < table->model()->rowCount(); ++row)
            shown << table->model()->index(row, 0).data(TrialModel::NameRole).toString();
        return shown;
    };
    QVERIFY(names().contains(QStringLiteral("Trial 2")));
    QVERIFY(!names().contains(QStringLiteral("Trial 3")));
    filter->setChecked(false);
    QCOMPARE(names().size(), 3);
    table->sortByColumn(TrialModel::VerdictColumn, Qt::DescendingOrder);
    QCOMPARE(names().front(), QStringLiteral("Trial 2")); // the worst first
}

void TestHistoryPage::showsHowTeamsStand()
{
    HistoryPage page(*m_project);
    page.refresh();
    page.findChild<QTabWidget *>()->setCurrentWidget(page.findChild<TeamsPanel *>());
    QVERIFY(!page.isSettled()); // it is read elsewhere
    QTRY_VERIFY(page.isSettled());
    auto *panel = page.findChild<TeamsPanel *>();
    auto *model = panel->findChild<QTableView *>()->model();
    QCOMPARE(model->rowCount(), 1); // one task is chosen
    QCOMPARE(model->index(0, StandingsModel::RankColumn).data().toString(), QStringLiteral("1"));
    QCOMPARE(model->index(0, StandingsModel::ProgressColumn).data().toString(),
             QStringLiteral("needs three trials at different times"));
    choice(*panel, "Task")->setCurrentIndex(0); // any
    QTRY_VERIFY(page.isSettled());
    QCOMPARE(model->rowCount(), 2); // Falcon and Heron have a tracked trial each
    QCOMPARE(model->index(0, StandingsModel::RankColumn).data().toString(), QStringLiteral("\u2013"));
    QCOMPARE(model->index(0, StandingsModel::ProgressColumn).data().toString(),
             QStringLiteral("choose a task"));
    auto *chart = panel->findChild<TrendChart *>();
    QVERIFY(chart->accessibleDescription().contains(panel->findChild<QTableView *>()
                                                        ->currentIndex()
                                                        .siblingAtColumn(StandingsModel::TeamColumn)
                                                        .data()
                                                        .toString()));
    choice(*panel, "Task")
        ->setCurrentIndex(choice(*panel, "Task")->findText(QStringLiteral("Figure eight, 2 laps")));
    QTRY_VERIFY(page.isSettled());
    QCOMPARE(model->rowCount(), 1);
    QCOMPARE(model->index(0, StandingsModel::TeamColumn).data().toString(), QStringLiteral("Falcon"));
    choice(*panel, "Metric")->setCurrentIndex(1);
    QTRY_VERIFY(page.isSettled());
    QCOMPARE(model->rowCount(), 1);
    // A task that was changed since: what was measured before does not count in it.
    const auto project = copy(QStringLiteral("standings.odo"));
    const TaskRecord task = *project->tasks().find("Figure eight, 2 laps");
    Task line;
    line.path.points = {{0, 0}, {1, 0}};
    QVERIFY(project->tasks().change({task.id, task.name, line}));
    QVERIFY(project->tasks().setScoring(project->tasks().find(task.name)->id, {{"max_speed", 1, 0, 10}}));
    HistoryPage changed(*project);
    changed.refresh();
    changed.findChild<QTabWidget *>()->setCurrentWidget(changed.findChild<TeamsPanel *>());
    QTRY_VERIFY(changed.isSettled());
    auto *standings = changed.findChild<TeamsPanel *>();
    choice(*standings, "Task")
        ->setCurrentIndex(choice(*standings, "Task")->findText(QString::fromStdString(task.name)));
    QTRY_VERIFY(changed.isSettled());
    QCOMPARE(standings->findChild<QTableView *>()->model()->rowCount(), 0);
    QCOMPARE(choice(*standings, "Metric")->itemText(0), QStringLiteral("Score"));
}

void TestHistoryPage::readsThousandsPieceByPiece()
{
    const auto project =
        std::move(*Project::create(m_folder.filePath(QStringLiteral("many.odo")).toStdString(), "Many"));
    constexpr int count = 700; // more than two pieces
    QVERIFY(project->inTransaction([&]() -> Result<void> {
        for (int i = 0; i < count; ++i) {
            TrialRecord trial;
            trial.name = "Trial " + std::to_string(i);
            trial.date = Instant(std::chrono::minutes(i));
            if (const auto added = project->trials().add(trial, {}); !added)
                return tl::unexpected(added.error());
        }
        return {};
    }));
    HistoryPage page(*project);
    QSignalSpy settled(&page, &HistoryPage::settled);
    page.refresh();
    QVERIFY(!page.isSettled());
    QAbstractItemModel *model = page.findChild<QTableView *>(QStringLiteral("trials"))->model();
    QCOMPARE(model->index(0, 0).data().toString(),
             QStringLiteral("Trial 699")); // the newest stand there at once
    page.selectTrial(QStringLiteral("Trial 650"));
    QTRY_COMPARE(settled.count(), 1);
    QCOMPARE(model->rowCount(), count);
    QCOMPARE(page.findChild<QTableView *>(QStringLiteral("trials"))
                 ->currentIndex()
                 .siblingAtColumn(0)
                 .data()
                 .toString(),
             QStringLiteral("Trial 650"));
}

void TestHistoryPage::whatIsReadOnlyIsNotMarked()
{
    HistoryPage page(*m_project, true);
    page.refresh();
    page.selectTrial(QStringLiteral("Trial 1"));
    auto *marks = page.findChild<MarkActions *>();
    for (QAction *action : {marks->star(), marks->archive(), marks->bin(), marks->emptyBin()})
        QVERIFY(!action->isEnabled());
    QAbstractItemModel *model = page.findChild<QTableView *>(QStringLiteral("trials"))->model();
    QVERIFY(!(model->index(0, TrialModel::TagsColumn).flags() & Qt::ItemIsEditable));
}

void TestHistoryPage::saysWhenThereIsNothing()
{
    const auto empty = Project::create(m_folder.filePath(QStringLiteral("empty.odo")).toStdString(), "Empty");
    QVERIFY(empty);
    HistoryPage page(**empty);
    page.refresh();
    QCOMPARE(page.findChild<QTableView *>(QStringLiteral("trials"))->model()->rowCount(), 0);
    QVERIFY(!page.findChild<QPlainTextEdit *>()->isEnabled());
}

ODOGRAPH_TEST(TestHistoryPage, QApplication)
#include "tst_history_page.moc"
