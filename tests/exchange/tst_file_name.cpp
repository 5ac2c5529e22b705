// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/file_name.h"

#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

/// Names that people give, hostile ones among them, as names of files.
class TestFileName : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void names_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("file");
        const auto row = [](const char *tag, const QByteArray &name, const QByteArray &file) {
            QTest::newRow(tag) << name << file;
        };
        row("plain", "Trial 1", "Trial 1");
        row("other scripts", "주행 1 Prüfung", "주행 1 Prüfung");
        row("an emoji", "run 🤖", "run 🤖");
        row("out of the folder", "../../etc/passwd", "-..-..-etc-passwd");
        row("a path", "/etc/passwd", "-etc-passwd");
        row("the folder above", "..", "-");
        row("the folder itself", ".", "-");
        row("hidden", ".bashrc", "-.bashrc");
        row("other systems", "a:b*c?\"<>|\\", "a-b-c------");
        row("NUL", QByteArray("a\0b", 3), "a-b");
        row("line ends", "a\r\nb\tc", "a--b-c");
        row("right to left", "a\xe2\x80\xaetxt.exe",
            "a-txt.exe"); // NOLINT(misc-misleading-bidirectional): such a name is what is asked about
        row("invisible",
            "a\xe2\x80\x8b\xef\xbb\xbf"
            "b",
            "a--b");
        row("a line separator",
            "a\xe2\x80\xa8"
            "b",
            "a-b");
        row("no UTF-8",
            "a\xff"
            "b",
            "a-b");
        row("blanks and dots at the end", "run . . ", "run");
        row("nothing", "", "-");
        row("blanks", "   ", "-");
        row("a device", "con", "_con");
        row("a device with an ending", "LPT1.tar", "_LPT1.tar");
        row("no device", "COM10", "COM10");
        row("no device either", "console", "console");
        row("long", QByteArray(10000, 'x'), QByteArray(180, 'x'));
        row("long, of three bytes each", QByteArray("주").repeated(5000), QByteArray("주").repeated(60));
        row("long, of four bytes each", QByteArray("🤖").repeated(5000), QByteArray("🤖").repeated(45));
    }
    void names()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, file);
        const std::string proposed = fileNameOf(name.toStdString());
        QCOMPARE(QByteArray::fromStdString(proposed), file);
        QCOMPARE(fileNameOf(proposed), proposed); // nothing is left to replace
        // Such a file can be made, and lies where it should.
        const QTemporaryDir folder;
        const QString path =
            QDir(folder.path()).filePath(QString::fromStdString(proposed) + QStringLiteral(".csv"));
        QFile made(path);
        QVERIFY(made.open(QIODevice::WriteOnly));
        QCOMPARE(QFileInfo(path).canonicalPath(), QFileInfo(folder.path()).canonicalFilePath());
    }
};

ODOGRAPH_TEST(TestFileName, QCoreApplication)
#include "tst_file_name.moc"
