// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/report_actions.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/report/report_dialog.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QInputDialog>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace odo;

namespace {

constexpr int longestMs = 30000; // on a busy machine

/// Saves the report of the dialog that comes up under a name, as soon as its pages are there.
class Saver : public QObject
{
public:
    explicit Saver(const QString &file) : m_file(file)
    {
        connect(&m_timer, &QTimer::timeout, this, [this] { look(); });
        m_timer.start(20);
    }
    QString subject() const { return m_subject; }

private:
    void look()
    {
        QWidget *modal = QApplication::activeModalWidget();
        if (auto *files = qobject_cast<QFileDialog *>(modal)) {
            m_timer.stop();
            chooseFile(m_file)(*files);
            return;
        }
        if (auto *run = qobject_cast<QInputDialog *>(modal)) // of a certificate
            return run->accept();
        auto *report = qobject_cast<ReportDialog *>(modal);
        if (!report)
            return;
        for (auto *button : report->findChildren<QPushButton *>())
            if (button->isDefault() && button->isEnabled()) {
                m_subject = report->proposedName();
                // what it opens is looked at by this timer
                QTimer::singleShot(0, button, &QPushButton::click);
                return;
            }
    }
    QTimer m_timer;
    QString m_file, m_subject;
};

} // namespace

/// Reports from the window.
class TestReportActions : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    static bool isPdf(const QString &file)
    {
        QFile pdf(file);
        return pdf.open(QIODevice::ReadOnly) && pdf.read(5) == "%PDF-";
    }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        QCoreApplication::setOrganizationName(QStringLiteral("odograph-tst_report_actions"));
        QSettings().clear();
        const auto file = storeExample(m_folder.path().toStdString());
        QVERIFY(file.has_value());
        m_window = std::make_unique<MainWindow>();
        QVERIFY(!m_window->findChild<QAction *>(QStringLiteral("report"))->isEnabled());
        m_window->show();
        QVERIFY(m_window->openProject(*file).has_value());
    }
    void cleanupTestCase()
    {
        m_window.reset();
        QSettings().clear();
    }
    void theTrialOnScreenIsSaved()
    {
        QVERIFY(m_window->showTrial("Trial 1").has_value());
        QTRY_VERIFY_WITH_TIMEOUT(m_window->isSettled(), longestMs);
        Saver saver(path("trial.pdf"));
        m_window->findChild<QAction *>(QStringLiteral("report"))->trigger();
        QCOMPARE(saver.subject(), QStringLiteral("Trial 1"));
        QTRY_VERIFY_WITH_TIMEOUT(isPdf(path("trial.pdf")), longestMs);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->workspace().isBusy(), longestMs);
    }
    void theComparisonOnScreenIsSaved()
    {
        QVERIFY(m_window->compareTrials({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")}).has_value());
        QTRY_VERIFY_WITH_TIMEOUT(m_window->isSettled(), longestMs);
        Saver saver(path("comparison"));
        m_window->findChild<QAction *>(QStringLiteral("report"))->trigger();
        QVERIFY2(saver.subject().startsWith(QStringLiteral("The comparison of")),
                 qPrintable(saver.subject()));
        QTRY_VERIFY_WITH_TIMEOUT(isPdf(path("comparison.pdf")), longestMs); // the ending is put to it
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->workspace().isBusy(), longestMs);
    }
    void historyBeginsWithTheClass()
    {
        m_window->showMode(MainWindow::Mode::History);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->isSettled(), longestMs);
        Saver saver(path("class.pdf"));
        m_window->findChild<QAction *>(QStringLiteral("report"))->trigger();
        QCOMPARE(saver.subject(), QStringLiteral("9B"));
        QTRY_VERIFY_WITH_TIMEOUT(isPdf(path("class.pdf")), longestMs);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->workspace().isBusy(), longestMs);
    }
    void chosenTrialsAreOneFile()
    {
        Saver saver(path("trials.pdf"));
        m_window->findChild<ReportActions *>()->askTrials(
            {QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        QTRY_VERIFY_WITH_TIMEOUT(isPdf(path("trials.pdf")), longestMs);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->workspace().isBusy(), longestMs);
    }
    void theSetUpIsCertified()
    {
        Saver saver(path("certificate.pdf"));
        auto *certificate = m_window->findChild<QAction *>(QStringLiteral("certificate"));
        QVERIFY(certificate->isEnabled());
        certificate->trigger();
        QVERIFY(m_window->workspace().isBusy());
        // five simulated runs of small images
        QTRY_VERIFY_WITH_TIMEOUT(isPdf(path("certificate.pdf")), 4 * longestMs);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->workspace().isBusy(), longestMs);
    }
};

ODOGRAPH_TEST(TestReportActions, QApplication)
#include "tst_report_actions.moc"
