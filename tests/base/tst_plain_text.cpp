// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/plain_text.h"

#include "core/base/error.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QTest>

using namespace odo;

/// A file's text cannot command a terminal, hide, or turn what is written around.
class TestPlainText : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void textIsShownAsItIs_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("shown");
        const auto same = [](const char *name, const char *text) {
            QTest::newRow(name) << QByteArray(text) << QByteArray(text);
        };
        same("words", "Straight line, 3 m");
        same("letters", "Zoë Müller Ελένη Борис 김 李 עברית");
        same("lines", "one\n\ttwo");
        same("joined letters", "می\u200cخواهم क्‍ष");
        same("emoji", "👩‍🚀 ❤️ 🏴󠁧󠁢󠁥󠁮󠁧󠁿");
        same("empty", "");
        same("signs", "± · … %1 \\x1b <b>");
        QTest::newRow("escape") << QByteArray("\x1b[2Jx") << QByteArray("\\x1b[2Jx");
        QTest::newRow("bell, back, return") << QByteArray("a\a\b\r") << QByteArray("a\\x07\\x08\\x0d");
        QTest::newRow("nul, delete") << QByteArray("\0a\x7f", 3) << QByteArray("\\x00a\\x7f");
        QTest::newRow("second set of controls") << QByteArray("\xc2\x9b"
                                                              "2J")
                                                << QByteArray("‹U+009B›2J");
        QTest::newRow("override") << QByteArray("photo\xe2\x80\xaegnp.exe")
                                  << QByteArray("photo‹U+202E›gnp.exe");
        QTest::newRow("isolate") << QByteArray("\xe2\x81\xa7x\xe2\x81\xa9")
                                 << QByteArray("‹U+2067›x‹U+2069›");
        QTest::newRow("marks") << QByteArray("\xe2\x80\x8e\xe2\x80\x8f") << QByteArray("‹U+200E›‹U+200F›");
        QTest::newRow("line separators") << QByteArray("a\xe2\x80\xa8"
                                                       "b\xe2\x80\xa9")
                                         << QByteArray("a‹U+2028›b‹U+2029›");
        QTest::newRow("of no width") << QByteArray("a\xe2\x80\x8b\xc2\xad\xef\xbb\xbf")
                                     << QByteArray("a‹U+200B›‹U+00AD›‹U+FEFF›");
        QTest::newRow("no UTF-8") << QByteArray("a\xff\xc3") << QByteArray("a\\xff\\xc3");
        QTest::newRow("overlong") << QByteArray("\xc0\x9b\xe0\x80\x9b")
                                  << QByteArray("\\xc0\\x9b\\xe0\\x80\\x9b");
        QTest::newRow("surrogate") << QByteArray("\xed\xa0\x80") << QByteArray("\\xed\\xa0\\x80");
        QTest::newRow("beyond Unicode")
            << QByteArray("\xf4\x90\x80\x80") << QByteArray("\\xf4\\x90\\x80\\x80");
    }
    void textIsShownAsItIs()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, shown);
        QCOMPARE(QByteArray::fromStdString(plainText(text.toStdString())), shown);
        QCOMPARE(QByteArray::fromStdString(plainText(shown.toStdString())), shown); // once is enough
        QCOMPARE(QByteArray::fromStdString(plainLine(text.toStdString())),
                 shown.replace("\n", "\\x0a").replace("\t", "\\x09"));
    }

    void errorsCommandNoTerminal()
    {
        const Error error =
            test::saidError(ErrorCode::Io, "team '\x1b[2J'", "two\nlines", "photo\xe2\x80\xaegnp");
        QCOMPARE(error.message(), std::string("team '\\x1b[2J': two lines; photo‹U+202E›gnp"));
    }
};

ODOGRAPH_TEST(TestPlainText, QCoreApplication)
#include "tst_plain_text.moc"
