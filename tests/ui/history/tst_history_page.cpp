// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/ui/support/stored_example.h"
#include "ui/history/history_page.h"
#include "ui/history/trial_detail.h"

#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestHistoryPage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void searchesAsYouType();
    void opensByEnterAndDoubleClick();
    void savesNotesAtOnce();
    void comparesWhatIsSelected();
    void saysWhenThereIsNothing();

private:
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

void TestHistoryPage::initTestCase()
{
    const auto made = storeExample(m_folder.path().toStdString());
    QVERIFY2(made, made ? "" : made.error().message().c_str());
    m_project = std::move(*Project::open(*made, Project::Access::ReadWrite));
}

void TestHistoryPage::searchesAsYouType()
{
    HistoryPage page(*m_project);
    page.refresh();
    auto *table = page.findChild<QTableView *>();
    QCOMPARE(table->model()->rowCount(), 3);
    auto *search = page.findChild<QLineEdit *>();
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
    auto *table = page.findChild<QTableView *>();
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

void TestHistoryPage::comparesWhatIsSelected()
{
    HistoryPage page(*m_project);
    page.refresh();
    page.selectTrial(QStringLiteral("Trial 2"));
    QPushButton *compare = nullptr;
    for (QPushButton *button : page.findChildren<QPushButton *>())
        if (button->text() == QLatin1String("&Compare"))
            compare = button;
    QVERIFY(compare && !compare->isEnabled()); // one trial is not enough
    QSignalSpy wanted(&page, &HistoryPage::compareRequested);
    page.findChild<QTableView *>()->selectAll();
    QVERIFY(compare->isEnabled());
    compare->click();
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front().front().toStringList(), // the newest on top
             QStringList({QStringLiteral("Trial 1"), QStringLiteral("Trial 2"), QStringLiteral("Trial 3")}));
}

void TestHistoryPage::saysWhenThereIsNothing()
{
    const auto empty = Project::create(m_folder.filePath(QStringLiteral("empty.odo")).toStdString(), "Empty");
    QVERIFY(empty);
    HistoryPage page(**empty);
    page.refresh();
    QCOMPARE(page.findChild<QTableView *>()->model()->rowCount(), 0);
    QVERIFY(!page.findChild<QPlainTextEdit *>()->isEnabled());
}

QTEST_MAIN(TestHistoryPage)
#include "tst_history_page.moc"
