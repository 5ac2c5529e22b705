// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_output.h"

#include "tests/support/registered_test.h"
#include "tests/ui/support/printed_text.h"

#include <QApplication>
#include <QPainter>
#include <QPrinter>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

ReportPage page(const QString &words, bool isLandscape)
{
    ReportPage made;
    made.format.isLandscape = isLandscape;
    made.paint = [words](QPainter &painter) { painter.drawText(QPointF(100, 100), words); };
    return made;
}

/// As where no printer is set up: pages go to the file that the dialog offers.
std::unique_ptr<QPrinter> printerTo(const QString &file)
{
    auto printer = std::make_unique<QPrinter>(QPrinter::HighResolution);
    printer->setOutputFormat(QPrinter::PdfFormat);
    printer->setOutputFileName(file);
    return printer;
}

} // namespace

/// Pages on a printer, and where there is none.
class TestPrintedPages : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

private Q_SLOTS:
    void withoutAPrinterThereIsAFile()
    {
        const QString file = m_folder.filePath(QStringLiteral("print.pdf"));
        PrintedPages pages(printerTo(file));
        for (int i = 1; i <= 200; ++i) { // as many as a report of a year has
            const auto added = pages.add(page(QStringLiteral("word%1").arg(i), i == 2));
            QVERIFY2(added, added ? "" : added.error().message().c_str());
        }
        QVERIFY(pages.finish());
        const PrintedWords printed = printedWords(file);
        QCOMPARE(printed.pageSizes.size(), 200);
        QCOMPARE(printed.words.size(), 200);
        QVERIFY(printed.pageSizes[0].height() > printed.pageSizes[0].width());
        QVERIFY(printed.pageSizes[1].height() < printed.pageSizes[1].width());
    }

    void aPrinterThatCannotBeReachedIsSaid()
    {
        PrintedPages pages(printerTo(m_folder.filePath(QStringLiteral("no/such/folder/print.pdf"))));
        const auto added = pages.add(page(QStringLiteral("word"), false));
        QVERIFY(!added);
        QCOMPARE(added.error().code, ErrorCode::Io);
        QCOMPARE(added.error().why.english(), std::string("it cannot be reached"));
        QCOMPARE(added.error().advice.english(),
                 std::string("check the printer and its queue, or save the report as PDF"));
    }

    void withoutAPageNothingIsPrinted()
    {
        const QString file = m_folder.filePath(QStringLiteral("none.pdf"));
        PrintedPages pages(printerTo(file));
        const auto finished = pages.finish();
        QVERIFY(!finished);
        QCOMPARE(finished.error().code, ErrorCode::InvalidInput);
        QVERIFY(!QFile::exists(file));
    }
};

ODOGRAPH_TEST(TestPrintedPages, QApplication)
#include "tst_printed_pages.moc"
