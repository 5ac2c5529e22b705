// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/robots_dialog.h"
#include "ui/views/map/map_painting.h"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

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
        const auto project = openStoredExample(folder.path().toStdString());
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
        QVERIFY(after.id == before.id && !before.colour && !after.colour &&
                after.heightMode == before.heightMode);
        {
            Person person({[](QDialog &robot) {
                for (QComboBox *choice : robot.findChildren<QComboBox *>())
                    if (choice->findText(QStringLiteral("sky blue")) >= 0)
                        choice->setCurrentText(QStringLiteral("sky blue"));
                auto *footprint = robot.findChild<RobotFootprint *>();
                const QImage before = footprint->grab().toImage();
                for (QDoubleSpinBox *box : robot.findChildren<QDoubleSpinBox *>())
                    if (box->suffix() == QStringLiteral(" mm left"))
                        box->setValue(-12);
                QVERIFY(footprint->grab().toImage() != before); // the point is marked
                robot.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok)->click();
            }});
            button(dialog, "&Edit…")->click();
            QVERIFY(person.isDone());
        }
        const RobotRecord drawn = *project->robots().find("Green 4");
        QVERIFY(drawn.drawingColour == DrawingColour::SkyBlue);
        QVERIFY(drawn.referenceM.isApprox(Eigen::Vector2d(0, -0.012)));
        QVERIFY(drawn.colour == after.colour); // it is tracked by what it was
        QCOMPARE(table->item(table->currentRow(), 2)->text(), QStringLiteral("sky blue"));
        button(dialog, "&Delete")->click();
        QCOMPARE(project->robots().all()->size(), std::size_t(2));
        pressKeys(dialog, QKeySequence(Qt::CTRL | Qt::Key_Z));
        QVERIFY(project->robots().find("Green 4").has_value());
        table->setCurrentCell(0, 0);
        button(dialog, "&Delete")->click(); // it drove
        QCOMPARE(project->robots().all()->size(), std::size_t(3));
    }
};

ODOGRAPH_TEST(TestRobotsDialog, QApplication)
#include "tst_robots_dialog.moc"
