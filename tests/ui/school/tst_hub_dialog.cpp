// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/repositories.h"
#include "core/project/school_repository.h"
#include "tests/support/registered_test.h"
#include "tests/ui/school/hub_bench.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/person.h"
#include "ui/school/hub_dialog.h"

#include <QApplication>
#include <QCheckBox>
#include <QLineEdit>
#include <QProgressBar>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int longMs = 60'000;

/// That sends nothing by itself.
HubPace waitingPace()
{
    using std::chrono::milliseconds;
    return {milliseconds(20), milliseconds(3'600'000), milliseconds(100), milliseconds(200)};
}

} // namespace

class TestHubDialog : public QObject
{
    Q_OBJECT
    HubBench m_bench;
    std::unique_ptr<Project> m_project;
    std::unique_ptr<HubExchange> m_exchange;
    std::unique_ptr<HubDialog> m_dialog;

    void enter(const char *field, const QString &text) const
    {
        named<QLineEdit>(*m_dialog, field)->setText(text);
    }
    void connectByHand(const char *login, const QString &password = {}) const
    {
        enter("Address of the hub", QString::fromStdString(m_bench.address(login).url()));
        enter("Password", password);
        button(*m_dialog, "Connect")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_exchange->isRunning(), longMs);
    }

private Q_SLOTS:
    void initTestCase()
    {
        const QString problem = m_bench.start();
        if (!problem.isEmpty())
            QSKIP(qPrintable(QStringLiteral("ODOGRAPH-SKIPPED: ") + problem));
    }
    void init()
    {
        m_bench.clear();
        m_project = m_bench.project("bench.odo", 2);
        m_exchange = std::make_unique<HubExchange>(waitingPace());
        m_exchange->setProject(m_project.get());
        m_dialog = std::make_unique<HubDialog>(*m_exchange);
        m_dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        m_dialog->show();
    }
    void cleanup()
    {
        m_dialog.reset();
        m_exchange.reset();
        m_project.reset();
    }

    void fromAnAddressToATrialAtTheHub()
    {
        QVERIFY(!button(*m_dialog, "Connect")->isEnabled());
        connectByHand("bench1");
        QVERIFY(says(*m_dialog, "Connected."));
        QVERIFY(says(*m_dialog, "bench1 at"));
        QVERIFY(says(*m_dialog, "Bench: publishes its own trials"));
        QVERIFY(says(*m_dialog, "Version 3"));
        QVERIFY(m_exchange->state().pending >= 2);
        button(*m_dialog, "Publish now")->click();
        QVERIFY(m_dialog->findChild<QProgressBar *>()->isVisible());
        QVERIFY(!button(*m_dialog, "Publish now")->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(!m_exchange->isRunning(), longMs);
        QVERIFY(!m_dialog->findChild<QProgressBar *>()->isVisible());
        QVERIFY(says(*m_dialog, "Nothing: all is sent"));
        QCOMPARE(m_bench.number("SELECT count(*) FROM odograph.document WHERE kind='trial'"), 2);
        button(*m_dialog, "Pull now")->click();
        QTRY_VERIFY_WITH_TIMEOUT(says(*m_dialog, "Nothing new at the hub."), longMs);
        button(*m_dialog, "Disconnect")->click();
        QVERIFY(says(*m_dialog, "Disconnected."));
        QVERIFY(!m_exchange->state().link);
    }

    void aWrongAddressIsNamed()
    {
        enter("Address of the hub", QStringLiteral("school.example"));
        button(*m_dialog, "Connect")->click();
        QVERIFY(says(*m_dialog, "it is no address of a PostgreSQL database"));
        QVERIFY(!m_exchange->isRunning());
        enter("Address of the hub", QStringLiteral("postgresql://anna:hunter2@school/robots"));
        button(*m_dialog, "Connect")->click();
        QVERIFY(says(*m_dialog, "it holds a password"));
        QVERIFY(!m_exchange->isRunning());
    }

    void aPasswordCanBeEntered()
    {
        connectByHand("secret");
        QVERIFY(says(*m_dialog, "the server asks for the password of the login"));
        connectByHand("secret", QStringLiteral("hunter3"));
        QVERIFY(says(*m_dialog, "the server does not accept this login with this password"));
        QCOMPARE(named<QLineEdit>(*m_dialog, "Password")->text(), QString());
        connectByHand("secret", QStringLiteral("hunter2"));
        QVERIFY(says(*m_dialog, "Connected."));
    }

    /// The program was closed and forgot it: the project is connected.
    void aPasswordIsAskedForAgain()
    {
        connectByHand("secret", QStringLiteral("hunter2"));
        m_dialog.reset();
        m_exchange = std::make_unique<HubExchange>(waitingPace());
        m_exchange->setProject(m_project.get());
        m_dialog = std::make_unique<HubDialog>(*m_exchange);
        m_dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        m_dialog->show();
        auto *password = named<QLineEdit>(*m_dialog, "Password of the hub");
        QVERIFY(!password->isVisible());
        button(*m_dialog, "Publish now")->click();
        QTRY_VERIFY_WITH_TIMEOUT(password->isVisible(), longMs);
        QVERIFY(says(*m_dialog, "password needed"));
        password->setText(QStringLiteral("hunter2"));
        button(*m_dialog, "Log in")->click();
        QTRY_VERIFY_WITH_TIMEOUT(says(*m_dialog, "Nothing: all is sent"), longMs);
        QVERIFY(!password->isVisible());
    }

    /// What is pending would not be sent.
    void disconnectingAsksWhereSomethingIsPending()
    {
        connectByHand("bench1");
        {
            Person person({[](QDialog &question) { question.reject(); }});
            button(*m_dialog, "Disconnect")->click();
            QVERIFY(person.isDone());
        }
        QVERIFY(m_exchange->state().link);
        {
            Person person({[](QDialog &question) { button(question, "Disconnect")->click(); }});
            button(*m_dialog, "Disconnect")->click();
            QVERIFY(person.isDone());
        }
        QVERIFY(!m_exchange->state().link);
    }

    void recordingsAreOfferedWithAFolderAlone()
    {
        const QTemporaryDir folder;
        connectByHand("bench1");
        QVERIFY(says(*m_dialog, "No folder: they stay at this bench"));
        const auto *offer = m_dialog->findChild<QCheckBox *>();
        QVERIFY(!offer->isVisible());
        QVERIFY(m_exchange->disconnectFromHub());
        enter("Folder for recordings", folder.path());
        connectByHand("bench1");
        QVERIFY(says(*m_dialog, qPrintable(folder.path())));
        QVERIFY(offer->isVisible());
    }
};

ODOGRAPH_TEST(TestHubDialog, QApplication)
#include "tst_hub_dialog.moc"
