// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

using namespace odo;
using namespace odo::test;
using namespace Qt::StringLiterals;

/// `export --format html` as scripts call it.
class TestHtmlExport : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    QString m_project;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    ProgramRun exported(const QStringList &arguments) const
    {
        return runProgram(QStringList{u"export"_s, m_project} + arguments +
                          QStringList{u"--format"_s, u"html"_s});
    }
    static QByteArray read(const QString &file)
    {
        QFile page(file);
        return page.open(QIODevice::ReadOnly) ? page.readAll() : QByteArray();
    }
    static bool isWellFormed(const QByteArray &page)
    {
        QXmlStreamReader xml(page);
        while (!xml.atEnd())
            xml.readNext();
        return !page.isEmpty() && !xml.hasError();
    }

private Q_SLOTS:
    void initTestCase()
    {
        const auto file = storeExample(m_folder.path().toStdString());
        QVERIFY(file.has_value());
        m_project = QString::fromStdString(file->string());
    }

    void theFiguresAreThoseOfShow()
    {
        const QString file = path("run.html");
        const ProgramRun run = exported({u"Trial 1"_s, u"-o"_s, file, u"--json"_s});
        QVERIFY2(run.exitStatus == 0, run.err.constData());
        QCOMPARE(run.json().value(u"file"_s).toString(), file);
        QCOMPARE(run.json().value(u"format"_s).toString(), u"html"_s);
        const QByteArray page = read(file);
        QCOMPARE(run.json().value(u"bytes"_s).toInteger(), page.size());
        QVERIFY(isWellFormed(page));
        const QJsonObject shown = runProgram({u"show"_s, m_project, u"Trial 1"_s, u"--json"_s})
                                      .json()
                                      .value(u"robots"_s)
                                      .toObject();
        const QJsonArray metrics = shown.begin().value().toObject().value(u"metrics"_s).toArray();
        QVERIFY(!metrics.isEmpty());
        for (const QJsonValue &metric : metrics) {
            const QString exact = QString::number(metric.toObject().value(u"value"_s).toDouble(), 'g',
                                                  QLocale::FloatingPointShortest);
            QVERIFY2(page.contains("value=\"" + exact.toLatin1() + '"'), qPrintable(exact));
        }
    }

    void severalTrialsAreOnePage()
    {
        const QString file = path("both.html");
        QCOMPARE(exported({u"Trial 1"_s, u"Trial 2"_s, u"-o"_s, file}).exitStatus, 0);
        const QByteArray page = read(file);
        QVERIFY(isWellFormed(page));
        QVERIFY(page.contains("Comparison"));
        const ProgramRun printed = exported({u"Trial 1"_s, u"Trial 2"_s, u"-o"_s, u"-"_s});
        QVERIFY2(printed.exitStatus == 0, printed.err.constData());
        QCOMPARE(printed.out, page);
        const ProgramRun german = exported({u"Trial 1"_s, u"-o"_s, u"-"_s, u"--language"_s, u"de"_s});
        QVERIFY(german.out.contains("<html lang=\"de\">"));
        QVERIFY(german.out.contains("Höchstgeschw."));
    }

    void theGuardOfOutputs()
    {
        QFile other(path("letter.txt"));
        QVERIFY(other.open(QIODevice::WriteOnly) && other.write("a letter to nobody") > 0);
        other.close();
        const ProgramRun refused = exported({u"Trial 1"_s, u"-o"_s, path("letter.txt")});
        QCOMPARE(refused.exitStatus, 2);
        QVERIFY(refused.err.contains("another kind"));
        QCOMPARE(read(path("letter.txt")), QByteArray("a letter to nobody"));
        QCOMPARE(exported({u"Trial 1"_s, u"-o"_s, path("letter.txt"), u"--force"_s}).exitStatus, 0);
        QCOMPARE(exported({u"Trial 1"_s, u"-o"_s, path("letter.txt")}).exitStatus, 0); // a page now
        QCOMPARE(exported({u"Trial 1"_s, u"-o"_s, m_project}).exitStatus, 2);
        QCOMPARE(exported({u"Trial 1"_s, u"-o"_s, m_folder.path()}).exitStatus, 2);
        QCOMPARE(exported({u"Trial 1"_s, u"-o"_s, path("a.html"), u"--columns"_s, u"t_s"_s}).exitStatus, 2);
        QCOMPARE(exported({u"Trial 3"_s, u"-o"_s, path("a.html")}).exitStatus, 1);
        QCOMPARE(exported({u"None"_s, u"-o"_s, path("a.html")}).exitStatus, 1);
        QVERIFY(!QFile::exists(path("a.html")));
    }
};

ODOGRAPH_TEST(TestHtmlExport, QCoreApplication)
#include "tst_html_export.moc"
