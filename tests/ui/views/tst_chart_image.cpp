// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/chart_image.h"

#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/profile_chart.h"
#include "ui/views/map/floor_map.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QImageReader>
#include <QMimeData>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

using namespace odo;

namespace {

struct SpeedChart
{
    Timeline timeline;
    ProfileChart card{timeline, Quantity::Speed};
    ChartImage *picture;

    explicit SpeedChart(const TrialScenePtr &scene) : picture(card.chartArea()->findChild<ChartImage *>())
    {
        timeline.setFrameTimes(scene->frameTimes());
        card.setScene(scene);
        card.resize(700, 260);
        card.show();
    }
};

/// The words of an SVG, and how many elements of each kind it has.
struct SvgContent
{
    QString words;
    QHash<QString, int> counts;

    explicit SvgContent(const QByteArray &svg)
    {
        QXmlStreamReader reader(svg);
        while (!reader.atEnd()) {
            if (reader.readNext() == QXmlStreamReader::StartElement)
                ++counts[reader.name().toString()];
            else if (reader.isCharacters())
                words += reader.text();
        }
        isWhole = !reader.hasError();
    }
    bool isWhole = false;
};

} // namespace

class TestChartImage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linesAndWordsStaySuchInSvg()
    {
        const auto scene = exampleScene({.frames = 120, .robots = 2});
        SpeedChart chart(scene);
        const QByteArray svg = chart.picture->svg();
        const SvgContent content(svg);
        QVERIFY(content.isWhole);
        QVERIFY(QSvgRenderer(svg).isValid());
        QCOMPARE(content.counts.value(QStringLiteral("image")), 0);
        QVERIFY(content.counts.value(QStringLiteral("polyline")) +
                    content.counts.value(QStringLiteral("path")) >
                4);
        for (const QString &word :
             {QStringLiteral("Speed"), QString::fromStdString(scene->trial.name), QStringLiteral("m/s"),
              QString::fromStdString(scene->robots[0].robot.name),
              QString::fromStdString(scene->robots[1].robot.name)})
            QVERIFY2(content.words.contains(word), qPrintable(word + u'\n' + content.words));
    }
    void itIsTheSameInEachThemeAndWithTheFocus()
    {
        const auto scene = exampleScene({.frames = 120});
        SpeedChart chart(scene);
        const QByteArray svg = chart.picture->svg();
        const QImage image = chart.picture->image();
        QCOMPARE(image.size(), chart.card.chartArea()->size() * 3 +
                                   QSize(0, image.height() - 3 * chart.card.chartArea()->height()));
        QCOMPARE(image.pixelColor(1, 1), QColor(Qt::white));
        chart.card.setPalette(darkPalette());
        QVERIFY(isDark(chart.card.chartArea()->palette()));
        chart.card.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&chart.card));
        chart.card.chartArea()->setFocus();
        const QImage shown = chart.card.chartArea()->grab().toImage();
        QCOMPARE(chart.picture->svg(), svg);
        QVERIFY(chart.picture->image() == image);
        QVERIFY(isDark(chart.card.chartArea()->palette()));
        QVERIFY(chart.card.chartArea()->grab().toImage() == shown); // the screen is as it was
    }
    void aMapComesOutToo()
    {
        Timeline timeline;
        FloorMap map(timeline);
        const auto scene = exampleScene({.frames = 120});
        timeline.setFrameTimes(scene->frameTimes());
        map.setScene(scene);
        map.resize(420, 360);
        map.show();
        const SvgContent content(map.findChild<ChartImage *>()->svg());
        QVERIFY(content.isWhole);
        QVERIFY(content.words.contains(QStringLiteral("Top-down map · ") +
                                       QString::fromStdString(scene->trial.name)));
        QVERIFY(content.counts.value(QStringLiteral("path")) +
                    content.counts.value(QStringLiteral("polyline")) >
                4);
    }
    void itIsCopiedByTheKeysOfCopying()
    {
        SpeedChart chart(exampleScene({.frames = 60}));
        chart.card.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&chart.card));
        chart.card.chartArea()->setFocus();
        QGuiApplication::clipboard()->clear();
        QTest::keySequence(chart.card.chartArea(), QKeySequence::Copy);
        const QMimeData *content = QGuiApplication::clipboard()->mimeData();
        QVERIFY(content->hasImage());
        QCOMPARE(content->data(QStringLiteral("image/svg+xml")), chart.picture->svg());
    }
    void itIsSavedByTheEndingOfItsFile()
    {
        const SpeedChart chart(exampleScene({.frames = 60}));
        QTemporaryDir folder;
        const QString svg = folder.filePath(QStringLiteral("a.SVG")),
                      png = folder.filePath(QStringLiteral("b.png")),
                      pdf = folder.filePath(QStringLiteral("c.pdf"));
        QVERIFY(chart.picture->save(pathOf(svg)));
        QVERIFY(chart.picture->save(pathOf(png)));
        QVERIFY(chart.picture->save(pathOf(pdf)));
        QFile document(pdf);
        QVERIFY(document.open(QIODevice::ReadOnly));
        const QByteArray page = document.readAll();
        QVERIFY(page.startsWith("%PDF") && page.contains("/Font") && !page.contains("/Subtype /Image"));
        QVERIFY(QSvgRenderer(svg).isValid());
        QCOMPARE(QImageReader(png).read().size(), chart.picture->image().size());
    }
    void aFileThatCannotBeWrittenIsTold()
    {
        const SpeedChart chart(exampleScene({.frames = 60}));
        const auto saved = chart.picture->save("/nowhere/at/all/a.svg");
        QVERIFY(!saved);
        QVERIFY2(saved.error().message().find("/nowhere/at/all/a.svg") != std::string::npos,
                 saved.error().message().c_str());
    }
    void withoutATrialItIsEmptyAndWhole()
    {
        Timeline timeline;
        ProfileChart card(timeline, Quantity::Heading);
        card.resize(400, 200);
        const SvgContent content(card.chartArea()->findChild<ChartImage *>()->svg());
        QVERIFY(content.isWhole);
        QVERIFY(content.words.contains(QStringLiteral("Heading")));
    }
};

ODOGRAPH_TEST(TestChartImage, QApplication)
#include "tst_chart_image.moc"
