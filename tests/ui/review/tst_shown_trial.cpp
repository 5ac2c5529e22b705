// SPDX-License-Identifier: GPL-3.0-or-later
// Which trial Review shows, while others are chosen, binned or cannot be read.
#include "core/project/internal/connection.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"
#include "ui/models/timeline.h"
#include "ui/review/review_page.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestShownTrial : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        const auto made = storeExample(m_folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_file = *made;
        m_project = std::move(*Project::open(m_file, Project::Access::ReadWrite));
    }
    void init()
    {
        m_page = std::make_unique<ReviewPage>(*m_project);
        connect(m_page.get(), &ReviewPage::trialShown, m_page.get(), [this] { m_shown << shown(); });
        m_page->refresh();
        QTRY_VERIFY(m_page->scene());
        m_shown.clear();
    }

    void theNewestIsShownAtFirst()
    {
        QCOMPARE(shown(), QStringLiteral("Trial 1"));
        QCOMPARE(m_page->trial(), QStringLiteral("Trial 1"));
        QCOMPARE(list()->count(), 3);
        QCOMPARE(list()->currentText(), QStringLiteral("Trial 1 · Falcon"));
    }

    void aTrialClickedAwayNeverAppears()
    {
        QVERIFY(m_page->showTrial(QStringLiteral("Trial 2")));
        QCoreApplication::sendPostedEvents(); // it is being read now
        QCOMPARE(m_page->trial(), QStringLiteral("Trial 2"));
        QCOMPARE(shown(), QStringLiteral("Trial 1"));
        QVERIFY(m_page->showTrial(QStringLiteral("Trial 3")));
        QTRY_COMPARE(m_shown, QStringList(QStringLiteral("Trial 3")));
        QVERIFY(m_page->showTrial(QStringLiteral("Trial 1")));
        QTRY_COMPARE(m_shown.size(), 2);
        QCOMPARE(m_shown.back(), QStringLiteral("Trial 1"));
    }

    void spacePlaysAfterAListWasChosenFromByMouse()
    {
        m_page->resize(1200, 800);
        m_page->show();
        m_page->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_page.get()));
        m_page->setFocus();
        int lists = 0;
        for (QComboBox *each : m_page->findChildren<QComboBox *>()) {
            if (!each->isVisible())
                continue;
            ++lists;
            QTest::mouseClick(each, Qt::LeftButton);
            QTest::keyClick(each->view(), Qt::Key_Return);
            QVERIFY2(QApplication::focusWidget() != each, qPrintable(each->accessibleName()));
            QVERIFY(each->focusPolicy() & Qt::TabFocus); // it is reached by keys all the same
        }
        QVERIFY(lists >= 4); // of trials, what the map and two charts show
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QVERIFY(m_page->timeline().isPlaying());
        m_page->timeline().pause();
    }

    void refusesANameThatIsNotThere()
    {
        const auto refused = m_page->showTrial(QStringLiteral("Trial 9"));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::NotFound);
        QVERIFY2(refused.error().message().find("Trial 9") != std::string::npos,
                 refused.error().message().c_str());
        QCOMPARE(m_page->trial(), QStringLiteral("Trial 1"));
    }

    void oneThatWentToTheBinGivesWayToTheNewest()
    {
        QVERIFY(m_page->showTrial(QStringLiteral("Trial 2")));
        QTRY_COMPARE(shown(), QStringLiteral("Trial 2"));
        setBinned("Trial 2", true);
        m_page->refresh();
        QTRY_COMPARE(shown(), QStringLiteral("Trial 1"));
        QCOMPARE(list()->count(), 2);
        // In the bin it can still be looked at.
        QVERIFY(m_page->showTrial(QStringLiteral("Trial 2")));
        m_page->refresh();
        QTRY_COMPARE(shown(), QStringLiteral("Trial 2"));
        setBinned("Trial 2", false);
    }

    void withoutTrialsThereIsNone()
    {
        for (const char *name : {"Trial 1", "Trial 2", "Trial 3"})
            setBinned(name, true);
        m_page->refresh();
        QTRY_VERIFY(!m_page->scene());
        QCOMPARE(m_page->trial(), QString());
        for (const char *name : {"Trial 1", "Trial 2", "Trial 3"})
            setBinned(name, false);
    }

    void whatIsShownStaysWhenAnotherCannotBeRead()
    {
        const auto trial = m_project->trials().find("Trial 2");
        const auto connection = ProjectConnection::open(m_file, DatabaseAccess::ReadWrite);
        QVERIFY((*connection)
                    ->execute(QStringLiteral("UPDATE analysis_chunk SET samples=x'00' WHERE analysis_id IN "
                                             "(SELECT id FROM analysis WHERE trial_id=%1)")
                                  .arg(trial->id)));
        QSignalSpy failed(m_page.get(), &ReviewPage::failed);
        QVERIFY(m_page->showTrial(QStringLiteral("Trial 2")));
        QTRY_COMPARE(failed.count(), 1);
        const auto error = failed.front().front().value<Error>();
        QVERIFY2(error.message().find("restore it from a backup copy") != std::string::npos,
                 error.message().c_str());
        QCOMPARE(shown(), QStringLiteral("Trial 1"));
        QCOMPARE(list()->currentText(), QStringLiteral("Trial 1 · Falcon"));
    }

private:
    const QComboBox *list() const
    {
        for (const QComboBox *each : m_page->findChildren<QComboBox *>())
            if (each->accessibleName() == QLatin1String("Trial"))
                return each;
        return nullptr;
    }
    QString shown() const
    {
        return m_page->scene() ? QString::fromStdString(m_page->scene()->trial.name) : QString();
    }
    void setBinned(const char *name, bool binned)
    {
        TrialRepository &trials = m_project->trials();
        QVERIFY(trials.setBinned(trials.find(name)->id, binned));
    }

    QTemporaryDir m_folder;
    std::filesystem::path m_file;
    std::unique_ptr<Project> m_project;
    std::unique_ptr<ReviewPage> m_page;
    QStringList m_shown;
};

ODOGRAPH_TEST(TestShownTrial, QApplication)
#include "tst_shown_trial.moc"
