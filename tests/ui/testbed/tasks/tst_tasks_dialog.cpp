// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/task_templates.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/mnemonics.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/stored_example.h"
#include "ui/testbed/tasks/internal/part_tables.h"
#include "ui/testbed/tasks/internal/scoring_table.h"
#include "ui/testbed/tasks/internal/task_canvas.h"
#include "ui/testbed/tasks/internal/task_editor.h"
#include "ui/testbed/tasks/tasks_dialog.h"

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

TaskDraft draftOf(TaskTemplate kind)
{
    TaskDraft draft;
    draft.task.name = "Line";
    draft.task.task.kind = kind;
    draft.taken = {QStringLiteral("Taken")};
    draft.metrics = {"gate_time", "spikes"};
    return draft;
}

} // namespace

class TestTasksDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void aTemplateIsMadeAndSized();
    void gatesAreDraggedAndMovedByKeys();
    void gatesAreWrittenInTheTable();
    void zonesAreWrittenAndDragged();
    void saysWhatIsWrong();
    void aScoringIsWritten();
    void tasksAreMadeCopiedAndDeleted();
    void aCourseThatIsChangedIsToldAndMeasuredAgain();
    void aTaskIsArchivedAndRestored();
    void whatIsReadOnlyIsNotChanged();
    void everyKeyReachesOneThing();
    void everyWidgetHasAName();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
};

void TestTasksDialog::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_project = openStoredExample(m_folder->path().toStdString());
}

void TestTasksDialog::aTemplateIsMadeAndSized()
{
    TaskEditor editor(draftOf(TaskTemplate::StraightLine));
    QVERIFY(editor.problem().isEmpty());
    QCOMPARE(editor.task().task.gates.size(), std::size_t(3));
    auto *form = editor.findChild<TemplateForm *>();
    auto *kind = form->findChild<QComboBox *>();
    kind->setCurrentIndex(kind->findData(int(TaskTemplate::Circle)));
    QVERIFY(editor.task().task.kind == TaskTemplate::Circle && editor.task().task.path.closed);
    TemplateSizes sizes = form->sizes();
    sizes.lengthM = 1.2;
    form->setTemplate(TaskTemplate::Circle, sizes);
    QCOMPARE(editor.task().task.path.points.size() > 10, true);
    Q_EMIT form->changed();
    const Gate lap = editor.task().task.gates.front();
    QVERIFY(std::abs(((lap.from + lap.to) / 2 - sizes.centre).norm() - 0.6) < 1e-9);
}

void TestTasksDialog::gatesAreDraggedAndMovedByKeys()
{
    TaskEditor editor(draftOf(TaskTemplate::StraightLine));
    auto *canvas = editor.findChild<TaskCanvas *>();
    canvas->resize(600, 500);
    const auto gate = [&](std::size_t i) { return editor.task().task.gates.at(i); };
    const Gate start = gate(0);
    const QPoint middle = canvas->fromWorld((start.from + start.to) / 2).toPoint();
    QTest::mousePress(canvas, Qt::LeftButton, {}, middle);
    QTest::mouseMove(canvas, middle + QPoint(40, 0));
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, middle + QPoint(40, 0));
    QVERIFY(gate(0).from.x() > start.from.x() + 0.02);
    QVERIFY(((gate(0).to - gate(0).from) - (start.to - start.from)).norm() <
            1e-9); // moved, neither turned nor widened
    const Gate moved = gate(0);
    const QPoint end = canvas->fromWorld(moved.to).toPoint();
    QTest::mousePress(canvas, Qt::LeftButton, {}, end);
    QTest::mouseMove(canvas, end - QPoint(0, 30));
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, end - QPoint(0, 30));
    QVERIFY((gate(0).from - moved.from).norm() < 1e-9 && (gate(0).to - moved.to).norm() > 0.02);

    QTest::keyClick(canvas, Qt::Key_PageDown);
    QCOMPARE(canvas->currentGate(), 1);
    const Gate split = gate(1);
    QTest::keyClick(canvas, Qt::Key_Right);
    QVERIFY((gate(1).from - split.from - Eigen::Vector2d(0.01, 0)).norm() < 1e-9);
    QTest::keyClick(canvas, Qt::Key_Up, Qt::ControlModifier);
    QVERIFY((gate(1).to - split.to - Eigen::Vector2d(0.01, 0.001)).norm() < 1e-9);
    QTest::keyClick(canvas, Qt::Key_Plus);
    QVERIFY(std::abs((gate(1).to - gate(1).from).norm() - (split.to - split.from).norm() - 0.02) < 1e-9);
    QTest::keyClick(canvas, Qt::Key_Less);
    QVERIFY(std::abs(
                std::abs((gate(1).to - gate(1).from).normalized().dot((split.to - split.from).normalized())) -
                std::cos(5 * M_PI / 180)) < 1e-9);
    QTest::keyClick(canvas, Qt::Key_PageUp);
    QTest::keyClick(canvas, Qt::Key_PageUp);
    QCOMPARE(canvas->currentGate(), 2); // round
}

void TestTasksDialog::gatesAreWrittenInTheTable()
{
    TaskEditor editor(draftOf(TaskTemplate::Free));
    auto *table = named<QTableWidget>(editor, "Gates in passing order");
    QCOMPARE(table->rowCount(), 2);
    table->item(0, 0)->setText(QStringLiteral("Here"));
    table->item(0, 2)->setText(QStringLiteral("1250.5"));
    QCOMPARE(editor.task().task.gates[0].name, std::string("Here"));
    QVERIFY(std::abs(editor.task().task.gates[0].from.x() - 1.2505) < 1e-9);
    auto *role = qobject_cast<QComboBox *>(table->cellWidget(1, 1));
    role->setCurrentIndex(role->findText(QStringLiteral("split")));
    Q_EMIT role->activated(role->currentIndex());
    QVERIFY(editor.task().task.gates[1].role == GateRole::Split);
    button(editor, "&Add gate")->click();
    QCOMPARE(editor.task().task.gates.size(), std::size_t(3));
    const Gate before = editor.task().task.gates[1];
    button(editor, "Reverse direction")->click();
    QVERIFY(editor.task().task.gates[1].from == before.to);
    button(editor, "Remove")->click();
    QCOMPARE(editor.task().task.gates.size(), std::size_t(2));
}

void TestTasksDialog::zonesAreWrittenAndDragged()
{
    TaskEditor editor(draftOf(TaskTemplate::StraightLine));
    const auto zone = [&](std::size_t i) { return editor.task().task.zones.at(i); };
    button(editor, "Add zone to sta&y in")->click();
    button(editor, "Add zone to &keep out of")->click();
    QVERIFY(zone(0).rule == ZoneRule::StayInside && zone(1).rule == ZoneRule::StayOutside);
    QVERIFY(editor.problem().isEmpty());
    auto *table = named<QTableWidget>(editor, "Zones of the floor");
    table->item(1, 0)->setText(QStringLiteral("Pond"));
    table->item(1, 2)->setText(QStringLiteral("500 500; 900, 500; 900 900.5")); // as people write lists
    QCOMPARE(zone(1).name, std::string("Pond"));
    QCOMPARE(zone(1).corners, (std::vector<Eigen::Vector2d>{{0.5, 0.5}, {0.9, 0.5}, {0.9, 0.9005}}));
    QCOMPARE(table->item(1, 2)->text(), QStringLiteral("500 500; 900, 500; 900 900.5"));
    table->item(1, 2)->setText(QStringLiteral("500 500; 900; 900 900"));
    QVERIFY(editor.problem().startsWith(QLatin1String("zone 'Pond': its corners are not all on a floor")));
    table->item(1, 2)->setText(QStringLiteral("500 500; 900 500"));
    QVERIFY(editor.problem().startsWith(QLatin1String("zone 'Pond': it has fewer than three corners")));
    table->item(1, 2)->setText(QString());
    QVERIFY(!editor.problem().isEmpty());
    table->item(1, 0)->setText(QString());
    QCOMPARE(editor.problem(), QStringLiteral("A zone has no name."));
    table->item(1, 0)->setText(QStringLiteral("Pond"));
    table->item(1, 2)->setText(QStringLiteral("500 500; 900 500; 900 900"));
    QVERIFY(editor.problem().isEmpty());

    auto *canvas = editor.findChild<TaskCanvas *>();
    canvas->resize(600, 500);
    const Zone before = zone(1);
    const auto drag = [canvas](const QPoint &from, const QPoint &by) {
        QTest::mousePress(canvas, Qt::LeftButton, {}, from);
        QTest::mouseMove(canvas, from + by);
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, from + by);
    };
    drag(canvas->fromWorld(before.corners[2]).toPoint(), {0, -30});
    QCOMPARE(canvas->currentZone(), 1);
    QVERIFY(zone(1).corners[2].y() > 0.92 && zone(1).corners[0] == before.corners[0]);
    const Zone moved = zone(1);
    // by an edge: all of it
    drag(canvas->fromWorld((moved.corners[0] + moved.corners[1]) / 2).toPoint(), {30, 0});
    QVERIFY(((zone(1).corners[2] - zone(1).corners[0]) - (moved.corners[2] - moved.corners[0])).norm() <
            1e-9);
    QVERIFY(zone(1).corners[0].x() > moved.corners[0].x() + 0.01);
    const Zone dragged = zone(1);
    QTest::keyClick(canvas, Qt::Key_Left);
    QVERIFY((zone(1).corners[0] - dragged.corners[0] + Eigen::Vector2d(0.01, 0)).norm() < 1e-9);
    QTest::keyClick(canvas, Qt::Key_Plus);
    QVERIFY((zone(1).corners[2] - zone(1).corners[0]).norm() >
            (dragged.corners[2] - dragged.corners[0]).norm() + 0.01);
    QTest::keyClick(canvas, Qt::Key_PageDown); // round: the gates come first
    QCOMPARE(canvas->currentGate(), 0);
    QCOMPARE(canvas->currentZone(), -1);
    QTest::keyClick(canvas, Qt::Key_PageUp);
    QCOMPARE(canvas->currentZone(), 1);

    // Another template leaves them where they are.
    auto *form = editor.findChild<TemplateForm *>();
    auto *kind = form->findChild<QComboBox *>();
    kind->setCurrentIndex(kind->findData(int(TaskTemplate::Circle)));
    QCOMPARE(editor.task().task.zones.size(), std::size_t(2));
    table->setCurrentCell(0, 0);
    button(editor, "Remo&ve zone")->click();
    QCOMPARE(editor.task().task.zones.size(), std::size_t(1));
    QCOMPARE(zone(0).name, std::string("Pond"));
}

void TestTasksDialog::saysWhatIsWrong()
{
    TaskEditor editor(draftOf(TaskTemplate::StraightLine));
    QPushButton *save = button(editor, "&Save");
    auto *name = editor.findChild<QLineEdit *>();
    name->setText(QStringLiteral(" "));
    QCOMPARE(editor.problem(), QStringLiteral("The task has no name."));
    QVERIFY(!save->isEnabled());
    name->setText(QStringLiteral("Taken"));
    QCOMPARE(editor.problem(), QStringLiteral("A task with this name exists. Enter another name."));
    name->setText(QStringLiteral("Line"));
    QVERIFY(save->isEnabled());
    auto *table = named<QTableWidget>(editor, "Gates in passing order");
    table->item(0, 2)->setText(QStringLiteral("far"));
    QVERIFY(editor.problem().startsWith(QLatin1String("gate 'Start': its ends are not both on a floor")));
    table->item(0, 2)->setText(QStringLiteral("100"));
    table->item(1, 0)->setText(QStringLiteral("Start"));
    QVERIFY(editor.problem().startsWith(QLatin1String("gate 'Start': the name is used twice")));
    table->item(1, 0)->setText(QString());
    QCOMPARE(editor.problem(), QStringLiteral("A gate has no name."));
}

void TestTasksDialog::aScoringIsWritten()
{
    TaskEditor editor(draftOf(TaskTemplate::StraightLine));
    auto *scoring = editor.findChild<ScoringTable *>();
    QVERIFY(editor.scoring().empty());
    button(*scoring, "&Add line")->click();
    QVERIFY(editor.scoring() == (std::vector<Criterion>{{"gate_time", 5, 20, 10}}));
    auto *table = named<QTableWidget>(editor, "Lines of the scoring");
    table->item(0, 1)->setText(QStringLiteral("4"));
    table->item(0, 3)->setText(QStringLiteral("30"));
    QVERIFY(editor.scoring() == (std::vector<Criterion>{{"gate_time", 4, 20, 30}}));
    QVERIFY(named<QLabel>(editor, "What the lines mean")
                ->text()
                .contains(QString::fromUtf8("30 points at 4\u00a0s or less, none at 20\u00a0s or more")));
    table->item(0, 2)->setText(QStringLiteral("4"));
    QVERIFY(editor.problem().startsWith(QLatin1String("line 1 of the scoring: full points and no points")));
    button(*scoring, "Remove line")->click();
    QVERIFY(editor.problem().isEmpty() && editor.scoring().empty());
}

void TestTasksDialog::tasksAreMadeCopiedAndDeleted()
{
    TasksDialog dialog(*m_project);
    QSignalSpy changed(&dialog, &TasksDialog::changed);
    const auto count = [&] { return m_project->tasks().all()->size(); };
    const std::size_t before = count();
    {
        Person person({press}); // takes the slalom as it is
        button(dialog, "&New")->menu()->actions().at(3)->trigger();
        QVERIFY(person.isDone());
    }
    QCOMPARE(count(), before + 1);
    QVERIFY(m_project->tasks().find("Slalom")->task.kind == TaskTemplate::Slalom);
    QCOMPARE(changed.count(), 1);
    {
        Person person({press});
        button(dialog, "&Copy…")->click();
        QVERIFY(person.isDone());
    }
    QVERIFY(m_project->tasks().find("Slalom (2)").has_value());
    {
        Person person({enterText(QStringLiteral("Gymkhana"))});
        button(dialog, "&Rename…")->click();
        QVERIFY(person.isDone());
    }
    QVERIFY(m_project->tasks().find("Gymkhana").has_value());
    button(dialog, "&Delete")->click();
    QCOMPARE(count(), before + 1);
    for (QAction *action : dialog.actions())
        if (action->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_Z))
            action->trigger();
    QVERIFY(m_project->tasks().find("Gymkhana").has_value());
    QCOMPARE(QString::fromStdString(m_project->changes()->front().words.english()),
             QStringLiteral("delete task Gymkhana"));
}

void TestTasksDialog::aCourseThatIsChangedIsToldAndMeasuredAgain()
{
    TaskRecord task = *m_project->tasks().find("Figure eight, 2 laps");
    task.task = taskFromTemplate(TaskTemplate::FigureEight, {}).value();
    TasksDialog dialog(*m_project);
    QVERIFY(dialog.store(task, {{"best_lap", 4, 10, 30}}));
    QVERIFY(m_project->tasks().scoring(m_project->tasks().find(task.name)->id)->size() == 1);
    auto *table = named<QTableWidget>(dialog, "Tasks");
    QCOMPARE(table->item(table->currentRow(), 0)->text(), QString::fromStdString(task.name));
    auto *again = button(dialog, "Reanalyse &them");
    QVERIFY(!again->isHidden());
    QSignalSpy wanted(&dialog, &TasksDialog::reprocessRequested);
    again->click();
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front().front().toStringList(), QStringList(QStringLiteral("Trial 1")));
    // Used ones stay.
    TasksDialog other(*m_project);
    table = named<QTableWidget>(other, "Tasks");
    for (int row = 0; row < table->rowCount(); ++row)
        if (table->item(row, 0)->text() == QString::fromStdString(task.name))
            table->setCurrentCell(row, 0);
    QVERIFY(!button(other, "&Delete")->isEnabled());
    QVERIFY(!other.store({task.id + 99, "Nowhere", {}}, {}));
}

void TestTasksDialog::aTaskIsArchivedAndRestored()
{
    TasksDialog dialog(*m_project);
    QSignalSpy changed(&dialog, &TasksDialog::changed);
    auto *table = named<QTableWidget>(dialog, "Tasks");
    auto *showArchived = dialog.findChild<QCheckBox *>();
    QVERIFY(showArchived->isHidden()); // there is none
    const int before = table->rowCount();
    const QString name = table->item(0, 0)->text();
    table->setCurrentCell(0, 0);
    button(dialog, "&Archive")->click();
    QCOMPARE(changed.count(), 1);
    QVERIFY(m_project->tasks().find(name.toStdString())->archived);
    QCOMPARE(table->rowCount(), before - 1);
    QVERIFY(!showArchived->isHidden());
    showArchived->setChecked(true);
    QCOMPARE(table->rowCount(), before);
    table->setCurrentCell(0, 0);
    QCOMPARE(table->item(0, 0)->text(), name);
    QVERIFY2(table->item(0, 2)->text().endsWith(QStringLiteral(", archived")),
             qPrintable(table->item(0, 2)->text()));
    button(dialog, "Restore from &archive")->click();
    QVERIFY(!m_project->tasks().find(name.toStdString())->archived);
    for (QAction *action : dialog.actions())
        if (action->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_Z))
            action->trigger();
    QVERIFY(m_project->tasks().find(name.toStdString())->archived);
}

void TestTasksDialog::whatIsReadOnlyIsNotChanged()
{
    TasksDialog dialog(*m_project, true);
    for (const char *text : {"&New", "&Edit…", "&Copy…", "&Rename…", "&Archive", "&Delete"})
        QVERIFY(!button(dialog, text)->isEnabled());
}

void TestTasksDialog::everyKeyReachesOneThing()
{
    for (const TaskTemplate kind : {TaskTemplate::StraightLine, TaskTemplate::Circle,
                                    TaskTemplate::FigureEight, TaskTemplate::Slalom, TaskTemplate::Free}) {
        TaskEditor editor(draftOf(kind));
        for (int tab = 0; tab < 2; ++tab) {
            editor.findChild<QTabWidget *>()->setCurrentIndex(tab);
            const QStringList shared = sharedMnemonics(editor);
            QVERIFY2(shared.isEmpty(), qPrintable(shared.join(u'\n')));
        }
    }
    TasksDialog dialog(*m_project);
    QVERIFY2(sharedMnemonics(dialog).isEmpty(), qPrintable(sharedMnemonics(dialog).join(u'\n')));
}

void TestTasksDialog::everyWidgetHasAName()
{
    TaskEditor editor(draftOf(TaskTemplate::Slalom));
    TasksDialog dialog(*m_project);
    for (const QWidget *window : std::initializer_list<const QWidget *>{&editor, &dialog})
        for (QWidget *each : window->findChildren<QWidget *>()) {
            const bool isReached =
                each->focusPolicy() != Qt::NoFocus && !qobject_cast<QAbstractButton *>(each) &&
                !each->objectName().startsWith(QLatin1String("qt_")) && !qobject_cast<QLabel *>(each);
            if (!isReached || !QAccessible::queryAccessibleInterface(each))
                continue;
            QVERIFY2(
                !QAccessible::queryAccessibleInterface(each)->text(QAccessible::Name).isEmpty() ||
                    each->parentWidget()->inherits("QAbstractSpinBox") || each->inherits("QTabBar") ||
                    each->inherits("QTabWidget") || each->inherits("QHeaderView"),
                qPrintable(QString::fromLatin1(each->metaObject()->className()) + u' ' + each->objectName()));
        }
}

ODOGRAPH_TEST(TestTasksDialog, QApplication)
#include "tst_tasks_dialog.moc"
