// SPDX-License-Identifier: GPL-3.0-or-later
// A doubtful verdict is accepted where its reasons are shown, and that is withdrawn there.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/stored_example.h"
#include "ui/review/review_page.h"

#include <QApplication>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestAcceptedVerdict : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        m_project = openStoredExample(m_folder.path().toStdString());
        auto trial = *m_project->trials().find("Trial 1");
        auto views = *m_project->trials().recordings(trial.id);
        trial.syncMethod = views[1].syncMethod = "auto"; // known to more than 5 ms only
        trial.syncOffsetSigmaS = views[1].startOffsetSigmaS = 0.02;
        QVERIFY(m_project->trials().setSync(trial, views));
        auto analysis = m_project->analyses().current(trial.id)->front();
        analysis.profile.spikes.clear();
        QVERIFY(m_project->analyses().add(analysis));
    }

    void itIsAcceptedAndWithdrawn()
    {
        ReviewPage page(*m_project);
        connect(&page, &ReviewPage::changed, &page, &ReviewPage::refresh);
        QSignalSpy changed(&page, &ReviewPage::changed), failed(&page, &ReviewPage::failed);
        page.refresh();
        QTRY_VERIFY(page.scene());
        QVERIFY(!page.scene()->verdict.isSound());
        QCOMPARE(button(page)->text(), QStringLiteral("Accept…"));
        {
            Person person({[](QDialog &dialog) { dialog.reject(); }, enterText(QStringLiteral(" "))});
            button(page)->click();
            QCOMPARE(changed.count(), 0);
            button(page)->click();
            QCOMPARE(failed.count(), 1); // without a reason
            QVERIFY(person.isDone());
        }
        Person person({enterText(QStringLiteral("it drove slowly"))});
        button(page)->click();
        QVERIFY(person.isDone());
        QCOMPARE(changed.count(), 1);
        QTRY_VERIFY(page.scene()->verdict.isAccepted());
        QCOMPARE(page.scene()->verdict.acceptance->reason, std::string("it drove slowly"));
        QCOMPARE(button(page)->text(), QStringLiteral("Withdraw"));
        button(page)->click();
        QTRY_VERIFY(!page.scene()->verdict.isAccepted());
        QCOMPARE(m_project->undoWords().english(), std::string("withdraw the acceptance of Trial 1"));
    }

private:
    static QPushButton *button(const ReviewPage &page)
    {
        auto *found = page.findChild<QPushButton *>(QStringLiteral("factAction"));
        if (!found)
            qFatal("no button beside the verdict");
        return found;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestAcceptedVerdict, QApplication)
#include "tst_accepted_verdict.moc"
