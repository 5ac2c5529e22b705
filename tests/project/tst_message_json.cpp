// SPDX-License-Identifier: GPL-3.0-or-later
// Messages as they are stored: nothing of them is lost, and what is no message harms nobody.
#include "core/project/message_json.h"
#include "tests/support/registered_test.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>
#include <cmath>
#include <limits>

using namespace odo;

class TestMessageJson : public QObject
{
    Q_OBJECT

    static Message with(std::vector<MessageArgument> arguments)
    {
        return {messageText("test.words"), std::move(arguments)};
    }
    static QByteArray json(const Message &message)
    {
        return QJsonDocument(toJson(message)).toJson(QJsonDocument::Compact);
    }

private Q_SLOTS:
    void areWrittenAsDescribed()
    {
        using Joint = MessageArgument::Joint;
        QCOMPARE(json(with({})), QByteArray(R"({"arguments":{},"code":"test.words"})"));
        QCOMPARE(
            json(with({3, quantity(8.5, 1, "mm"), std::string("x_m"), Named::team("Falcon"),
                       nameAlone(std::string("A")),
                       listed({"O", "U"}, MessageArgument::Kind::Marker, Joint::Or)})),
            QByteArray(R"({"arguments":{"1":3,"2":{"decimals":1,"number":8.5,"unit":"mm"},"3":"x_m",)"
                       R"("4":{"team":"Falcon"},"5":{"message":{"arguments":{"1":"A"},"code":"base.name"}},)"
                       R"("6":{"joint":"or","list":[{"arguments":{"1":{"marker":"O"}},"code":"base.name"},)"
                       R"({"arguments":{"1":{"marker":"U"}},"code":"base.name"}]}},"code":"test.words"})"));
        QCOMPARE(json({}), QByteArray("{}"));
        QCOMPARE(storedMessage({}), std::string());
    }

    void nothingIsLost_data()
    {
        QTest::addColumn<Message>("message");
        using Kind = MessageArgument::Kind;
        constexpr double least = std::numeric_limits<double>::denorm_min(),
                         endless = std::numeric_limits<double>::infinity();
        QTest::newRow("numbers") << with({0, -1, 9007199254740991, quantity(0.1, 0), quantity(1.0 / 3, 9),
                                          quantity(-least, 2, "°"), quantity(1e300, 0, "frames/s")});
        QTest::newRow("no numbers") << with({quantity(endless, 1, "mm"), quantity(-endless, 0)});
        std::vector<MessageArgument> names;
        for (const Kind kind : {Kind::Camera, Kind::Robot, Kind::Team, Kind::Person, Kind::Class, Kind::Task,
                                Kind::Trial, Kind::Layout, Kind::Marker})
            names.emplace_back(kind, "Ü \"1\" 中 {}");
        QTest::newRow("names") << with(names);
        QTest::newRow("texts") << with({Named::file("a/ß.csv"), std::string(), std::string("line\n\ttab")});
        QTest::newRow("parts") << with(
            {with({with({}), 3}), listed({}), listed({with({1}), foreignWords("x"), {}}), Message()});
        QTest::newRow("sentences") << joined({with({1}), with({2}), with({3}), foreignWords("and so on")},
                                             Join::Space);
    }
    void nothingIsLost()
    {
        QFETCH(Message, message);
        const std::string stored = storedMessage(message);
        QVERIFY2(messageFromStored(stored) == message, stored.c_str());
        QCOMPARE(messageFromStored(stored).english(), message.english());
        QCOMPARE(storedMessage(messageFromStored(stored)), stored);
    }

    void whatIsNoNumberIsNone()
    {
        const Message read =
            messageFromStored(storedMessage(with({quantity(std::nan(""), 1), quantity(-0.0, 1)})));
        QVERIFY(std::isnan(read.arguments[0].number));
        QVERIFY(std::signbit(read.arguments[1].number));
    }

    void otherTextsAreForeignWords()
    {
        for (const std::string text : {"jump of 40 mm", "{", "{}", R"({"code":""})", R"({"code":7})",
                                       R"({"code":"No Code %1"})", "[1]"})
            QVERIFY2(messageFromStored(text) == foreignWords(text), text.c_str());
        QVERIFY(messageFromStored("").isEmpty());
    }

    /// As another program, or a later Odograph, may have written it.
    void whatIsNotKnownIsLeftOut()
    {
        const Message message = messageFromStored(
            R"({"code":"later.words","arguments":{"1":{"colour":"#ff0000"},"2":true,"3":{"number":1.5,)"
            R"("decimals":1000000000,"unit":"m"},"4":{"list":[1,{}],"joint":"nor"},"6":"after a gap"}})");
        QCOMPARE(message.english(), std::string("later.words"));
        const MessageArgument empty;
        QVERIFY((message.arguments == std::vector<MessageArgument>{empty, empty, quantity(1.5, 9, "m"),
                                                                   listed({Message(), Message()})}));
    }

    /// A verdict may tell of each of a thousand markers.
    void manySentencesAreAsFlatAsFew()
    {
        std::vector<Message> all;
        for (int i = 0; i < 1500; ++i)
            all.push_back(with({i, joined({with({1}), with({2}), with({3})}, Join::Semicolon)}));
        const Message many = joined(all, Join::Space);
        const std::string stored = storedMessage(many);
        QVERIFY(messageFromStored(stored) == many);
        QCOMPARE(toJson(many)[QLatin1String("arguments")].toObject().size(), 1500);
        const Message other = joined({with({1}), joined({with({2}), with({3})}, Join::Space)}, Join::Space);
        QVERIFY(messageFromStored(storedMessage(other)) == other);
    }

    void noneIsTooDeep()
    {
        std::string deep = "{}";
        for (int i = 0; i < 300; ++i)
            deep = R"({"code":"a.b","arguments":{"1":{"message":)" + deep + "}}}";
        const Message read = messageFromStored(deep);
        QCOMPARE(read.code(), std::string_view("a.b"));
        QVERIFY(storedMessage(read).size() < deep.size());
    }
};

ODOGRAPH_TEST(TestMessageJson, QCoreApplication)
#include "tst_message_json.moc"
