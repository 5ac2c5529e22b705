// SPDX-License-Identifier: GPL-3.0-or-later
// Each sentence that core's sources make is known to ui/models/core_words, so that none stays English in a
// window of another language. The sources are read, so that a new sentence is noticed before anybody makes
// core say it.
#include "tests/support/registered_test.h"
#include "tests/ui/support/core_sentences.h"
#include "ui/models/core_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QTest>
#include <QTranslator>
#include <algorithm>

using namespace odo;

namespace {

/// A language without a Latin letter: what stays Latin was not known.
class Language : public QTranslator
{
public:
    Language() { QCoreApplication::installTranslator(this); }
    ~Language() override { QCoreApplication::removeTranslator(this); }
    bool isEmpty() const override { return false; }
    QString translate(const char *, const char *source, const char *, int) const override
    {
        static const QRegularExpression letter(QStringLiteral("[A-Za-z]"));
        return QString::fromUtf8(source).replace(letter, QStringLiteral("ж"));
    }
};

/// Whether nothing English is left of a sentence but names in quotes, commands to type and columns of the
/// roster.
bool isKnownAsItIs(const QString &words)
{
    static const QRegularExpression kept(
        QStringLiteral("'\\w+'|\\b(?:odograph|sysctl) .*|\\b(?:class|team)$"));
    static const QRegularExpression english(QStringLiteral("[A-Za-z]{3,}"));
    return !shownWords(words).remove(kept).contains(english);
}

/// What may stand for a Q, besides the Q itself: figures with their units, several names, words of core.
const QStringList &computed()
{
    static const QStringList all{QStringLiteral("Q"),
                                 QStringLiteral("Q mm"),
                                 QStringLiteral("Q %"),
                                 QStringLiteral("Q s"),
                                 QStringLiteral("'Q'"),
                                 QStringLiteral(""),
                                 QStringLiteral(" (Q)"),
                                 QStringLiteral("camera 'Q'"),
                                 QStringLiteral("markers Q and Q"),
                                 QStringLiteral("all Q pictures"),
                                 QStringLiteral(" (Q the most)"),
                                 QStringLiteral("the picture"),
                                 QStringLiteral("errors"),
                                 QStringLiteral("line Q"),
                                 QStringLiteral("Q pictures were"),
                                 QStringLiteral("its zone 'Q'"),
                                 QStringLiteral("The lens calibration of camera 'Q'"),
                                 QStringLiteral("template"),
                                 QStringLiteral("the light flickers")};
    return all;
}

/// Whether core_words knows a sentence with something in the place of each Q; up to three of them.
bool isKnownFrom(const QString &words, qsizetype from, int places)
{
    const qsizetype at = words.indexOf(u'Q', from);
    if (at < 0 || places == 0)
        return isKnownAsItIs(words);
    return std::ranges::any_of(computed(), [&](const QString &each) {
        return isKnownFrom(QString(words).replace(at, 1, each), at + each.size(), places - 1);
    });
}

bool isKnown(const QString &sentence)
{
    static const QRegularExpression before(QStringLiteral("^Q+(?=[a-z])")), after(QStringLiteral(":$")),
        several(QStringLiteral("QQ+"));
    const QString words =
        sentence.simplified().remove(before).remove(after).replace(several, QStringLiteral("Q"));
    return isKnownAsItIs(words) || isKnownAsItIs(words + QStringLiteral(" (Q)")) ||
           isKnownFrom(words, 0, 3) || std::ranges::any_of(computed(), [&](const QString &each) {
               return isKnownAsItIs(QString(words).replace(u'Q', each));
           });
}

} // namespace

class TestCoreSentences : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void sourcesAreRead_data();
    void sourcesAreRead();
    void placesAreTold();
    void whatIsNotKnownIsNoticed();
    void eachSentenceOfCoreIsKnown();
};

void TestCoreSentences::sourcesAreRead_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("words");
    const auto add = [](const char *name, const char *source, const char *words) {
        QTest::newRow(name) << QString::fromUtf8(source) << QString::fromUtf8(words);
    };
    add("nothing", "", "");
    add("no error", "f(g(\"not said\")); // fail(\"nor this\")\n/* fail(\"or this\") */", "");
    add("literals", R"(fail(c, "one " "two", "a \"b\" thing", what);)", "one two|a \"b\" thing");
    add("sum", R"(fail(c, n, "it has " + std::to_string(f(1, 'x')) + " parts", "");)", "it has Q parts");
    add("choice", R"(fail(c, a::b ? "yes" + x : y ? "or" : std::string("maybe"), "");)", "yesQ|maybe");
    add("brackets", R"(fail(c, "no" + (n == 1 ? " thing" : " things") + there);)", "no thingQ|no thingsQ");
    add("raw text", "auto q = R\"(\"fail(\"x\"\n)\"; fail(c, \"after it\");", "after it");
    add("digits", "n = 1'000'000; fail(c, \"after it\");", "after it");
    add("own maker", R"(tl::unexpected<Error> refuse(int a); f(refuse("out of paper"));)", "out of paper");
    add("lambda", R"(const auto no = [&](auto why) { return fail(c, why); }; no("out of ink");)",
        "out of ink");
    add("Error itself", R"(note(Error{code, "the hall", "it is shut"});)", "the hall|it is shut");
    add("by name", R"(m_why = "rain"; auto whatToUse{"wood"}; if (why == "snow") x.advice += "; stay";)",
        "rain|wood|; stay");
    add("list", R"(m_warnings.push_back(name + ": cold"); somewhat["gone"] = 1;)", "Q: cold");
    add("in braces", R"(return {ErrorCode::Io, n + " is off", "turn it on"};)", "Q is off|turn it on");
    add("one of a list", R"(m_told.push_back({file, "it is cut" + off}))", "it is cutQ");
    add("a job's progress", R"(m_control.report(0.5, "reading " + file); report("not this");)", "reading Q");
    add("printed", R"(std::snprintf(why, sizeof why, "of %.1f s %zu %% went", a, b);)", "of Q s Q % went");
    add("without an end", R"(fail(c, "cut off", ()", "cut off");
}

void TestCoreSentences::sourcesAreRead()
{
    QFETCH(QString, source);
    QStringList words;
    for (const CoreSentence &each : sentencesIn(source, QStringLiteral("a.cpp"), errorMakers(source)))
        words << each.words;
    QTEST(words.join(u'|'), "words");
}

void TestCoreSentences::placesAreTold()
{
    const auto sentences = sentencesIn(QStringLiteral("// one\n\nfail(c,\n  \"why\");"),
                                       QStringLiteral("a.cpp"), {QStringLiteral("fail")});
    QCOMPARE(sentences.size(), 1);
    QCOMPARE(sentences.first().place, QStringLiteral("a.cpp:4"));
}

void TestCoreSentences::whatIsNotKnownIsNoticed()
{
    const Language other;
    QVERIFY(isKnown(QStringLiteral("the disk is full")));
    QVERIFY(isKnown(QStringLiteral("Q lie only Q apart, too close for two of four")));
    for (const char *each :
         {"the disk is rather full", "the disk is full; and stays so", "Q apart", "of Q disks"})
        QVERIFY2(!isKnown(QString::fromUtf8(each)), each);
}

void TestCoreSentences::eachSentenceOfCoreIsKnown()
{
    const Language other;
    const auto sentences = coreSentences(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR"), QStringLiteral("core"));
    QVERIFY(sentences.size() > 1500);
    QStringList unknown;
    for (const CoreSentence &each : sentences)
        if (!isKnown(each.words))
            unknown << each.place + QStringLiteral(": ") + each.words;
    unknown.removeDuplicates();
    QVERIFY2(unknown.isEmpty(), qPrintable(QStringLiteral("these need a pattern in ui/models/core_words:\n") +
                                           unknown.join(u'\n')));
}

ODOGRAPH_TEST(TestCoreSentences, QCoreApplication)
#include "tst_core_sentences.moc"
