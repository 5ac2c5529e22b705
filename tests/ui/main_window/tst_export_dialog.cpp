// SPDX-License-Identifier: GPL-3.0-or-later
// How tracks are exported: what is chosen is what is written, kept by a name, and there again.
#include "ui/main_window/internal/export_dialog.h"

#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/mnemonics.h"
#include "tests/ui/support/person.h"

#include <QApplication>
#include <QComboBox>
#include <QListWidget>
#include <QSettings>
#include <QTest>

using namespace odo;
using namespace odo::test;

class TestExportDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { test::beginWithoutSettings(); }
    void init() { QSettings().clear(); }

    void atFirstAllOfIt()
    {
        const ExportDialog dialog(offer());
        const TrackExport how = dialog.settings();
        QVERIFY(how.format == ExportedFormat::Csv && how.style == CsvStyle::Analysis);
        QCOMPARE(how.columns.size(), csvColumns().size());
        QVERIFY(how.unit == CsvLength::Millimetres && how.frame == TrackFrame::Floor);
        QVERIFY(!how.isWhole && !how.span);
        QCOMPARE(dialog.output().ending, QStringLiteral("csv"));
    }

    void whatIsChosenCounts()
    {
        ExportDialog dialog(offer());
        choose(dialog, "Robot", "Blue 1");
        choose(dialog, "Format", "CSV for spreadsheets, 1,5 (*.csv)");
        choose(dialog, "Lengths in", "m");
        choose(dialog, "Axes", "From the start, X in its direction");
        named<QComboBox>(dialog, "Part of the run")->setCurrentIndex(2);
        QVERIFY(named<QComboBox>(dialog, "Part of the run")
                    ->currentText()
                    .startsWith(QLatin1String("The selection, 1")));
        auto *columns = named<QListWidget>(dialog, "Columns");
        QCOMPARE(columns->item(1)->text(), QStringLiteral("x_m")); // as in the file
        for (int row = 3; row < columns->count(); ++row)
            columns->item(row)->setCheckState(Qt::Unchecked);
        const TrackExport how = dialog.settings();
        QCOMPARE(dialog.robot(), 1);
        QVERIFY(how.style == CsvStyle::Continental && how.unit == CsvLength::Metres);
        QVERIFY(how.frame == TrackFrame::Start);
        QCOMPARE(how.columns, (std::vector<std::size_t>{0, 1, 2}));
        QVERIFY(how.isWhole && how.span == offer().selection);
        choose(dialog, "Part of the run", "The whole run");
        QVERIFY(dialog.settings().isWhole && !dialog.settings().span);
    }

    /// What a format does not have is not asked.
    void formatsDiffer()
    {
        ExportDialog dialog(offer());
        choose(dialog, "Format", "TUM trajectory (*.tum)");
        QVERIFY(!named<QListWidget>(dialog, "Columns")->isEnabled());
        QVERIFY(!named<QComboBox>(dialog, "Lengths in")->isEnabled());
        QVERIFY(named<QComboBox>(dialog, "Axes")->isEnabled());
        QCOMPARE(dialog.output().ending, QStringLiteral("tum"));
        choose(dialog, "Format", "Page to take along (*.html)");
        QVERIFY(dialog.isPage() && !named<QComboBox>(dialog, "Axes")->isEnabled());
        QVERIFY(dialog.output().kind == FileKind::Html);
        const ExportDialog several({QStringLiteral("Export 3 trials"), {}, false, false, {}});
        QVERIFY(named<QComboBox>(several, "Format")->findText(QStringLiteral("Page to take along (*.html)")) <
                0);
        QVERIFY(!named<QComboBox>(several, "Robot")->isVisibleTo(&several));
    }

    void withoutColumnsThereIsNoFile()
    {
        ExportDialog dialog(offer());
        auto *columns = named<QListWidget>(dialog, "Columns");
        for (int row = 0; row < columns->count(); ++row)
            columns->item(row)->setCheckState(Qt::Unchecked);
        QVERIFY(!button(dialog, "Choose a file…")->isEnabled());
        columns->item(2)->setCheckState(Qt::Checked);
        QVERIFY(button(dialog, "Choose a file…")->isEnabled());
    }

    void presetsAreKeptByAName()
    {
        {
            ExportDialog dialog(offer());
            choose(dialog, "Format", "CSV for spreadsheets, 1.5 (*.csv)");
            choose(dialog, "Lengths in", "cm");
            named<QListWidget>(dialog, "Columns")->item(16)->setCheckState(Qt::Unchecked);
            Person person({enterText(QStringLiteral("For LibreOffice"))});
            button(dialog, "Keep as…")->click();
            QVERIFY(person.isDone());
            choose(dialog, "Format", "Tracker text (*.txt)");
            dialog.accept();
        }
        ExportDialog again(offer());
        QVERIFY(again.settings().format == ExportedFormat::Tracker); // as last time
        auto *presets = named<QComboBox>(again, "Preset");
        presets->setCurrentIndex(presets->findText(QStringLiteral("For LibreOffice")));
        Q_EMIT presets->activated(presets->currentIndex());
        QVERIFY(again.settings().style == CsvStyle::International);
        QVERIFY(again.settings().unit == CsvLength::Centimetres);
        QCOMPARE(again.settings().columns.size(), csvColumns().size() - 1);
        button(again, "Remove")->click();
        QCOMPARE(ExportDialog(offer()).findChild<QComboBox *>()->count(), 1);
    }

    void fitsASmallScreenWithLongNames()
    {
        ExportOffer longOnes = offer();
        longOnes.robots = {QString(3000, u'w'), QString(3000, u'm')};
        ExportDialog dialog(longOnes);
        dialog.show();
        QVERIFY2(dialog.width() <= 1024 && dialog.height() <= 560,
                 qPrintable(QStringLiteral("%1×%2").arg(dialog.width()).arg(dialog.height())));
        const QStringList shared = sharedMnemonics(dialog);
        QVERIFY2(shared.isEmpty(), qPrintable(shared.join(u'\n')));
    }

private:
    static ExportOffer offer()
    {
        return {QStringLiteral("Export Trial 2"),
                {QStringLiteral("Red 2"), QStringLiteral("Blue 1")},
                true,
                true,
                TimeSpan{std::chrono::seconds(1), std::chrono::milliseconds(2500)}};
    }
    static void choose(const ExportDialog &dialog, const char *name, const char *words)
    {
        auto *box = named<QComboBox>(dialog, name);
        const int index = box->findText(QString::fromUtf8(words));
        QVERIFY2(index >= 0, words);
        box->setCurrentIndex(index);
    }
};

ODOGRAPH_TEST(TestExportDialog, QApplication)
#include "tst_export_dialog.moc"
