// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/history/history_page.h"
#include "ui/history/internal/teams_panel.h"
#include "ui/main_window/language.h"
#include "ui/models/number_text.h"

#include <QApplication>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QLocale>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>

using namespace odo;

class TestLanguage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("odograph-test"));
        QCoreApplication::setApplicationName(QStringLiteral("tst_language"));
        installLanguage(*qApp, QStringLiteral("en"));
    }
    void oneIsNotMany()
    {
        QCOMPARE(HistoryPage::tr("%n trial(s)", "", 0), QStringLiteral("0 trials"));
        QCOMPARE(HistoryPage::tr("%n trial(s)", "", 1), QStringLiteral("1 trial"));
        QCOMPARE(HistoryPage::tr("%n trial(s)", "", 2), QStringLiteral("2 trials"));
    }
    /// What lupdate finds in the program stands in every language's file, finished.
    void everyLanguageIsComplete();
    /// What is marked within tr() lupdate does not find, so that no file is asked to have it.
    void noWordIsMarkedWithinTr();
    void placeholdersAndKeysAreKept_data() { eachLanguage(); }
    void placeholdersAndKeysAreKept();
    void everyHelpPageIsThere_data() { eachLanguage(); }
    void everyHelpPageIsThere();
    void wordsAndNumbersFollowTheLanguage_data();
    void wordsAndNumbersFollowTheLanguage();
    void whatIsNotKnownIsTheComputers();
    void everyFigureHasAName();

private:
    static void eachLanguage()
    {
        QTest::addColumn<QString>("code");
        for (const Language &each : languages())
            QTest::newRow(qPrintable(each.code)) << each.code;
    }
    QString m_root = qEnvironmentVariable("ODOGRAPH_SOURCE_DIR");
};

namespace {

struct Entry
{
    QString place, source;
    QStringList translations; ///< one a plural form
    bool isFinished = true, isCounted = false;
};

QList<Entry> messagesOf(const QString &ts)
{
    QFile file(ts);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(ts));
    QXmlStreamReader reader(&file);
    QList<Entry> messages;
    QString context;
    while (!reader.atEnd()) {
        if (reader.readNext() != QXmlStreamReader::StartElement)
            continue;
        const auto name = reader.name();
        if (name == QLatin1String("name")) {
            context = reader.readElementText();
        } else if (name == QLatin1String("message")) {
            messages << Entry{
                context, {}, {}, true, reader.attributes().hasAttribute(QLatin1String("numerus"))};
        } else if (name == QLatin1String("source")) {
            messages.last().source = reader.readElementText();
        } else if (name == QLatin1String("translation")) {
            messages.last().isFinished = !reader.attributes().hasAttribute(QLatin1String("type"));
            if (!messages.last().isCounted)
                messages.last().translations << reader.readElementText();
        } else if (name == QLatin1String("numerusform")) {
            messages.last().translations << reader.readElementText();
        }
    }
    return messages;
}

QStringList matches(const QString &text, const QString &pattern)
{
    QStringList found;
    auto each = QRegularExpression(pattern).globalMatch(text);
    while (each.hasNext())
        found << each.next().captured();
    found.sort();
    return found;
}

} // namespace

void TestLanguage::everyLanguageIsComplete()
{
    QTemporaryDir folder;
    QStringList files;
    for (const Language &each : languages()) {
        files << folder.filePath(each.code + QStringLiteral(".ts"));
        QVERIFY(QFile::copy(m_root + QStringLiteral("/translations/odograph_%1.ts").arg(each.code),
                            files.last()));
    }
    const QString lupdate = QLibraryInfo::path(QLibraryInfo::BinariesPath) + QStringLiteral("/lupdate");
    const QStringList scan{QStringLiteral("-silent"),
                           QStringLiteral("-no-obsolete"),
                           QStringLiteral("-tr-function-alias"),
                           QStringLiteral("QT_TRANSLATE_NOOP+=ODO_TEXT"),
                           QStringLiteral("-I"),
                           QStringLiteral("."),
                           QStringLiteral("core"),
                           QStringLiteral("ui")};
    for (const QStringList &one :
         {QStringList{QStringLiteral("-pluralonly"), QStringLiteral("-ts"), files.first()},
          QStringList{QStringLiteral("-ts")} + files.mid(1)}) {
        QProcess process;
        process.setWorkingDirectory(m_root);
        process.start(lupdate, scan + one);
        QVERIFY2(process.waitForFinished(120'000) && process.exitCode() == 0,
                 process.readAllStandardError().constData());
    }
    qsizetype counted = 0, missing = 0;
    for (const QString &file : files)
        for (const Entry &message : messagesOf(file)) {
            ++counted;
            if (!message.isFinished || message.translations.contains(QString())) {
                ++missing;
                qWarning().noquote() << QFileInfo(file).fileName() << message.place << message.source;
            }
        }
    QVERIFY(counted > 5 * 1500);
    QCOMPARE(missing, 0);
}

void TestLanguage::noWordIsMarkedWithinTr()
{
    static const QRegularExpression marked(QStringLiteral("\\btr\\(\\s*QT_TR[A-Z_]*NOOP"));
    int files = 0;
    for (QDirIterator each(m_root + QStringLiteral("/ui"), {QStringLiteral("*.cpp"), QStringLiteral("*.h")},
                           QDir::Files, QDirIterator::Subdirectories);
         each.hasNext();) {
        QFile file(each.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        QVERIFY2(!marked.match(text).hasMatch(), qPrintable(file.fileName()));
        ++files;
    }
    QVERIFY(files > 100);
}

void TestLanguage::placeholdersAndKeysAreKept()
{
    QFETCH(QString, code);
    const bool hasComma = QLocale(code).decimalPoint() == QStringLiteral(",");
    const QString measure = QStringLiteral("[0-9]\\.[0-9]+[ \u00a0](m|ms|σ|%)");
    const QString placeholder = QStringLiteral("%[0-9]"), key = QStringLiteral("&\\p{L}"),
                  pattern = QStringLiteral("\\*\\.\\w+");
    for (const Entry &message : messagesOf(m_root + QStringLiteral("/translations/odograph_%1.ts").arg(code)))
        for (const QString &translation : message.translations) {
            const QString words =
                message.place + QStringLiteral(": ") + message.source + QStringLiteral(" → ") + translation;
            QVERIFY2(matches(translation, placeholder) == matches(message.source, placeholder),
                     qPrintable(words));
            QVERIFY2(matches(translation, pattern) == matches(message.source, pattern), qPrintable(words));
            QVERIFY2(matches(translation, key).size() == matches(message.source, key).size(),
                     qPrintable(words));
            QVERIFY2(translation.endsWith(u'…') == message.source.endsWith(u'…'), qPrintable(words));
            QVERIFY2(!hasComma || matches(translation, measure).isEmpty(), qPrintable(words));
        }
}

void TestLanguage::everyHelpPageIsThere()
{
    QFETCH(QString, code);
    installLanguage(*qApp, QStringLiteral("en"));
    const QString tag = QStringLiteral("<[a-z0-9]+");
    for (const char *page : {"keys", "welcome", "testbed", "record", "review", "compare", "history"}) {
        installLanguage(*qApp, QStringLiteral("en"));
        const QString english = helpPage(QString::fromLatin1(page));
        installLanguage(*qApp, code);
        const QString shown = helpPage(QString::fromLatin1(page));
        QVERIFY2(shown.size() > 100, page);
        QCOMPARE(shown == english, code == QLatin1String("en"));
        QCOMPARE(matches(shown, tag).size(), matches(english, tag).size());
    }
}

void TestLanguage::wordsAndNumbersFollowTheLanguage_data()
{
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("teams");
    QTest::addColumn<QString>("number");
    QTest::newRow("en") << "en"
                        << "2 teams"
                        << "1.5";
    QTest::newRow("de") << "de"
                        << "2 Teams"
                        << "1,5";
    QTest::newRow("es") << "es"
                        << "2 equipos"
                        << "1,5";
    QTest::newRow("fr") << "fr" << QString::fromUtf8("2 équipes") << "1,5";
    QTest::newRow("ko") << "ko" << QString::fromUtf8("2팀") << "1.5";
    QTest::newRow("zh_CN") << "zh_CN" << QString::fromUtf8("2 个小组") << "1.5";
}

void TestLanguage::wordsAndNumbersFollowTheLanguage()
{
    QFETCH(QString, code);
    installLanguage(*qApp, code);
    QCOMPARE(shownLanguage(), code);
    QTEST(TeamsPanel::tr("%n team(s)", "", 2), "teams");
    QTEST(QLocale().toString(1.5, 'f', 1), "number");
}

void TestLanguage::whatIsNotKnownIsTheComputers()
{
    installLanguage(*qApp, QStringLiteral("tlh"));
    QVERIFY(
        std::ranges::any_of(languages(), [](const Language &each) { return each.code == shownLanguage(); }));
    chooseLanguage(QStringLiteral("fr"));
    QCOMPARE(chosenLanguage(), QStringLiteral("fr"));
    chooseLanguage({});
    QVERIFY(chosenLanguage().isEmpty());
}

/// None that core computes is shown by the name that files have for it.
void TestLanguage::everyFigureHasAName()
{
    installLanguage(*qApp, QStringLiteral("fr"));
    static const QRegularExpression figure(
        QStringLiteral("\"([a-z0-9_]+)\",\\s*\"(?:1|s|m|m/s|m/s²|rad/s)\""));
    int count = 0;
    for (const char *file : {"metrics", "task_metrics"}) {
        QFile source(m_root + QStringLiteral("/core/analysis/%1.cpp").arg(QLatin1String(file)));
        QVERIFY(source.open(QIODevice::ReadOnly));
        auto each = figure.globalMatch(QString::fromUtf8(source.readAll()));
        while (each.hasNext()) {
            const QString name = each.next().captured(1);
            QString plain = name;
            plain.replace(u'_', u' ');
            QVERIFY2(metricName(name.toStdString()).compare(plain, Qt::CaseInsensitive) != 0,
                     qPrintable(name));
            ++count;
        }
    }
    QVERIFY(count > 15);
}

ODOGRAPH_TEST(TestLanguage, QApplication)
#include "tst_language.moc"
