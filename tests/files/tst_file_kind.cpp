// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_kind.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

/// What a file is told to be by its first bytes.
class TestFileKind : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void kinds_data()
    {
        QTest::addColumn<QByteArray>("start");
        QTest::addColumn<FileKind>("kind");
        const QByteArray sqlite = QByteArray("SQLite format 3").append(53, '\0');
        const auto add = [](const char *name, const QByteArray &start, FileKind kind) {
            QTest::newRow(name) << start << kind;
        };
        add("nothing", "", FileKind::Empty);
        add("PDF", "%PDF-1.4\n", FileKind::Pdf);
        add("PNG", QByteArray("\x89PNG\r\n\x1a\n", 8), FileKind::Png);
        add("JPEG", QByteArray("\xff\xd8\xff\xe0", 4), FileKind::Jpeg);
        add("MP4",
            QByteArray("\0\0\0\x20"
                       "ftypisom",
                       12),
            FileKind::Mp4);
        add("Matroska", QByteArray("\x1a\x45\xdf\xa3\x01", 5), FileKind::Matroska);
        add("ZIP", "PK\x03\x04", FileKind::Zip);
        add("workbook", QByteArray("PK\x03\x04\x14") + "[Content_Types].xml..PK..xl/workbook.xml",
            FileKind::Xlsx);
        add("document", QByteArray("PK\x03\x04\x14") + "[Content_Types].xml..PK..word/document.xml",
            FileKind::Zip);
        add("project", sqlite + "Odog" + QByteArray(30, '\0'), FileKind::Project);
        add("other database", sqlite + QByteArray(34, '\0'), FileKind::Database);
        add("database cut off", sqlite.left(40), FileKind::Database);
        add("HTML", "\n<!DOCTYPE html>\n<html><body><svg/></body></html>", FileKind::Html);
        add("HTML without a type", "<HTML lang=\"en\">", FileKind::Html);
        add("SVG", "<?xml version=\"1.0\"?>\n<svg width=\"1\"/>", FileKind::Svg);
        add("markup", "<note></note>", FileKind::Text);
        add("JSON", " \n{\"trial\": 1}", FileKind::Json);
        add("ROS", "image_width: 640\nimage_height: 480\n", FileKind::Yaml);
        add("OpenCV", "%YAML:1.0\n---\n", FileKind::Yaml);
        add("CSV", "t_s,x_mm,y_mm\n0,1,2\n", FileKind::Csv);
        add("CSV, header alone", "label,x_mm,y_mm\n", FileKind::Csv);
        add("CSV with mark and ;", "\xef\xbb\xbft_s;x_mm;y_mm\r\n0,5;1,5;2,5\r\n", FileKind::Csv);
        add("CSV, cell in quotes", "label,x_mm,y_mm\n\"a,b\",1,2\n", FileKind::Csv);
        add("CSV, second line cut off", "t_s,x_mm,y_mm\n0,1", FileKind::Csv);
        add("rows differ", "a,b,c\n1,2\n", FileKind::Text);
        add("letter", "Dear Anna, hello\n", FileKind::Text);
        add("note", "remember\nthe milk\n", FileKind::Text);
        add("TUM", "0.5 1 2 0 0 0 0 1\n", FileKind::Tum);
        add("TUM with remark", "# timestamp tx ty tz\n0.5 -1e-3 2 0 0 0 0 1\n", FileKind::Tum);
        add("seven numbers", "0.5 1 2 0 0 0 0\n", FileKind::Text);
        add("remark alone", "# nothing\n", FileKind::Text);
        add("Tracker", "Red_2\nt\tx\ty\n0.0\t1.0\t2.0\n", FileKind::Tracker);
        add("bytes", QByteArray("a\0b", 3), FileKind::Other);
        add("far into a table", "a,b\n" + QByteArray("1,2\n").repeated(4000), FileKind::Csv);
    }
    void kinds()
    {
        QFETCH(QByteArray, start);
        QFETCH(FileKind, kind);
        QCOMPARE(int(kindOf({start.constData(), std::size_t(start.size())})), int(kind));
    }
};

ODOGRAPH_TEST(TestFileKind, QCoreApplication)
#include "tst_file_kind.moc"
