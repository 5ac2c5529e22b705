// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/main_window/language.h"
#include "ui/models/shown_message.h"
#include "ui/models/shown_names.h"

#include <QCoreApplication>
#include <QFile>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>

using namespace odo;

namespace {

/// A language of a few words.
class German : public QTranslator
{
public:
    German()
    {
        QCoreApplication::installTranslator(this);
        QLocale::setDefault(QLocale(QLocale::German));
    }
    ~German() override { QCoreApplication::removeTranslator(this); }
    bool isEmpty() const override { return false; }
    QString translate(const char *context, const char *source, const char *, int) const override
    {
        static const QHash<QString, QString> words{
            {QStringLiteral("test.apart"), QStringLiteral("%2 und %1 liegen %3 auseinander")},
            {QStringLiteral("test.team"), QStringLiteral("Team „%1“")},
            {QStringLiteral("test.known"), QStringLiteral("%1 ist bekannt")},
        };
        return words.value(QString::fromUtf8(context), QString::fromUtf8(source));
    }
};

struct Known
{
    QByteArray code, english;
};

/// All that the program says by messages, as the translation tool found it.
QList<Known> knownMessages()
{
    QFile file(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR") + QStringLiteral("/translations/odograph_de.ts"));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(file.fileName()));
    QXmlStreamReader reader(&file);
    QList<Known> known;
    QByteArray context;
    while (!reader.atEnd()) {
        if (reader.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (reader.name() == QLatin1String("name"))
            context = reader.readElementText().toUtf8();
        else if (reader.name() == QLatin1String("source") && context.contains('.'))
            known << Known{context, reader.readElementText().toUtf8()};
    }
    return known;
}

/// What is typed there is of no use in a window.
bool namesCommandLine(const QString &words)
{
    static const QRegularExpression typed(QStringLiteral("(^|[\\s(])(--[a-z]|odograph [a-z])"));
    return typed.match(words).hasMatch();
}

} // namespace

class TestShownMessage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("odograph-test"));
        QCoreApplication::setApplicationName(QStringLiteral("tst_shown_message"));
    }
    void cleanup()
    {
        QLocale::setDefault(QLocale::c());
        knowPseudonyms({});
        showPseudonyms(false);
    }
    void wordsAndNumbersAreOfTheLanguage()
    {
        const German german;
        const Message apart = ODO_TEXT("test.apart", "%1 and %2 are %3 apart")(
            Named::camera("Left"), Named::camera("%1"), quantity(1234.56, 1, "mm"));
        QCOMPARE(shownWords(apart), QStringLiteral("%1 und Left liegen 1234,6 mm auseinander"));
        const Message nested = ODO_TEXT("test.known", "%1 is known")(apart);
        QCOMPARE(shownWords(nested), QStringLiteral("%1 und Left liegen 1234,6 mm auseinander ist bekannt"));
        QCOMPARE(shownWords(foreignWords("no such device")), QStringLiteral("no such device"));
        QCOMPARE(shownWords(Message()), QString());
    }
    void errorsAreSentences()
    {
        const Error error{ErrorCode::NotFound, nameAlone(Named::file("hall.csv")),
                          ODO_TEXT("test.gone", "it is gone"), ODO_TEXT("test.bring", "bring it back")};
        QCOMPARE(errorInWords(error), QStringLiteral("Hall.csv: it is gone. Bring it back."));
        QCOMPARE(errorLine(error), QStringLiteral("hall.csv: it is gone; bring it back"));
        const Error bare{ErrorCode::NotFound, nameAlone(Named::file("hall.csv")), {}, {}};
        QCOMPARE(errorInWords(bare), QStringLiteral("Hall.csv."));
    }
    void namesThatAreWrittenBackwardsAreToldPlainly()
    {
        QCOMPARE(shownWords(nameAlone(Named::robot("a\u202eb"))), QStringLiteral("a‹U+202E›b"));
    }
    /// Wherever a message is shown, and also within another one.
    void teamsAreShownByPseudonym()
    {
        const Message twice = ODO_TEXT("test.twice", "%1 is there twice in %2")(
            Named::person("Anna"), ODO_TEXT("test.team", "team '%1'")(Named::team("Anna and Ben")));
        const std::vector<TeamRecord> teams{{1, "Anna and Ben", "9B", "Team 4", {"Anna", "Ben"}},
                                            {2, "Owl", "9B"}};
        knowPseudonyms(teams);
        QCOMPARE(shownWords(twice), QStringLiteral("Anna is there twice in team 'Anna and Ben'"));
        showPseudonyms(true);
        QCOMPARE(shownWords(twice), QStringLiteral("… is there twice in team 'Team 4'"));
        QCOMPARE(shownWords(nameAlone(Named::team("Owl"))), QStringLiteral("Owl"));
    }
    /// A code has words of its own, so that a word which is changed at one place changes no other's
    /// translation.
    void eachCodeHasItsOwnWords()
    {
        const QList<Known> known = knownMessages();
        QVERIFY(known.size() > 900);
        static const QRegularExpression form(QStringLiteral("^[a-z0-9]+\\.[a-z0-9_]+$"));
        QHash<QByteArray, QByteArray> words;
        for (const Known &each : known) {
            QVERIFY2(form.match(QString::fromUtf8(each.code)).hasMatch(), each.code.constData());
            QVERIFY2(!words.contains(each.code), each.code.constData());
            words.insert(each.code, each.english);
        }
    }
    void eachCodeIsSaidInEachLanguage_data()
    {
        QTest::addColumn<QString>("code");
        for (const Language &each : languages())
            QTest::newRow(qPrintable(each.code)) << each.code;
    }
    void eachCodeIsSaidInEachLanguage()
    {
        QFETCH(QString, code);
        installLanguage(*qApp, code);
        static const QRegularExpression placeholder(QStringLiteral("%[1-9]"));
        qsizetype asInEnglish = 0, forTyping = 0;
        const QList<Known> known = knownMessages();
        for (const Known &each : known) {
            const MessageText text{each.code.constData(), each.english.constData()};
            Message message(text);
            for (int i = 1; i <= 9; ++i)
                message.arguments.emplace_back("<" + std::to_string(i) + ">");
            const QString shown = shownWords(message);
            QVERIFY2(!shown.isEmpty() && !shown.contains(placeholder), text.code);
            QVERIFY2(!namesCommandLine(shown), text.code);
            for (int i = 1; i <= 9; ++i)
                QVERIFY2(shown.contains(QStringLiteral("<%1>").arg(i)) ==
                             each.english.contains("%" + QByteArray::number(i)),
                         text.code);
            asInEnglish += shown.toStdString() == message.english();
            // the window asks for a password itself
            const bool isOtherInWindows =
                each.code == "school.check_connection" || each.code == "school.password_place";
            forTyping += namesCommandLine(QString::fromUtf8(each.english)) || isOtherInWindows;
        }
        if (code == QStringLiteral("en"))
            QCOMPARE(asInEnglish, known.size() - forTyping);
        else // those of placeholders and signs alone, and a few words that are the same
            QVERIFY2(asInEnglish < known.size() / 20, qPrintable(QString::number(asInEnglish)));
        installLanguage(*qApp, QStringLiteral("en"));
    }
};

ODOGRAPH_TEST(TestShownMessage, QCoreApplication)
#include "tst_shown_message.moc"
