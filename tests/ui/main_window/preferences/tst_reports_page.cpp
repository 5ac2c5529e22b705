// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/main_window/preferences/preferences_dialog.h"
#include "ui/views/widgets/form_fields.h"

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

constexpr int longestMs = 20000; // on a busy machine

} // namespace

/// How the logo of reports looks, or why it cannot be used; it is read on a thread.
class TestReportsPage : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    QString logo(const char *name, const QSize &size) const
    {
        QImage image(size, QImage::Format_RGB32);
        image.fill(Qt::blue);
        const QString file = m_folder.filePath(QString::fromUtf8(name));
        if (!image.save(file))
            qFatal("%s", qPrintable(file));
        return file;
    }
    static QLabel *shown(const ReportsPage &page)
    {
        for (auto *label : page.findChildren<QLabel *>())
            if (label->accessibleName() == QStringLiteral("Preview of the logo"))
                return label;
        qFatal("no picture");
    }
    static void choose(const ReportsPage &page, const QString &file)
    {
        page.findChild<PathField *>()->setPath(file);
    }

private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void init() { QSettings().clear(); }
    void cleanupTestCase() { QSettings().clear(); }

    void whatIsRememberedIsShown()
    {
        ReportSettings settings = storedReportSettings();
        settings.logoFile = logo("wide.png", {3000, 1000});
        storeReportSettings(settings);
        const ReportsPage page;
        QTRY_COMPARE_WITH_TIMEOUT(shown(page)->pixmap().size(), QSize(180, 60), longestMs);
    }
    void noneIsNoPicture()
    {
        const ReportsPage page;
        choose(page, logo("one.png", {100, 100}));
        QTRY_COMPARE_WITH_TIMEOUT(shown(page)->pixmap().size(), QSize(60, 60), longestMs);
        choose(page, {});
        QTRY_VERIFY_WITH_TIMEOUT(shown(page)->pixmap().isNull(), longestMs);
        QCOMPARE(storedReportSettings().logoFile, QString());
    }
    void anotherThatIsChosenMeanwhileIsShown()
    {
        const QString first = logo("first.png", {4000, 2000}), second = logo("second.png", {50, 100});
        const ReportsPage page;
        choose(page, first);
        choose(page, second);
        QTRY_COMPARE_WITH_TIMEOUT(shown(page)->pixmap().size(), QSize(30, 60), longestMs);
        QCOMPARE(storedReportSettings().logoFile, second);
    }
    void whatCannotBeUsedIsSaid()
    {
        QFile text(m_folder.filePath(QStringLiteral("text.png")));
        QVERIFY(text.open(QIODevice::WriteOnly) && text.write("not a picture") > 0);
        text.close();
        const ReportsPage page;
        choose(page, text.fileName());
        QTRY_VERIFY_WITH_TIMEOUT(
            shown(page)->text().contains(QStringLiteral("choose a PNG, JPEG or SVG image")), longestMs);
        QVERIFY(shown(page)->pixmap().isNull());
    }
};

ODOGRAPH_TEST(TestReportsPage, QApplication)
#include "tst_reports_page.moc"
