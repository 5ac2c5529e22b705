// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/busy_watch.h"
#include "tests/ui/support/stored_example.h"
#include "ui/report/report_dialog.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

constexpr int longestMs = 20000; // on a busy machine

} // namespace

/// The dialog with what a stored project offers.
class TestReportDialog : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project; ///< the window has it open meanwhile
    std::unique_ptr<ReportDialog> m_dialog;

    template <class Widget>
    Widget *named(const char *name) const
    {
        for (Widget *widget : m_dialog->findChildren<Widget *>())
            if (widget->accessibleName() == QString::fromUtf8(name) ||
                widget->property("text").toString() == QString::fromUtf8(name))
                return widget;
        qFatal("no %s", name);
    }
    void open(const QList<ReportSubject> &subjects)
    {
        const ReportChoices choices{
            {QStringLiteral("9B")}, {QStringLiteral("Figure eight, 2 laps")}, {"duration", "max_speed"}};
        m_dialog = std::make_unique<ReportDialog>(m_project->file(), subjects, choices);
        m_dialog->show();
        awaitPages();
    }
    void awaitPages() { QTRY_VERIFY_WITH_TIMEOUT(m_dialog->preview().isSettled(), longestMs); }
    int pages() const { return int(m_dialog->preview().images().size()); }
    static ReportSubject trial(const char *name)
    {
        return {QStringLiteral("The trial"), QStringLiteral("run"), {name}, {}, false};
    }
    static ReportSubject aClass() { return {QStringLiteral("A class"), {}, {}, {}, true}; }
    void choose(const char *box, int index) const
    {
        auto *choice = named<QComboBox>(box);
        choice->setCurrentIndex(index);
        Q_EMIT choice->activated(index);
    }

private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("odograph-tst_report_dialog"));
        QSettings().clear();
        const auto file = storeExample(m_folder.path().toStdString());
        QVERIFY(file.has_value());
        m_project = Project::open(*file, Project::Access::ReadWrite).value();
    }
    void cleanup()
    {
        m_dialog.reset();
        QSettings().clear();
    }

    void showsThePagesAndKeepsTheChoice()
    {
        open({trial("Trial 2")});
        QCOMPARE(pages(), 2);
        QVERIFY(named<QPushButton>("&Save as PDF…")->isEnabled());
        named<QCheckBox>("A second page with the &method")->click();
        awaitPages();
        QCOMPARE(pages(), 4);
        choose("Paper", 1);
        awaitPages();
        const QImage letter = m_dialog->preview().images().front();
        QVERIFY(qAbs(double(letter.height()) / letter.width() - 11 / 8.5) < 0.01);
        open({trial("Trial 2")}); // another time
        QCOMPARE(pages(), 4);
        QCOMPARE(named<QComboBox>("Paper")->currentIndex(), 1);
    }
    void aClassIsChosen()
    {
        open({trial("Trial 1"), aClass()});
        QVERIFY(!named<QComboBox>("Class")->isVisible());
        QCOMPARE(m_dialog->proposedName(), QStringLiteral("run"));
        choose("Report of", 1);
        awaitPages();
        QVERIFY(named<QComboBox>("Class")->isVisible());
        QVERIFY(!named<QCheckBox>("A second page with the &method")->isVisible());
        QCOMPARE(m_dialog->proposedName(), QStringLiteral("9B"));
        QCOMPARE(pages(), 1);
        named<QCheckBox>("A page for each &team")->click();
        awaitPages();
        QVERIFY(pages() > 1);
    }
    void whatCannotBeMadeIsSaid()
    {
        open({trial("Trial 9")});
        QCOMPARE(pages(), 0);
        QVERIFY(!named<QPushButton>("&Save as PDF…")->isEnabled());
        QVERIFY(!named<QPushButton>("&Print…")->isEnabled());
        QVERIFY(m_dialog->preview().accessibleDescription().contains(QStringLiteral("Trial 9")));
    }
    void manyPagesAreShownInPart()
    {
        ReportSubject many = trial("Trial 1");
        many.trials.resize(15, "Trial 1");
        open({many});
        QCOMPARE(pages(), int(ReportPreview::mostPages));
        QVERIFY(named<QPushButton>("&Save as PDF…")->isEnabled());
        bool isTold = false;
        for (const QLabel *label : m_dialog->findChildren<QLabel *>())
            isTold = isTold || label->text().contains(QStringLiteral("the file has all of them"));
        QVERIFY(isTold);
    }
    void theSchoolIsOnThePages()
    {
        open({trial("Trial 1")});
        const QImage before = m_dialog->preview().images().front();
        ReportSettings settings = storedReportSettings();
        settings.school = QStringLiteral("Lindenschule");
        storeReportSettings(settings);
        m_dialog->refresh();
        awaitPages();
        QVERIFY(m_dialog->preview().images().front() != before);
    }
    /// Not before: a large picture would keep the window waiting.
    void theLogoIsReadWithThePages()
    {
        ReportSettings settings = storedReportSettings();
        settings.logoFile = m_folder.filePath(QStringLiteral("logo.png"));
        storeReportSettings(settings);
        open({trial("Trial 1")});
        QVERIFY(pages() > 0); // a logo that is not there is left out
        const ReportMaker maker = m_dialog->maker();
        QImage logo(400, 100, QImage::Format_RGB32);
        logo.fill(Qt::magenta);
        QVERIFY(logo.save(settings.logoFile));
        QImage page;
        const auto made = maker(*m_project, {}, [&page](const ReportPage &each) -> Result<void> {
            if (page.isNull())
                page = pageImage(each, 600);
            return {};
        });
        QVERIFY2(made.has_value(), made ? "" : made.error().message().c_str());
        bool isThere = false;
        for (int x = 0; x < page.width(); ++x)
            isThere = isThere || page.pixelColor(x, 48) == QColor(Qt::magenta);
        QVERIFY(isThere);
    }
    void neverKeepsTheWindowWaiting()
    {
        BusyWatch watch;
        ReportSubject many = trial("Trial 1");
        many.trials.resize(6, "Trial 1");
        open({many});
        qInfo("longest: %.1f ms", watch.longestMs());
        QVERIFY(watch.longestMs() < longestAllowedMs());
    }
};

ODOGRAPH_TEST(TestReportDialog, QApplication)
#include "tst_report_dialog.moc"
