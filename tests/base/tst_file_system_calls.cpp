// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

/// std::filesystem throws where a path is too long, a folder is forbidden or the working directory is gone.
/// The program asks through core/base/file_system, so that none of its functions is called anywhere else.
class TestFileSystemCalls : public QObject
{
    Q_OBJECT
    /// Lines of a source that call it, or give it another name.
    static QStringList callsIn(const QString &source)
    {
        static const QRegularExpression call(
            QStringLiteral("std::filesystem::(?!path\\b|file_time_type\\b)\\w+|\\bfs::(?!path\\b)\\w+|using "
                           "namespace std::filesystem"));
        QStringList lines;
        const QStringList all = source.split(u'\n');
        for (qsizetype i = 0; i < all.size(); ++i)
            if (!all[i].trimmed().startsWith(u"//") && call.match(all[i]).hasMatch())
                lines << QString::number(i + 1) + QStringLiteral(": ") + all[i].trimmed();
        return lines;
    }

private Q_SLOTS:
    void callsAreFound()
    {
        QCOMPARE(callsIn(QStringLiteral(
                     "std::filesystem::path file;\n/// std::filesystem::exists\nfiles::exists(file);")),
                 QStringList());
        QCOMPARE(callsIn(QStringLiteral("\nif (std::filesystem::exists(file, problem))")),
                 QStringList(QStringLiteral("2: if (std::filesystem::exists(file, problem))")));
        QCOMPARE(callsIn(QStringLiteral("for (fs::directory_iterator each(folder);")).size(), 1);
    }

    void noneIsLeft()
    {
        const QDir tree(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR"));
        int sources = 0;
        QStringList found;
        for (const char *folder : {"core", "ui", "app"}) {
            QDirIterator each(tree.filePath(QLatin1String(folder)),
                              {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                              QDirIterator::Subdirectories);
            while (each.hasNext()) {
                QFile file(each.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                ++sources;
                if (each.fileName().startsWith(QLatin1String("file_system.")))
                    continue;
                for (const QString &line : callsIn(QString::fromUtf8(file.readAll())))
                    found << tree.relativeFilePath(each.filePath()) + u':' + line;
            }
        }
        QVERIFY(sources > 500);
        QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
    }
};

ODOGRAPH_TEST(TestFileSystemCalls, QCoreApplication)
#include "tst_file_system_calls.moc"
