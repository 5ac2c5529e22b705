// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/robots_dialog.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

QPushButton *button(const QWidget &in, const char *text)
{
    for (QPushButton *each : in.findChildren<QPushButton *>())
        if (each->text() == QString::fromUtf8(text))
            return each;
    qFatal("no button %s", text);
}

Answer call(const QString &name)
{
    return [name](QDialog &dialog) {
        dialog.findChild<QLineEdit *>()->setText(name);
        dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok)->click();
    };
}

} // namespace

class TestRobotsDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void robotsAreAddedChangedAndDeleted()
    {
        QTemporaryDir folder;
        const auto made = storeExample(folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        const auto project = std::move(*Project::open(*made, Project::Access::ReadWrite));
        RobotsDialog dialog(*project);
        auto *table = dialog.findChild<QTableWidget *>();
        QCOMPARE(table->rowCount(), 2);
        {
            Person person({call(QStringLiteral("Green 3"))});
            button(dialog, "&Add…")->click();
            QVERIFY(person.isDone());
        }
        QCOMPARE(table->item(table->currentRow(), 0)->text(), QStringLiteral("Green 3"));
        const RobotRecord before = *project->robots().find("Green 3");
        {
            Person person({call(QStringLiteral("Green 4"))});
            button(dialog, "&Edit…")->click();
            QVERIFY(person.isDone());
        }
        const RobotRecord after = *project->robots().find("Green 4");
        QVERIFY(after.id == before.id && after.colour.toString() == before.colour.toString() &&
                after.heightMode == before.heightMode);
        {
            Person person({[](QDialog &robot) {
                for (QComboBox *choice : robot.findChildren<QComboBox *>())
                    if (choice->findText(QStringLiteral("sky blue")) >= 0)
                        choice->setCurrentText(QStringLiteral("sky blue"));
                robot.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok)->click();
            }});
            button(dialog, "&Edit…")->click();
            QVERIFY(person.isDone());
        }
        const RobotRecord drawn = *project->robots().find("Green 4");
        QVERIFY(drawn.drawingColour == DrawingColour::SkyBlue);
        QCOMPARE(drawn.colour.toString(), after.colour.toString()); // it is tracked by what it was
        QCOMPARE(table->item(table->currentRow(), 2)->text(), QStringLiteral("sky blue"));
        button(dialog, "&Delete")->click();
        QCOMPARE(project->robots().all()->size(), std::size_t(2));
        for (QAction *action : dialog.actions())
            if (action->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_Z))
                action->trigger();
        QVERIFY(project->robots().find("Green 4").has_value());
        table->setCurrentCell(0, 0);
        button(dialog, "&Delete")->click(); // it drove
        QCOMPARE(project->robots().all()->size(), std::size_t(3));
    }
};

QTEST_MAIN(TestRobotsDialog)
#include "tst_robots_dialog.moc"
