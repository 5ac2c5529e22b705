// SPDX-License-Identifier: GPL-3.0-or-later
// Older calibrations and registrations, by mouse and by keyboard, and trials that are measured again.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/cameras.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/stored_example.h"
#include "ui/testbed/check/revisions_dialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QRegularExpression>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int patienceMs = 60'000;
enum Column { KindColumn, DateColumn, VersionColumn, OriginColumn, RmsColumn, TrialsColumn, StateColumn };

} // namespace

class TestRevisionsDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void listsRevisions();
    void usesAnOlderOneByMouse();
    void usesAnOlderOneByKeysAlone();
    void registersWithANewerLens();
    void measuresAgainAndKeeps();
    void whatIsNotKeptLeavesNothing();
    void tellsWhatCannotBeMeasuredAgain();

private:
    RecordId currentRegistration();
    RecordId currentAnalysis();
    void measure(ReprocessDialog &dialog, const char *trial);

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    RecordId m_first = 0, m_second = 0; ///< registrations of camera A
    int m_projects = 0;
};

void TestRevisionsDialog::init()
{
    const QString folder = m_folder.filePath(QString::number(++m_projects));
    QVERIFY(QDir().mkpath(folder));
    m_project = openStoredExample(folder.toStdString());
    m_first = currentRegistration();
    const auto cameras = m_project->cameras().all();
    for (const CameraRecord &camera : *cameras) {
        RegistrationRecord record = *m_project->cameras().currentRegistration(camera.id).value();
        record.registration.worldFromCamera.translation.x() += 0.01;
        record.registration.verdict = foreignWords("Good: once more.");
        record.softwareVersion = "0.2";
        QVERIFY(m_project->cameras().addRegistration(record));
    }
    m_second = currentRegistration();
}

RecordId TestRevisionsDialog::currentRegistration()
{
    return m_project->cameras().currentRegistration(m_project->cameras().find("A")->id).value()->id;
}

RecordId TestRevisionsDialog::currentAnalysis()
{
    return m_project->analyses().current(m_project->trials().find("Trial 1")->id)->front().id;
}

void TestRevisionsDialog::listsRevisions()
{
    RevisionsDialog dialog(*m_project, {QStringLiteral("A"), QStringLiteral("B")}, QStringLiteral("A"));
    dialog.open();
    auto *table = named<QTableWidget>(dialog, "Revisions");
    QCOMPARE(table->rowCount(), 3); // a calibration, two registrations
    QCOMPARE(table->item(0, RmsColumn)->text(), QStringLiteral("0.21 px"));
    QCOMPARE(table->item(1, VersionColumn)->text(), QStringLiteral("0.2"));
    QCOMPARE(table->item(1, StateColumn)->text(), QStringLiteral("current"));
    QVERIFY(table->item(2, StateColumn)->text().isEmpty());
    QCOMPARE(table->item(2, TrialsColumn)->text(), QStringLiteral("Trial 1, Trial 2"));
    table->selectRow(1);
    QVERIFY(says(dialog, "Good: once more."));
    QVERIFY(says(dialog, "No trial uses it."));
    QVERIFY2(!button(dialog, "Use this one")->isEnabled(), "it is in force");
}

void TestRevisionsDialog::usesAnOlderOneByMouse()
{
    RevisionsDialog dialog(*m_project, {QStringLiteral("A")}, QStringLiteral("A"));
    dialog.open();
    named<QTableWidget>(dialog, "Revisions")->selectRow(2);
    QTest::mouseClick(button(dialog, "Use this one"), Qt::LeftButton);
    QCOMPARE(currentRegistration(), m_first);
    QVERIFY(dialog.hasChanged());
    QCOMPARE(named<QTableWidget>(dialog, "Revisions")->item(2, StateColumn)->text(),
             QStringLiteral("current"));
    QVERIFY(says(dialog, "Trials keep theirs until you reanalyse them."));
}

void TestRevisionsDialog::usesAnOlderOneByKeysAlone()
{
    RevisionsDialog dialog(*m_project, {QStringLiteral("A")}, QStringLiteral("A"));
    dialog.open();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    auto *table = named<QTableWidget>(dialog, "Revisions");
    QTRY_VERIFY(table->hasFocus());
    QTest::keyClick(table, Qt::Key_Down);
    QTest::keyClick(table, Qt::Key_Down);
    QTest::keyClick(&dialog, Qt::Key_U, Qt::AltModifier);
    QTRY_COMPARE(currentRegistration(), m_first);
    // And away without another change.
    QTest::keyClick(table, Qt::Key_Up);
    QTest::keyClick(&dialog, Qt::Key_Escape);
    QVERIFY(!dialog.isVisible());
    QCOMPARE(currentRegistration(), m_first);
}

void TestRevisionsDialog::registersWithANewerLens()
{
    RevisionsDialog dialog(*m_project, {QStringLiteral("A")}, QStringLiteral("A"));
    dialog.open();
    auto *table = named<QTableWidget>(dialog, "Revisions");
    table->selectRow(0); // the only calibration
    QTest::mouseClick(button(dialog, "Register with this calibration"), Qt::LeftButton);
    QVERIFY(says(dialog, "it already uses that calibration"));
    QVERIFY(!dialog.hasChanged());
    dialog.close();
    IntrinsicsRecord lens =
        *m_project->cameras().currentIntrinsics(m_project->cameras().find("A")->id).value();
    QVERIFY(m_project->cameras().addIntrinsics(lens));
    RevisionsDialog next(*m_project, {QStringLiteral("A")}, QStringLiteral("A"));
    next.open();
    QVERIFY(QTest::qWaitForWindowActive(&next));
    named<QTableWidget>(next, "Revisions")->selectRow(0);
    QTest::keyClick(&next, Qt::Key_R, Qt::AltModifier);
    QTRY_VERIFY(currentRegistration() > m_second);
    QVERIFY(says(next, "the same markers, with this lens calibration."));
    named<QTableWidget>(next, "Revisions")->selectRow(2);
    QVERIFY2(!button(next, "Register with this calibration")->isEnabled(), "a registration is no lens");
}

void TestRevisionsDialog::measure(ReprocessDialog &dialog, const char *trial)
{
    auto *box = dialog.findChild<QComboBox *>();
    box->setCurrentIndex(box->findData(QString::fromLatin1(trial)));
    QTest::mouseClick(button(dialog, "Reanalyse"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!dialog.isRunning() && button(dialog, "Reanalyse")->isEnabled(), patienceMs);
}

void TestRevisionsDialog::measuresAgainAndKeeps()
{
    ReprocessDialog dialog(*m_project);
    dialog.open();
    auto *box = dialog.findChild<QComboBox *>();
    QVERIFY2(box->itemText(0).contains(QStringLiteral("older registration")), "those come first");
    QVERIFY(!button(dialog, "Keep")->isEnabled());
    const RecordId before = currentAnalysis();
    measure(dialog, "Trial 1");
    QVERIFY(says(dialog, "Positions change by"));
    QVERIFY(named<QTableWidget>(dialog, "What changes")->rowCount() > 3);
    auto *changes = named<QTableWidget>(dialog, "What changes");
    for (int row = 0; row < changes->rowCount(); ++row) {
        QVERIFY2(!changes->item(row, 2)->text().endsWith(QStringLiteral(" 1")), "a bare number has no unit");
        const QString change = changes->item(row, 4)->text();
        QVERIFY2(change.isEmpty() || change == QStringLiteral("none") ||
                     change.contains(QRegularExpression(QStringLiteral("^[+−].*[1-9]"))),
                 qPrintable(change));
    }
    QCOMPARE(currentAnalysis(), before);
    QVERIFY(button(dialog, "Keep")->isEnabled());
    QTest::keyClick(&dialog, Qt::Key_K, Qt::AltModifier);
    QTRY_VERIFY(dialog.hasKept());
    QVERIFY(currentAnalysis() != before);
    QVERIFY(says(dialog, "the new analysis of Trial 1 is the current one"));
    QCOMPARE(*outdatedTrials(*m_project), std::vector<std::string>{"Trial 2"});
    QVERIFY(!box->itemText(box->findData(QStringLiteral("Trial 1"))).contains(QStringLiteral("older")));
}

void TestRevisionsDialog::whatIsNotKeptLeavesNothing()
{
    const RecordId before = currentAnalysis();
    {
        ReprocessDialog dialog(*m_project);
        dialog.open();
        measure(dialog, "Trial 1");
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QVERIFY(!dialog.isVisible());
        QVERIFY(!dialog.hasKept());
    }
    QCOMPARE(currentAnalysis(), before);
    {
        ReprocessDialog dialog(*m_project);
        dialog.open();
        QTest::mouseClick(button(dialog, "Reanalyse"), Qt::LeftButton);
        QTest::keyClick(&dialog, Qt::Key_Escape); // while it is measured
    }
    QCOMPARE(currentAnalysis(), before);
}

void TestRevisionsDialog::tellsWhatCannotBeMeasuredAgain()
{
    ReprocessDialog dialog(*m_project);
    dialog.open();
    measure(dialog, "Trial 3");
    QVERIFY(says(dialog, "it has not been tracked yet"));
    QVERIFY(!button(dialog, "Keep")->isEnabled());
}

ODOGRAPH_TEST(TestRevisionsDialog, QApplication)
#include "tst_revisions_dialog.moc"
