// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/printed_text.h"
#include "tests/ui/support/stored_example.h"
#include "ui/report/report_maker.h"
#include "ui/report/report_output.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

/// The report of stored runs of one course.
class TestComparisonReport : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;

    ComparisonScenePtr sceneOf(std::vector<CompareSettings::Run> runs)
    {
        CompareSettings settings;
        settings.runs = std::move(runs);
        const auto scene = loadComparisonScene(*m_project, settings);
        if (!scene)
            qFatal("%s", scene.error().message().c_str());
        return *scene;
    }
    QString printed(const ReportPages &pages) { return test::printed(pages, m_folder); }

private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        const auto file = storeExample(m_folder.path().toStdString(), {.frames = 150});
        QVERIFY(file.has_value());
        m_project = Project::open(*file, Project::Access::ReadWrite).value();
    }
    void twoRunsSideBySide()
    {
        const QString file = printed(comparisonPages(sceneOf({{"Trial 1", {}}, {"Trial 2", "Blue 1"}}), {}));
        const PrintedWords words = printedWords(file);
        QCOMPARE(words.pageSizes.size(), 1);
        QVERIFY(words.pageSizes.first().width() > words.pageSizes.first().height());
        QCOMPARE(fontsNotEmbedded(file), QStringList());
        constexpr double margin = 30;
        for (const PrintedWord &word : words.words)
            QVERIFY2(QRectF(QPointF(margin, margin), words.pageSizes.first() - QSizeF(2 * margin, 2 * margin))
                         .contains(word.box),
                     qPrintable(word.text));
        const QString text = printedText(file).simplified();
        for (const char *part :
             {"Trial 1 and Blue 1 in Trial 2", "Falcon", "Heron", "Speed over distance", "Time difference, s",
              "Sectors, s", "right − left", "aligned by the onset of motion"})
            QVERIFY2(text.contains(QString::fromUtf8(part)),
                     qPrintable(QString::fromUtf8(part) + QStringLiteral(" is not in ") + text));
        QVERIFY(text.contains(QStringLiteral("≈"))); // both have the same figures
        // The first run's name is at the left of the second's.
        const auto leftOf = [&words](const char *name) {
            for (const PrintedWord &word : words.words)
                if (word.text == QLatin1String(name))
                    return word.box.left();
            return -1.0;
        };
        QVERIFY(leftOf("Falcon") >= 0 && leftOf("Falcon") < leftOf("Heron"));
    }
    void eachFurtherRunHasAPageOfItsOwn()
    {
        const auto scene = sceneOf({{"Trial 1", {}}, {"Trial 2", "Red 2"}, {"Trial 2", "Blue 1"}});
        const QString file = printed(comparisonPages(scene, {}));
        QCOMPARE(printedWords(file).pageSizes.size(), 2);
        QVERIFY(printedText(file, 1).contains(QStringLiteral("Trial 1 and Red 2 in Trial 2")));
        QVERIFY(printedText(file, 2).contains(QStringLiteral("Trial 1 and Blue 1 in Trial 2")));
    }
    void runsThatCannotBeComparedLeaveNoFile()
    {
        CompareSettings settings;
        settings.runs = {{"Trial 1", {}}, {"Trial 3", {}}};
        const QString file = m_folder.filePath(QStringLiteral("none.pdf"));
        ReportJob job(comparisonReport(settings, {}),
                      std::make_unique<PdfFile>(file.toStdString(), QStringLiteral("Test")));
        QCOMPARE(runToEnd(job, *m_project, {}).error().code, ErrorCode::NotFound);
        QVERIFY(!QFileInfo::exists(file));
    }
};

ODOGRAPH_TEST(TestComparisonReport, QApplication)
#include "tst_comparison_report.moc"
