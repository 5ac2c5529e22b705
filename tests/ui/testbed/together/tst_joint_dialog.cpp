// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/cameras.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/stored_example.h"
#include "ui/testbed/together/joint_dialogs.h"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int patienceMs = 60'000;

} // namespace

class TestJointDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void showsWhatChangesAndThenStores();
    void anotherTapeFitsAgain();
    void tellsWhatStandsInItsWay();
    void cancelLeavesNothingBehind();

private:
    std::unique_ptr<JointDialog> open(const std::string &layout)
    {
        auto dialog = std::make_unique<JointDialog>(
            QString::fromStdString(layout),
            [this, layout](double tapeSigmaM) -> Result<std::shared_ptr<RegisterJointJob>> {
                m_tapeM = tapeSigmaM;
                auto job = std::make_shared<RegisterJointJob>(RegisterJointSettings{layout, tapeSigmaM});
                if (const auto prepared = job->prepare(*m_project); !prepared)
                    return tl::unexpected(prepared.error());
                return job;
            });
        dialog->open();
        return dialog;
    }
    /// Numbers of the registrations in force of A and B.
    std::pair<RecordId, RecordId> inForce()
    {
        const auto of = [&](const char *name) {
            return (*m_project->cameras().currentRegistration(m_project->cameras().find(name)->id))->id;
        };
        return {of("A"), of("B")};
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    double m_tapeM = 0;
};

void TestJointDialog::initTestCase()
{
    m_project = openStoredExample(m_folder.path().toStdString());
}

void TestJointDialog::showsWhatChangesAndThenStores()
{
    const auto before = inForce();
    const auto dialog = open("floor");
    auto *save = button(*dialog, "Save");
    QTRY_VERIFY_WITH_TIMEOUT(save->isEnabled(), patienceMs);
    auto *cameras = named<QTableWidget>(*dialog, "Cameras"),
         *markers = named<QTableWidget>(*dialog, "Markers");
    QCOMPARE(cameras->rowCount(), 2);
    QCOMPARE(cameras->item(0, 0)->text(), QStringLiteral("A"));
    QVERIFY(cameras->item(1, 2)->text().startsWith(QStringLiteral("±")));
    QCOMPARE(markers->rowCount(), 4);
    QCOMPARE(markers->item(0, 3)->text(), QStringLiteral("fits"));
    QCOMPARE(inForce(), before); // nothing yet
    QTest::keyClick(save, Qt::Key_Space);
    QCOMPARE(dialog->QDialog::result(), int(QDialog::Accepted));
    QVERIFY(dialog->job()->commit(*m_project));
    const auto after = inForce();
    QVERIFY(after.first > before.first && after.second > before.second);
}

void TestJointDialog::anotherTapeFitsAgain()
{
    const auto dialog = open("floor");
    auto *tape = named<QDoubleSpinBox>(*dialog, "Uncertainty of the tape measure");
    QCOMPARE(m_tapeM, 0.002);
    tape->setValue(30); // while it still fits with the first
    QTRY_VERIFY_WITH_TIMEOUT(button(*dialog, "Save")->isEnabled(), patienceMs);
    QCOMPARE(m_tapeM, 0.03);
    // Markers that were hardly measured leave the cameras less sure.
    const double loose = dialog->job()->joint().registrations.front().floorSigmaM;
    tape->setValue(1);
    QTRY_VERIFY_WITH_TIMEOUT(button(*dialog, "Save")->isEnabled(), patienceMs);
    QVERIFY(dialog->job()->joint().registrations.front().floorSigmaM < loose);
}

void TestJointDialog::tellsWhatStandsInItsWay()
{
    QVERIFY(
        m_project->layouts().add({"unused", {{"O", {0, 0}}, {"U", {1, 0}}, {"V", {0, 1}}, {"D", {1, 1}}}}));
    const auto dialog = open("unused");
    QTRY_VERIFY_WITH_TIMEOUT(
        named<QLabel>(*dialog, "Verdict")->text().contains(QStringLiteral("two are needed")), patienceMs);
    QVERIFY(!button(*dialog, "Save")->isEnabled());
}

void TestJointDialog::cancelLeavesNothingBehind()
{
    const auto before = inForce();
    const auto dialog = open("floor");
    QTest::keyClick(dialog.get(), Qt::Key_Escape);
    QCOMPARE(dialog->QDialog::result(), int(QDialog::Rejected));
    QCOMPARE(inForce(), before);
}

ODOGRAPH_TEST(TestJointDialog, QApplication)
#include "tst_joint_dialog.moc"
