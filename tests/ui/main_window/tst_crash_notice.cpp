// SPDX-License-Identifier: GPL-3.0-or-later
// After a crash the next window says so, once, and offers the project that was open.
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/program_ends.h"
#include "ui/main_window/workspace.h"
#include "ui/views/widgets/labels.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

using namespace odo;

class TestCrashNotice : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::filesystem::path m_project;

    std::filesystem::path state() const { return m_folder.filePath(QStringLiteral("state")).toStdString(); }
    void leaveReport(const std::string &project) const
    {
        std::ofstream(state() / "crash-20261122T101112Z-77.txt")
            << "odograph 0.1.0 ended unexpectedly\nbegun: 20261122T101112Z\nproject: " << project
            << "\nsignal: SIGSEGV\n\nodograph(+0x1)[0x1]\n";
    }
    static QPushButton *openButton(const CrashNotice &notice)
    {
        for (QPushButton *button : notice.findChildren<QPushButton *>())
            if (button->isDefault())
                return button;
        return nullptr;
    }

private Q_SLOTS:
    void initTestCase()
    {
        const auto made = storeExample(m_folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_project = *made;
        std::filesystem::create_directories(state());
    }

    void offersTheProjectThatWasOpen()
    {
        leaveReport(m_project.string());
        MainWindow window;
        window.show();
        reportCrashes(window, state(), {});
        auto *notice = window.findChild<CrashNotice *>();
        QVERIFY(notice && notice->isVisible());
        QCOMPARE(notice->findChild<ElidedLabel *>(QStringLiteral("project"))->fullText(),
                 QString::fromStdString(m_project.string()));
        const QString report = notice->findChild<ElidedLabel *>(QStringLiteral("report"))->fullText();
        QVERIFY2(std::filesystem::exists(report.toStdString()), qPrintable(report));
        QSignalSpy opened(&window.workspace(), &Workspace::opened);
        openButton(*notice)->click();
        QTRY_COMPARE(opened.count(), 1);
        QTRY_VERIFY(!window.findChild<CrashNotice *>());
        reportCrashes(window, state(), {}); // told once
        QVERIFY(!window.findChild<CrashNotice *>());
    }
    void offersNothingThatIsGoneOrOpenedAnyway_data()
    {
        QTest::addColumn<QString>("project");
        QTest::addColumn<bool>("isOpening");
        QTest::newRow("opened anyway") << QString::fromStdString(m_project.string()) << true;
        QTest::newRow("gone") << QStringLiteral("/no/such/project.odo") << false;
        QTest::newRow("none") << QString() << false;
    }
    void offersNothingThatIsGoneOrOpenedAnyway()
    {
        QFETCH(QString, project);
        QFETCH(bool, isOpening);
        leaveReport(project.toStdString());
        MainWindow window;
        window.show();
        reportCrashes(window, state(), isOpening ? std::optional(m_project) : std::nullopt);
        auto *notice = window.findChild<CrashNotice *>();
        QVERIFY(notice && notice->isVisible());
        QVERIFY(!notice->findChild<ElidedLabel *>(QStringLiteral("project")));
        QCOMPARE(notice->findChildren<QPushButton *>().size(), 1); // Close
    }
    void isSilentWithoutACrash()
    {
        MainWindow window;
        reportCrashes(window, state(), {});
        reportCrashes(window, state() / "no such folder", {});
        QVERIFY(!window.findChild<CrashNotice *>());
    }
    void aLongNameKeepsTheDialogInShape()
    {
        std::filesystem::path deep = "/home";
        for (int i = 0; i < 40; ++i)
            deep /= std::string(90, 'W');
        const CrashNotice notice(deep, deep);
        QVERIFY(notice.minimumSizeHint().width() < 700);
    }
};

ODOGRAPH_TEST(TestCrashNotice, QApplication)
#include "tst_crash_notice.moc"
