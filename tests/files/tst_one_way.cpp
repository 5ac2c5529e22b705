// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sources: files for people are written through core/files alone.
#include "tests/support/registered_test.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

class TestOneWay : public QObject
{
    Q_OBJECT

    /// Files that open others to write them, and may: with what for.
    static const QHash<QString, QString> &known()
    {
        static const QHash<QString, QString> all{
            {QStringLiteral("core/exchange/project_archive.cpp"),
             QStringLiteral("what is unpacked, in a TemporaryFolder")},
            {QStringLiteral("app/commands/track_import.cpp"),
             QStringLiteral("standard input, in the folder for temporary files")},
            {QStringLiteral("app/workbench.cpp"),
             QStringLiteral("asks Qt which kinds of pictures it writes, and writes none")},
            {QStringLiteral("core/project/write_ahead_log.cpp"),
             QStringLiteral("a copy to be read, in the folder for temporary files")},
            {QStringLiteral("core/project/project_locks.cpp"), QStringLiteral("locks")},
            {QStringLiteral("core/project/new_file.cpp"), QStringLiteral("a database, in a TemporaryFolder")},
            {QStringLiteral("core/video/internal/claimed_output.cpp"),
             QStringLiteral("recordings, in files whose names were claimed")},
            {QStringLiteral("core/video/video_writer.cpp"),
             QStringLiteral("the temporary file of an OutputFile")}};
        return all;
    }

private Q_SLOTS:
    void noOtherSourceOpensFilesToWrite()
    {
        static const QRegularExpression opens(
            QStringLiteral("std::(o|)fstream|QSaveFile|O_CREAT|FileHandle::(create|openOrCreate)|AVIO_FLAG_"
                           "WRITE|\\bfopen\\(|\\bQPdfWriter "
                           "\\w+\\(Q|setOutputFileName|QImageWriter|\\bQFile \\w+[^;]*;\\s*[^;]*WriteOnly"));
        const QString root = qEnvironmentVariable("ODOGRAPH_SOURCE_DIR");
        QStringList found;
        int count = 0;
        for (const char *folder : {"app", "core", "ui"}) {
            QDirIterator each(root + u'/' + QLatin1String(folder),
                              {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                              QDirIterator::Subdirectories);
            while (each.hasNext()) {
                const QString name = each.next().mid(root.size() + 1);
                QFile file(root + u'/' + name);
                QVERIFY(file.open(QIODevice::ReadOnly));
                ++count;
                if (!name.startsWith(QLatin1String("core/files/")) &&
                    !name.startsWith(QLatin1String("core/base/platform/")) && // what the others call
                    opens.match(QString::fromUtf8(file.readAll())).hasMatch())
                    found << name;
            }
        }
        QVERIFY(count > 300);
        found.sort();
        QStringList allowed = known().keys();
        allowed.sort();
        QCOMPARE(found.join(u'\n'), allowed.join(u'\n'));
    }
};

ODOGRAPH_TEST(TestOneWay, QCoreApplication)
#include "tst_one_way.moc"
