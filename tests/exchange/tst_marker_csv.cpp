// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/labelled_points.h"
#include "core/exchange/text_file.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestMarkerCsv : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void readsWhatPeopleWrite_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("plain") << QByteArray("label,x_mm,y_mm\nO,0,0\nU Ü,-2000.5,1e2\n");
        QTest::newRow("mark, CRLF, quotes, blank lines") << QByteArray(
            "\xef\xbb\xbf\"label\",x_mm,y_mm\r\n\r\nO, 0 ,0\r\n\"U Ü\",\"-2000.5\",+100\r\n\r\n");
        QTest::newRow("no line end") << QByteArray("label,x_mm,y_mm\nO,0,0\nU Ü,-2000.5,100");
    }
    void readsWhatPeopleWrite()
    {
        QFETCH(QByteArray, text);
        const auto layout = readLayoutCsv(write(text));
        QVERIFY2(layout.has_value(), layout ? "" : layout.error().message().c_str());
        QCOMPARE(layout->markers.size(), std::size_t(2));
        QCOMPARE(layout->markers[1].label, std::string("U Ü"));
        QCOMPARE(layout->markers[1].pointInWorld.x(), -2.0005);
        QCOMPARE(layout->markers[1].pointInWorld.y(), 0.1);
    }

    void refusesWithFileAndLine_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QByteArray &text, const char *message) {
            QTest::newRow(name) << text << QString::fromUtf8(message);
        };
        row("empty", "", ":1: the file is empty; begin the file with the line label,x_mm,y_mm");
        row("no header", "O,0,0\n", ":1: it lacks the expected header line");
        row("semicolons", "label;x_mm;y_mm\nO;0;0\n", ":1: its columns are separated by semicolons");
        row("header only", "label,x_mm,y_mm\n", ":1: no markers");
        row("doubled", "label,x_mm,y_mm\nO,0,0\nO,1,1\n", ":3: line 2 already has the label 'O'");
        row("not finite", "label,x_mm,y_mm\nO,0,nan\n", ":2: y_mm 'nan' is not a finite number");
        row("too large", "label,x_mm,y_mm\nO,1e999,0\n", ":2: x_mm '1e999' is not a finite number");
        row("decimal comma", "label,x_mm,y_mm\nO,\"1,5\",0\n", ":2: x_mm '1,5' is not a finite number");
        row("cells missing", "label,x_mm,y_mm\n\nO,1\n", ":3: it has 2 cells instead of 3");
        row("no label", "label,x_mm,y_mm\n,1,2\n", ":2: the label is empty");
        row("open quote", "label,x_mm,y_mm\n\"O,1,2\n", ":2: a quoted cell does not end");
        row("text after quote", "label,x_mm,y_mm\n\"O\"x,1,2\n", ":2: a quoted cell does not end");
        row("UTF-16", QByteArray("\xff\xfel\0a\0", 6),
            "it is written in UTF-16; save it again as \"CSV UTF-8\"");
        row("no text", QByteArray("label\0", 6), "it is not a UTF-8 text file");
    }
    void refusesWithFileAndLine()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);
        const auto layout = readLayoutCsv(write(text));
        QVERIFY(!layout.has_value());
        QCOMPARE(layout.error().code, ErrorCode::InvalidInput);
        QVERIFY2(layout.error().message().find(message.toStdString()) != std::string::npos,
                 layout.error().message().c_str());
        QVERIFY(layout.error().message().find("markers.csv") != std::string::npos);
    }

    void refusesMissingAndHugeFiles()
    {
        QCOMPARE(readLayoutCsv("/no/such/file.csv").error().code, ErrorCode::NotFound);
        QCOMPARE(readLayoutCsv(m_folder.path().toStdString()).error().code, ErrorCode::InvalidInput);
        const auto huge = readLayoutCsv(write(QByteArray(2 * 1024 * 1024, 'x')));
        QVERIFY(huge.error().message().find("larger than 1024 KiB") != std::string::npos);
    }

    void readsPixels()
    {
        const auto pixels = readPixelsCsv(write("label,u,v\nO,207.14,1079.48\n"));
        QVERIFY(pixels.has_value());
        QCOMPARE(pixels->front().pixel.y(), 1079.48);
        QVERIFY(!readPixelsCsv(write("label,x_mm,y_mm\nO,1,2\n")).has_value());
    }

    void layoutsRoundTrip()
    {
        const MarkerLayout layout{"", {{"a,\"b\"", {1.0 / 3, -0.1}}, {"O", {0, 1e-9}}}};
        const std::filesystem::path file = write("");
        QVERIFY(writeLayoutCsv(file, layout).has_value());
        const auto read = readLayoutCsv(file);
        QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
        for (std::size_t i = 0; i < layout.markers.size(); ++i) {
            QCOMPARE(read->markers[i].label, layout.markers[i].label);
            // Metres to millimetres and back rounds twice.
            QVERIFY((read->markers[i].pointInWorld - layout.markers[i].pointInWorld).norm() < 1e-15);
        }
        QCOMPARE(writeLayoutCsv("/no/such/folder/a.csv", layout).error().code, ErrorCode::NotFound);
    }

    /// A spreadsheet takes no label for a formula, and the same labels are read back.
    void labelsAreNoFormulas()
    {
        MarkerLayout layout;
        for (const char *label : {"=1+1", "+x", "-x", "@x", "'=x", "''-x", "'x", "-1", "+2.5", "=a,\"b\""})
            layout.markers.push_back({label, {0, 0}});
        const std::filesystem::path file = write("");
        QVERIFY(writeLayoutCsv(file, layout));
        const std::string text = *readTextFile(file, 10000);
        QCOMPARE(text, std::string("label,x_mm,y_mm\n'=1+1,0,0\n'+x,0,0\n'-x,0,0\n'@x,0,0\n''=x,0,0\n'''-x,0,"
                                   "0\n'x,0,0\n-1,0,0\n+2.5,0,0\n"
                                   "\"'=a,\"\"b\"\"\",0,0\n"));
        const auto read = readLayoutCsv(file);
        QVERIFY2(read.has_value(), read ? "" : read.error().message().c_str());
        for (std::size_t i = 0; i < layout.markers.size(); ++i)
            QCOMPARE(read->markers[i].label, layout.markers[i].label);
    }

private:
    std::filesystem::path write(const QByteArray &text)
    {
        QFile file(m_folder.filePath(QStringLiteral("markers.csv")));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write the test's file");
        return file.fileName().toStdString();
    }
    QTemporaryDir m_folder;
};

ODOGRAPH_TEST(TestMarkerCsv, QCoreApplication)
#include "tst_marker_csv.moc"
