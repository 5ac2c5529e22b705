// SPDX-License-Identifier: GPL-3.0-or-later
// Tables that are no tables, or hold what no table should: each is read as what it is, or refused by a line,
// and a refused one leaves the project as it was.
#include "tests/attack/attacked.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo::test;

namespace {

QByteArray track(const QByteArray &header, const QByteArray &separator, int rows,
                 const QByteArray &third = {})
{
    QByteArray table = header + '\n';
    for (int i = 0; i < rows; ++i)
        table += QByteArray::number(i / 30.0, 'f', 4) + separator + QByteArray::number(10 * i) + separator +
                 (third.isEmpty() ? QByteArray::number(5 * i) : third) + '\n';
    return table;
}

} // namespace

class TestCraftedTables : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QCOMPARE(runProgram({QStringLiteral("new"), path("p.odo")}).exitStatus, 0); }

    void isReadOrRefused_data()
    {
        QTest::addColumn<QByteArray>("content");
        constexpr int sample = 8;
        int number = 0;
        for (const auto &[name, content] : tables()) {
            if (isWanted(++number, sample))
                QTest::addRow("%d %s", number, name.constData()) << content;
        }
        QVERIFY2(number >= 80, qPrintable(QString::number(number)));
    }
    void isReadOrRefused()
    {
        QFETCH(QByteArray, content);
        const QString table = path("table.csv");
        QFile file(table);
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate) &&
                file.write(content) == content.size());
        file.close();
        static int trial = 0;
        const QString project = path("p.odo");
        const QList<QStringList> calls{
            {QStringLiteral("import"), project, QStringLiteral("--trial"), QString::number(++trial),
             QStringLiteral("--track"), QStringLiteral("R=") + table},
            {QStringLiteral("layout"), QStringLiteral("add"), project, QStringLiteral("floor %1").arg(trial),
             table},
            {QStringLiteral("intrinsics"), QStringLiteral("import"), project, QStringLiteral("A"), table}};
        for (const QStringList &call : calls) {
            const QByteArray before = fileHash(project);
            const AttackedRun run = attacked(call);
            QVERIFY2(faultOf(run).isEmpty(), qPrintable(call.first() + QStringLiteral(": ") + faultOf(run)));
            QVERIFY2(run.exitStatus == 0 || fileHash(project) == before, qPrintable(call.first()));
        }
        const AttackedRun check = attacked({QStringLiteral("check"), project});
        QVERIFY2(check.exitStatus == 0, check.out.constData());
    }

private:
    using Tables = std::vector<std::pair<QByteArray, QByteArray>>;

    static Tables tables()
    {
        const QByteArray header = "t_s,x_mm,y_mm";
        Tables tables{{"empty", ""},
                      {"a line end", "\n"},
                      {"zeros", QByteArray(100'000, '\0')},
                      {"a header alone", header + "\n"},
                      {"one row", track(header, ",", 1)},
                      {"two rows", track(header, ",", 2)},
                      {"no header", track("", ",", 50).mid(1)},
                      {"the header twice", header + "\n" + track(header, ",", 50)},
                      {"a mark at its beginning", "\xef\xbb\xbf" + track(header, ",", 50)},
                      {"UTF-16", QByteArray("\xff\xfe", 2) + QByteArray("t\0_\0s\0,\0", 8)},
                      {"Latin-1", "t_s,x_mm,y_mm,\xe4\xf6\xfc\n" + track(header, ",", 5)},
                      {"one long line", QByteArray(2'000'000, '1')},
                      {"a million commas", QByteArray(1'000'000, ',')},
                      {"a hundred thousand quotes", QByteArray(100'001, '"')},
                      {"carriage returns", track(header, ",", 50).replace('\n', '\r')},
                      {"both line ends", track(header, ",", 50).replace("\n", "\r\n")},
                      {"a YAML bomb", "a: &a [x,x,x]\nb: &b [*a,*a,*a]\nc: [*b,*b,*b]\n"},
                      {"deep brackets", QByteArray(100'000, '[')},
                      {"a formula", track(header, ",", 50, "=1+1")},
                      {"control characters", "t_s,\x1b[2Jx_mm,y_mm\n" + track(header, ",", 5)}};
        for (const QByteArray separator : {";", "\t", "|", " ", ":", "  "})
            tables.emplace_back("separated by '" + separator + "'",
                                track(QByteArray(header).replace(",", separator), separator, 50));
        for (const QByteArray value :
             {"nan", "inf", "-inf", "1e300", "-1e300", "1e-300", "", " ", "\"", "1,5", "1.5.5", "0x10", "1e",
              "abc", "１２", "∞", "1'000", "--5", "9999999999999999999999"})
            tables.emplace_back("the value " + value, track(header, ",", 50, value));
        for (const QByteArray names :
             {"t,x,y", "time,x,y", "t_s,x_mm,x_mm", "t_s,y_mm,x_mm", "a,b,c", "x_mm,y_mm,t_s", "t_s,x_m,y_m",
              "t_s,x_mm", "t_s,x_mm,y_mm,t_s", ",,", "label,x_mm,y_mm", "label,u,v", "camera_name,fx,fy",
              "T_S,X_MM,Y_MM", "t_s, x_mm , y_mm", "\"t_s\",\"x_mm\",\"y_mm\""})
            tables.emplace_back("the header " + names, track(names, ",", 50));
        addTimes(tables, header);
        addMarkers(tables);
        return tables;
    }

    static void addTimes(Tables &tables, const QByteArray &header)
    {
        const auto times = [&](const char *name, const std::function<double(int)> &time) {
            QByteArray table = header + '\n';
            for (int i = 0; i < 60; ++i)
                table += QByteArray::number(time(i), 'g', 17) + ',' + QByteArray::number(i) + ',' +
                         QByteArray::number(-i) + '\n';
            tables.emplace_back(name, table);
        };
        times("times that stand", [](int) { return 1.0; });
        times("times that go back", [](int i) { return -i / 30.0; });
        times("times that jump", [](int i) { return i < 30 ? i / 30.0 : 1e6 + i; });
        times("times of a century", [](int i) { return 1e9 * i; });
        times("times beyond any clock", [](int i) { return 1e290 * i; });
        times("times since 1970 in ns", [](int i) { return 1.7e18 + 3e7 * i; });
        times("negative times", [](int i) { return -100 + i / 30.0; });
        times("times a nanosecond apart", [](int i) { return 1e-9 * i; });
        times("repeated times", [](int i) { return (i / 2) / 30.0; });
    }

    static void addMarkers(Tables &tables)
    {
        const QByteArray header = "label,x_mm,y_mm\n";
        tables.emplace_back("markers in one place", header + "O,0,0\nU,0,0\nV,0,0\nD,0,0\n");
        tables.emplace_back("markers on a line", header + "O,0,0\nU,1,0\nV,2,0\nD,3,0\n");
        tables.emplace_back("markers far away", header + "O,1e300,0\nU,1,0\nV,0,1e300\nD,1,1\n");
        tables.emplace_back("markers of one name", header + "O,0,0\nO,1,0\nO,0,1\nO,1,1\n");
        tables.emplace_back("markers without names", header + ",0,0\n,1,0\n,0,1\n");
        tables.emplace_back("a marker with a long name",
                            header + QByteArray(100'000, 'n') + ",0,0\nU,1000,0\nV,0,1000\n");
        tables.emplace_back("a marker that is an escape", header + "\x1b[31m,0,0\nU,1000,0\nV,0,1000\n");
        QByteArray many = header;
        for (int i = 0; i < 100'000; ++i)
            many += 'm' + QByteArray::number(i) + ',' + QByteArray::number(i) + ",0\n";
        tables.emplace_back("a hundred thousand markers", many);
        tables.emplace_back("lens of nonsense", "image_width: -1\nimage_height: 1e9\ncamera_matrix: {rows: "
                                                "3, cols: 3, data: [nan,0,0,0,1e300,0,0,0,1]}\n");
        tables.emplace_back("lens without a matrix", "image_width: 640\nimage_height: 480\n");
        tables.emplace_back("lens with two thousand million rows",
                            "image_width: 640\nimage_height: 480\ncamera_matrix: {rows: 2000000000, cols: 3, "
                            "data: [1,0,0]}\n");
        tables.emplace_back("OpenCV's lens, cut",
                            "%YAML:1.0\n---\ncamera_matrix: !!opencv-matrix\n   rows: 3\n");
    }

    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    QTemporaryDir m_folder;
};

ODOGRAPH_TEST(TestCraftedTables, QCoreApplication)
#include "tst_crafted_tables.moc"
