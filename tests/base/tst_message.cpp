// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/message.h"
#include "tests/support/registered_test.h"

#include <QCoreApplication>
#include <QTest>

using namespace odo;

class TestMessage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void argumentsStandWhereTheWordsHaveThem()
    {
        const Message swapped = ODO_TEXT("test.swapped", "100 % of %2 lies %1 from %2")(
            quantity(2.346, 2, "mm"), Named::camera("A"));
        QCOMPARE(swapped.english(), std::string("100 % of A lies 2.35 mm from A"));
        QCOMPARE(
            ODO_TEXT("test.units", "%1, %2, %3")(quantity(40, 0, "%"), quantity(0.25, 1, "°"), 7).english(),
            std::string("40 %, 0.2°, 7"));
        // What an argument holds is never read as a pattern.
        QCOMPARE(ODO_TEXT("test.two", "'%1' and '%2'")(std::string("%2"), std::string("%1")).english(),
                 std::string("'%2' and '%1'"));
        QCOMPARE(ODO_TEXT("test.missing", "one %1, no other %2")(1).english(),
                 std::string("one 1, no other "));
        QVERIFY(Message().isEmpty());
        QCOMPARE(Message().english(), std::string());
    }
    void listsAreSpoken()
    {
        using Kind = MessageArgument::Kind;
        using Joint = MessageArgument::Joint;
        const auto words = [](const std::vector<std::string> &names, Joint joint) {
            return ODO_TEXT("test.list", "see %1")(listed(names, Kind::Marker, joint)).english();
        };
        QCOMPARE(words({}, Joint::And), std::string("see none"));
        QCOMPARE(words({"O"}, Joint::And), std::string("see O"));
        QCOMPARE(words({"O", "U", "V"}, Joint::And), std::string("see O, U and V"));
        QCOMPARE(words({"O", "U"}, Joint::Or), std::string("see O or U"));
        QCOMPARE(words({"O", "U", "V"}, Joint::Comma), std::string("see O, U, V"));
    }
    void messagesAreJoined()
    {
        const Message good = ODO_TEXT("test.good", "Good"), far = ODO_TEXT("test.far", "it is %1 away")(3);
        QCOMPARE(joined({good, far}, Join::Colon).english(), std::string("Good: it is 3 away"));
        QCOMPARE(joined({{}, good, {}, far, {}}, Join::Semicolon).english(),
                 std::string("Good; it is 3 away"));
        QVERIFY(joined({{}, far}, Join::Space) == far);
        QVERIFY(joined({}, Join::Comma).isEmpty());
    }
    void whatIsSaidIsKnownByItsCode()
    {
        const Message said = ODO_TEXT("test.said", "it was %1")(std::string("said"));
        QCOMPARE(said.code(), std::string_view("test.said"));
        QVERIFY(&messageText("test.said") == said.text);
        const auto all = allMessageTexts();
        QVERIFY(std::ranges::find(all, said.text) != all.end());
        QVERIFY(std::ranges::is_sorted(all, {},
                                       [](const MessageText *text) { return std::string_view(text->code); }));
        // Of another version: told by its code, and the same each time.
        const MessageText &newer = messageText("test.of_a_newer_version");
        QCOMPARE(std::string(newer.english), std::string("test.of_a_newer_version"));
        QVERIFY(&newer == &messageText("test.of_a_newer_version"));
    }
    void messagesAreValues()
    {
        const MessageText &text = ODO_TEXT("test.value", "%1 of %2");
        QVERIFY(text(1, Named::team("Owl")) == text(1, Named::team("Owl")));
        QVERIFY(!(text(1, Named::team("Owl")) == text(1, Named::robot("Owl"))));
        QVERIFY(!(text(1, Named::team("Owl")) == text(2, Named::team("Owl"))));
        QVERIFY(!(Message(text) == Message()));
    }
};

ODOGRAPH_TEST(TestMessage, QCoreApplication)
#include "tst_message.moc"
