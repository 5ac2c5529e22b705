// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/html_page.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "tests/ui/support/stored_example.h"
#include "ui/report/internal/html_figures.h"
#include "ui/report/internal/html_writer.h"

#include <QApplication>
#include <QHash>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <cmath>

using namespace odo;
using namespace odo::test;

namespace {

/// What an XML parser finds in a page.
struct ReadPage
{
    QString error, language, words;
    QHash<QString, int> elements;
    QHash<QString, QList<QPair<double, double>>> metrics; ///< by name: value and σ (NaN: none)
    QStringList addresses; ///< values of attributes by which a browser would load something
};

ReadPage readPage(const QString &page)
{
    ReadPage read;
    QXmlStreamReader xml(page);
    QString metric;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isCharacters())
            read.words += xml.text();
        if (!xml.isStartElement())
            continue;
        const QString name = xml.name().toString();
        ++read.elements[name];
        const QXmlStreamAttributes attributes = xml.attributes();
        if (name == QLatin1String("html"))
            read.language = attributes.value(QLatin1String("lang")).toString();
        for (const char *loads : {"src", "href", "xlink:href", "srcset", "action", "data"})
            if (attributes.hasAttribute(QLatin1String(loads)))
                read.addresses << attributes.value(QLatin1String(loads)).toString();
        if (attributes.hasAttribute(QLatin1String("data-metric"))) {
            metric = attributes.value(QLatin1String("data-metric")).toString();
            read.metrics[metric] << qMakePair(std::nan(""), std::nan(""));
        } else if (name == QLatin1String("data") && !metric.isEmpty()) {
            auto &last = read.metrics[metric].last();
            (std::isnan(last.first) ? last.first : last.second) =
                attributes.value(QLatin1String("value")).toDouble();
        }
    }
    if (xml.hasError())
        read.error = xml.errorString();
    return read;
}

} // namespace

class TestHtmlPage : public QObject
{
    Q_OBJECT
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;

    QString page(const std::vector<std::string> &trials, const QString &language = QStringLiteral("en"))
    {
        const auto made = htmlPage(*m_project, {trials, {}, language}, {});
        if (!made)
            qWarning("%s", made.error().message().c_str());
        return made ? QString::fromStdString(*made) : QString();
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = openStoredExample(m_folder->path().toStdString());
    }
    void cleanup() { m_project.reset(); }

    void aRunWithAllItsMetrics()
    {
        const QString made = page({"Trial 1"});
        const ReadPage read = readPage(made);
        QVERIFY2(read.error.isEmpty(), qPrintable(read.error));
        QVERIFY(made.startsWith(QLatin1String("<!DOCTYPE html>\n<html lang=\"en\">")));
        QCOMPARE(read.elements.value(QLatin1String("h1")), 1);
        QCOMPARE(read.elements.value(QLatin1String("svg")), 3); // map, speed, acceleration
        const auto trial = m_project->trials().find("Trial 1");
        const auto analyses = m_project->analyses().current(trial->id);
        const auto &metrics = analyses->front().profile.metrics;
        QVERIFY(!metrics.empty());
        QCOMPARE(read.metrics.size(), qsizetype(metrics.size()));
        for (const Metric &metric : metrics) {
            const auto shown = read.metrics.value(QString::fromStdString(metric.name));
            QCOMPARE(shown.size(), 1);
            QCOMPARE(shown.front().first, metric.value); // to the last digit
            QCOMPARE(std::isnan(shown.front().second), !metric.sigma.has_value());
            if (metric.sigma)
                QCOMPARE(shown.front().second, *metric.sigma);
        }
        for (const char *word : {"Trial 1", "Falcon", "Red 2", "Odograph"})
            QVERIFY2(read.words.contains(QLatin1String(word)), word);
        const int spikes = int(analyses->front().profile.spikes.size());
        QVERIFY(spikes == 0 || read.words.contains(QStringLiteral("Spikes: %1").arg(spikes)));
    }

    void nothingIsLoaded()
    {
        const QString made = page({"Trial 1", "Trial 2"});
        QCOMPARE(readPage(made).addresses, QStringList());
        for (const char *banned : {"http:", "https:", "<script", "@import", "url(", "<link", "<iframe"})
            QVERIFY2(!made.contains(QLatin1String(banned)), banned);
        QVERIFY(made.contains(QLatin1String("prefers-color-scheme:dark")));
        QVERIFY(made.contains(QLatin1String("width=device-width")));
        QVERIFY(made.size() < 1'000'000);
    }

    void twoTrialsAreCompared()
    {
        const ReadPage read = readPage(page({"Trial 1", "Trial 2"}));
        QVERIFY2(read.error.isEmpty(), qPrintable(read.error));
        QVERIFY(read.words.contains(QLatin1String("Comparison")));
        // The comparison, one robot, and two robots.
        QCOMPARE(read.elements.value(QLatin1String("section")), 4);
        QVERIFY(read.elements.value(QLatin1String("svg")) >= 9);
        QCOMPARE(readPage(page({"Trial 1", "Trial 1"})).elements.value(QLatin1String("section")), 1);
    }

    void namesCannotBreakOut()
    {
        const std::string name =
            "</h1><script>alert('1')</script> & \"x\" \xe2\x80\xae \x01 \xf0\x9f\xa4\x96";
        const auto trial = m_project->trials().find("Trial 1");
        // What no name may have stands in notes, which may be anything.
        QVERIFY(m_project->trials().setNotes(trial->id, name));
        QVERIFY(m_project->trials().setName(trial->id, "<b>&amp;\"'</b>"));
        const QString made = page({"<b>&amp;\"'</b>"});
        const ReadPage read = readPage(made);
        QVERIFY2(read.error.isEmpty(), qPrintable(read.error));
        QCOMPARE(read.elements.value(QLatin1String("script")), 0);
        QCOMPARE(read.elements.value(QLatin1String("b")), 0);
        QVERIFY(read.words.contains(QLatin1String("<b>&amp;\"'</b>")));
        QVERIFY(read.words.contains(QLatin1String("</h1><script>alert('1')</script> & \"x\"")));
        QVERIFY(read.words.contains(QString::fromUtf8("\xf0\x9f\xa4\x96")));
        QVERIFY(!made.contains(QChar(0x202e)) && !made.contains(QChar(0x01)));
    }

    void theLanguageIsStated()
    {
        QCOMPARE(readPage(page({"Trial 1"}, QStringLiteral("zh_CN"))).language, QStringLiteral("zh-CN"));
    }

    void whatCannotBeShown()
    {
        const auto untracked = htmlPage(*m_project, {.trials = {"Trial 1", "Trial 3"}}, {});
        QVERIFY(!untracked.has_value());
        QVERIFY(untracked.error().message().starts_with("page of trial 'Trial 3': "));
        const auto nobody = htmlPage(*m_project, {.trials = {"Trial 2"}, .robot = "Nobody"}, {});
        QVERIFY(!nobody.has_value());
        QVERIFY(nobody.error().message().find("Nobody") != std::string::npos);
        QCOMPARE(htmlPage(*m_project, {.trials = {"none"}}, {}).error().code, ErrorCode::NotFound);
        JobControl control;
        control.cancel.cancel();
        QCOMPARE(htmlPage(*m_project, {.trials = {"Trial 1"}}, control).error().code, ErrorCode::Cancelled);
    }

    /// Ten minutes at 60 frames/s are reduced to what a screen shows.
    void aLongRunStaysSmall()
    {
        const TrialScenePtr scene = exampleScene({.frames = 36'000});
        HtmlWriter writer;
        writer.open("html");
        writeRunMap(writer, *scene, 0);
        writeRunCharts(writer, scene->robots[0].analysis->profile);
        writer.close();
        QVERIFY2(writer.size() < 600'000, qPrintable(QString::number(writer.size())));
        const ReadPage read = readPage(writer.take());
        QVERIFY2(read.error.isEmpty(), qPrintable(read.error));
        QCOMPARE(read.elements.value(QLatin1String("svg")), 3);
    }

    /// The peak of a curve is where its value says: the chart's axis runs linearly.
    void aChartIsDrawnToScale()
    {
        auto content = std::make_shared<ChartContent>();
        ChartCurve curve;
        curve.runs = {CurveRun{0, {BandPoint(0, {}), BandPoint(1, {10, 0}), BandPoint(2, {})}}};
        content->curves = {curve};
        content->range = {0, 10};
        ChartDrawing drawing;
        drawing.content = content;
        drawing.high = 2;
        HtmlWriter writer;
        writeChart(writer, drawing, QStringLiteral("peak"), {});
        // 46 to 470 across and 16 to 196 down, see the margins: the middle is at 258, the peak at the top.
        QVERIFY(writer.take().contains(QLatin1String("M46 196L258 16L470 196")));
    }
};

ODOGRAPH_TEST(TestHtmlPage, QApplication)
#include "tst_html_page.moc"
