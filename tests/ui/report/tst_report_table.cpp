// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/ui/support/printed_text.h"
#include "ui/report/internal/report_painting.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

class TestReportTable : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    QString textOf(const ReportTable &table, double width, double height)
    {
        const PageFormat format;
        const auto paint = [&](QPainter &painter) {
            drawTable(painter, QRectF(format.content().topLeft(), QSizeF(width, height)), table);
        };
        return printedText(printed({{format, paint}}, m_folder)).simplified();
    }
    static ReportTable twoColumns()
    {
        ReportTable table;
        table.weights = {0.4, 0.6};
        table.alignments = {Qt::AlignLeft, Qt::AlignRight};
        table.rows = {{{QStringLiteral("the time of this sector"), QStringLiteral("3.0 s")}}};
        return table;
    }

private Q_SLOTS:
    void spareWidthGoesToTheColumnThatMissesSome()
    {
        // Some 125 and 30 of 170, of which the weights give 68 and 102.
        QCOMPARE(textOf(twoColumns(), 170, 20), QStringLiteral("the time of this sector 3.0 s"));
    }
    void whereThereIsNoneNumbersStayWhole()
    {
        QCOMPARE(textOf(twoColumns(), 110, 20).section(u'…', 1), QStringLiteral(" 3.0 s"));
    }
    void wordsTakeTheLinesThatAreAllowed()
    {
        ReportTable table = twoColumns();
        QCOMPARE(tableHeight(table, 110), table.rowHeight);
        table.mostLines = 2;
        const double height = tableHeight(table, 110);
        QVERIFY(height > 1.5 * table.rowHeight && height <= 2 * table.rowHeight);
        QCOMPARE(tableHeight(table, 300), table.rowHeight);
        const QString text = textOf(table, 110, height);
        QVERIFY2(text.contains(QStringLiteral("sector")) && !text.contains(u'…'), qPrintable(text));
    }
    void rowsWithoutRoomAreCounted()
    {
        ReportTable table = twoColumns();
        table.rows = QList<ReportTable::Row>(5, table.rows.first());
        QCOMPARE(textOf(table, 300, 5 * table.rowHeight).count(QStringLiteral("3.0 s")), 5);
        const QString text = textOf(table, 300, 4 * table.rowHeight);
        QCOMPARE(text.count(QStringLiteral("3.0 s")), 3);
        QVERIFY2(text.endsWith(QStringLiteral("and 2 more")), qPrintable(text));
        table.mostLines = 2; // in 110 each row takes two lines, so that one less has room
        QVERIFY(textOf(table, 110, 4 * table.rowHeight).contains(QStringLiteral("and 4 more")));
    }
};

ODOGRAPH_TEST(TestReportTable, QApplication)
#include "tst_report_table.moc"
