// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the texts that a user sees, and public names, for the words of words.txt.
#include "tests/support/registered_test.h"
#include "tests/support/source_texts.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

using odo::test::Passage;

class TestWords : public QObject
{
    Q_OBJECT

    struct Rule
    {
        QString name;
        bool isOfTexts = true; ///< else of names
        QStringList alternatives, examples;
        QString instead;
        QRegularExpression find;
    };

    struct Exception
    {
        QString reason;
        QRegularExpression file, text; ///< an empty text: all of the file
        mutable bool isUsed = false;
    };

    static constexpr qsizetype around = 40; ///< characters on either side of a phrase that an exception sees

    QString m_root;
    QList<Rule> m_rules;
    QList<Exception> m_exceptions;

    void readList();
    void readLine(const QString &key, const QString &value);
    bool isExcepted(const QString &file, const QString &words, qsizetype begin, qsizetype end) const;
    QStringList wrongIn(const QString &file, const Passage &passage, bool isText) const;
    QStringList wrongIn(const QString &file, const QString &content) const;
    QStringList files() const;

private Q_SLOTS:
    void initTestCase();
    void rulesFindTheirExamples_data();
    void rulesFindTheirExamples();
    void wordsAreFound_data();
    void wordsAreFound();
    void noneIsLeft();
    void exceptionsAreNeeded();
};

void TestWords::initTestCase()
{
    m_root = qEnvironmentVariable("ODOGRAPH_SOURCE_DIR");
    readList();
    QVERIFY(m_rules.size() > 50);
    for (Rule &rule : m_rules) {
        rule.find = QRegularExpression(rule.alternatives.join(u'|'),
                                       QRegularExpression::CaseInsensitiveOption |
                                           QRegularExpression::UseUnicodePropertiesOption);
        QVERIFY2(rule.find.isValid() && !rule.alternatives.isEmpty() && !rule.examples.isEmpty() &&
                     !rule.instead.isEmpty(),
                 qPrintable(rule.name));
    }
    for (const Exception &exception : std::as_const(m_exceptions))
        QVERIFY2(exception.file.isValid() && exception.text.isValid() && !exception.reason.isEmpty(),
                 qPrintable(exception.file.pattern() + u' ' + exception.text.pattern()));
}

void TestWords::readList()
{
    QFile list(m_root + QStringLiteral("/tests/packaging/words.txt"));
    QVERIFY(list.open(QIODevice::ReadOnly));
    for (const QString &line : QString::fromUtf8(list.readAll()).split(u'\n')) {
        const qsizetype colon = line.indexOf(QLatin1String(": "));
        if (line.isEmpty() || line.startsWith(u'#'))
            continue;
        QVERIFY2(colon > 0, qPrintable(line));
        readLine(line.left(colon), line.mid(colon + 2));
    }
}

void TestWords::readLine(const QString &key, const QString &value)
{
    if (key == QLatin1String("texts") || key == QLatin1String("names")) {
        m_rules.append({value, key == QLatin1String("texts"), {}, {}, {}, {}});
    } else if (key == QLatin1String("except")) {
        m_exceptions.append({{}, QRegularExpression(value), {}});
    } else if (key == QLatin1String("find")) {
        m_rules.last().alternatives << value;
    } else if (key == QLatin1String("like")) {
        m_rules.last().examples << value;
    } else if (key == QLatin1String("write")) {
        m_rules.last().instead = value;
    } else if (key == QLatin1String("text")) {
        m_exceptions.last().text = QRegularExpression(value, QRegularExpression::CaseInsensitiveOption);
    } else {
        QCOMPARE(key, QStringLiteral("why"));
        m_exceptions.last().reason = value;
    }
}

bool TestWords::isExcepted(const QString &file, const QString &words, qsizetype begin, qsizetype end) const
{
    const qsizetype first = std::max<qsizetype>(0, begin - around);
    const QString near = words.mid(first, end + around - first);
    for (const Exception &exception : m_exceptions) {
        if (!exception.file.match(file).hasMatch())
            continue;
        bool covers = exception.text.pattern().isEmpty();
        for (auto each = exception.text.globalMatch(near); !covers && each.hasNext();) {
            const auto match = each.next();
            covers = first + match.capturedStart() < end && first + match.capturedEnd() > begin;
        }
        if (covers) {
            exception.isUsed = true;
            return true;
        }
    }
    return false;
}

QStringList TestWords::wrongIn(const QString &file, const Passage &passage, bool isText) const
{
    const QString words = isText ? passage.words() : odo::test::wordsOfName(passage.words());
    QStringList wrong;
    for (const Rule &rule : m_rules) {
        if (rule.isOfTexts != isText)
            continue;
        for (auto each = rule.find.globalMatch(words); each.hasNext();) {
            const auto match = each.next();
            const qsizetype begin = match.capturedStart(), end = match.capturedEnd();
            if (!isExcepted(file, words, begin, end))
                wrong << QStringLiteral("%1:%2: \"%3\" in \"%4\"; write: %5")
                             .arg(file)
                             .arg(passage.lineAt(isText ? begin : 0))
                             .arg(match.captured(),
                                  isText ? words.mid(std::max<qsizetype>(0, begin - around),
                                                     end - begin + 2 * around)
                                         : passage.words(),
                                  rule.instead);
        }
    }
    return wrong;
}

QStringList TestWords::wrongIn(const QString &file, const QString &content) const
{
    const bool isHeader = file.endsWith(QLatin1String(".h"));
    QStringList wrong;
    const QList<Passage> texts =
        isHeader || file.endsWith(QLatin1String(".cpp"))
            ? odo::test::textsOfSource(content, file.startsWith(QLatin1String("app/")))
            : odo::test::textsOfDocument(content);
    for (const Passage &text : texts)
        wrong << wrongIn(file, text, true);
    if (isHeader && !file.contains(QLatin1String("/internal/")))
        for (const Passage &name : odo::test::namesOfSource(content))
            wrong << wrongIn(file, name, false);
    return wrong;
}

/// By their paths from the tree's root.
QStringList TestWords::files() const
{
    QStringList found;
    const auto add = [&](const char *folder, const QStringList &names, QDirIterator::IteratorFlags flags) {
        QDirIterator each(m_root + u'/' + QLatin1String(folder), names, QDir::Files, flags);
        while (each.hasNext())
            found << QDir(m_root).relativeFilePath(each.next());
    };
    for (const char *sources : {"core", "ui", "app"})
        add(sources, {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDirIterator::Subdirectories);
    add("", {QStringLiteral("*.md")}, QDirIterator::NoIteratorFlags);
    add("docs", {QStringLiteral("*.md")}, QDirIterator::Subdirectories);
    add("resources/help/en", {QStringLiteral("*.html")}, QDirIterator::NoIteratorFlags);
    add("packaging/desktop",
        {QStringLiteral("*.desktop"), QStringLiteral("*.metainfo.xml"), QStringLiteral("CMakeLists.txt")},
        QDirIterator::NoIteratorFlags);
    found.sort();
    return found;
}

void TestWords::rulesFindTheirExamples_data()
{
    QTest::addColumn<qsizetype>("rule");
    QTest::addColumn<QString>("example");
    for (qsizetype i = 0; i < m_rules.size(); ++i)
        for (const QString &example : m_rules[i].examples)
            QTest::newRow(qPrintable(m_rules[i].name + QLatin1String(": ") + example)) << i << example;
}

void TestWords::rulesFindTheirExamples()
{
    QFETCH(const qsizetype, rule);
    QFETCH(const QString, example);
    QVERIFY(m_rules[rule]
                .find.match(m_rules[rule].isOfTexts ? example : odo::test::wordsOfName(example))
                .hasMatch());
}

void TestWords::wordsAreFound_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("content");
    QTest::addColumn<QStringList>("found"); // line and phrase
    const auto row = [](const char *name, const char *file, const char *content, const QStringList &found) {
        QTest::newRow(name) << QString::fromUtf8(file) << QString::fromUtf8(content) << found;
    };
    const QStringList nothing;
    row("translated", "ui/a.cpp", "\nlabel(tr(\"Save the picture\"));", {QStringLiteral("2: \"picture\"")});
    row("good words", "ui/a.cpp", "label(tr(\"Save the image\"));", nothing);
    row("the other argument", "ui/a.cpp", "label(tr(\"Save\", \"the picture\"));", nothing);
    row("nested call", "core/a.cpp", "f(ODO_TEXT(\"a.b\", \"it lies %1\")(g(1, 2)));",
        {QStringLiteral("1: \"lies\"")});
    row("code of a message", "core/a.cpp", "f(ODO_TEXT(\"a.picture\", \"an image\"));", nothing);
    row("literal in two pieces", "core/a.cpp", "f(ODO_TEXT(\"a.b\", \"both in \"\n\"step\"));",
        {QStringLiteral("1: \"in step\"")});
    row("raw literal", "core/a.cpp", "f(R\"sql(\"picture\")sql\", tr(\"a wish\"));",
        {QStringLiteral("1: \"wish\"")});
    row("comment", "core/a.cpp", "// tr(\"a picture\")\n/* tr(\"a picture\") */", nothing);
    row("text of the command line", "app/a.cpp", "f(QStringLiteral(\"the told colour\"));",
        {QStringLiteral("1: \"told\"")});
    row("key of the command line", "app/a.cpp", "f(QStringLiteral(\"told\"));", nothing);
    row("plain literal of core", "core/a.cpp", "f(\"the told colour\");", nothing);
    row("public name", "core/a.h", "int a;\ndouble foretoldPx;", {QStringLiteral("2: \"foretold\"")});
    row("good name", "core/a.h", "double predictedPx; void setPlaceholderText();", nothing);
    row("private name", "core/internal/a.h", "double foretoldPx;", nothing);
    row("name in a source", "core/a.cpp", "double foretoldPx;", nothing);
    row("document", "docs/a.md", "Both are in\nstep.", {QStringLiteral("1: \"in step\"")});
    row("code in a document", "docs/a.md", "`picture`\n```\npicture\n```\n[a](picture.png)", nothing);
    row("list in a document", "docs/a.md", "- Look\n- for it", nothing);
    row("exception", "docs/a.md", "Write it in place of the old one.", nothing);
    row("beside an exception", "docs/a.md",
        "In place of the old one, at a place of its own, as the rest of it.",
        {QStringLiteral("1: \"place\"")});
}

void TestWords::wordsAreFound()
{
    QFETCH(const QString, file);
    QFETCH(const QString, content);
    QFETCH(const QStringList, found);
    const QStringList wrong = wrongIn(file, content);
    QVERIFY2(wrong.size() == found.size(), qPrintable(wrong.join(u'\n')));
    for (qsizetype i = 0; i < wrong.size(); ++i)
        QVERIFY2(wrong[i].startsWith(file + u':' + found[i]), qPrintable(wrong[i]));
}

void TestWords::noneIsLeft()
{
    for (Exception &exception : m_exceptions)
        exception.isUsed = false;
    QStringList wrong;
    const QStringList all = files();
    QVERIFY(all.size() > 500);
    for (const QString &path : all) {
        QFile file(m_root + u'/' + path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        wrong << wrongIn(path, QString::fromUtf8(file.readAll()));
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(u'\n' + wrong.join(u'\n')));
}

/// One that covers nothing any more would hide what comes.
void TestWords::exceptionsAreNeeded()
{
    noneIsLeft();
    QStringList needless;
    for (const Exception &exception : std::as_const(m_exceptions))
        if (!exception.isUsed)
            needless << exception.file.pattern() + u' ' + exception.text.pattern();
    QVERIFY2(needless.isEmpty(), qPrintable(u'\n' + needless.join(u'\n')));
}

ODOGRAPH_TEST(TestWords, QCoreApplication)
#include "tst_words.moc"
