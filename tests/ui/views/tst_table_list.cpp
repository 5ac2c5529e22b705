// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/table_list.h"

#include "tests/support/registered_test.h"

#include <QApplication>
#include <QHeaderView>
#include <QTableWidget>
#include <QTest>

using namespace odo;

class TestTableList : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aRowThatIsNotThereHasNoRecord()
    {
        const std::vector<int> records{7, 8};
        QCOMPARE(*recordAt(records, 1), 8);
        QVERIFY(!recordAt(records, -1) && !recordAt(records, 2));
    }

    void whatIsLeftGoesToOneColumn()
    {
        QTableWidget table(1, 3);
        fill(table, 600);
        const int before = table.columnWidth(0);
        fitColumns(table, 1, {0, 1});
        QCOMPARE(table.horizontalHeader()->length(), table.viewport()->width());
        QCOMPARE(table.columnWidth(0), before);
    }

    void theWidestGiveWayFirst()
    {
        QTableWidget table(1, 3);
        table.setItem(0, 0, new QTableWidgetItem(QString(60, u'm')));
        table.setItem(0, 1, new QTableWidgetItem(QString(12, u'm')));
        fill(table, 400);
        const int narrow = table.columnWidth(1), figure = table.columnWidth(2);
        fitColumns(table, 1, {0, 1});
        QCOMPARE(table.horizontalHeader()->length(), table.viewport()->width());
        QCOMPARE(table.columnWidth(1), narrow); // the other one was enough
        QCOMPARE(table.columnWidth(2), figure);
    }

    void theFirstGivesWayLast()
    {
        QTableWidget table(1, 3);
        for (const int column : {0, 1})
            table.setItem(0, column, new QTableWidgetItem(QString(60, u'm')));
        const int letter = table.fontMetrics().averageCharWidth();
        fill(table, 40 * letter);
        const int figure = table.columnWidth(2);
        table.resize(table.width() + 26 * letter + figure - table.viewport()->width(), table.height());
        fitColumns(table, 1, {0, 1});
        QCOMPARE(table.columnWidth(0), 16 * letter);
        QCOMPARE(table.columnWidth(1), 10 * letter);
        QCOMPARE(table.columnWidth(2), figure);
    }

    void nothingBecomesTooNarrowToRead()
    {
        QTableWidget table(1, 3);
        table.setItem(0, 0, new QTableWidgetItem(QString(60, u'm')));
        fill(table, 60);
        fitColumns(table, 1, {0});
        QCOMPARE(table.columnWidth(0), 12 * table.fontMetrics().averageCharWidth());
        QVERIFY(table.horizontalHeader()->length() > table.viewport()->width()); // and can be scrolled
    }

    void noHeadingIsCut()
    {
        QTableWidget table(1, 3);
        table.setHorizontalHeaderLabels({QStringLiteral("Trial"), QStringLiteral("A long heading"), {}});
        for (const int column : {0, 1})
            table.setItem(0, column, new QTableWidgetItem(QString(60, u'm')));
        fill(table, 60);
        fitColumns(table, 1, {0, 1});
        QCOMPARE(table.columnWidth(1), table.horizontalHeader()->sectionSizeHint(1));
        QVERIFY(table.columnWidth(1) > 8 * table.fontMetrics().averageCharWidth());
    }

private:
    static void fill(QTableWidget &table, int width)
    {
        table.horizontalHeader()->setMinimumSectionSize(1);
        for (int column = 0; column < 3; ++column)
            if (!table.item(0, column))
                table.setItem(0, column, new QTableWidgetItem(QStringLiteral("7.5 s")));
        table.resize(width, 200);
        table.show();
        table.resizeColumnsToContents();
    }
};

ODOGRAPH_TEST(TestTableList, QApplication)
#include "tst_table_list.moc"
