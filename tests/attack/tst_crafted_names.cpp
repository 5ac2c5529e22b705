// SPDX-License-Identifier: GPL-3.0-or-later
// Names that are markup, paths, commands, escapes, too long or of nothing that is seen: each is taken as
// plain text, or refused by a line, wherever a name is given.
#include "tests/attack/attacked.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo::test;

class TestCraftedNames : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(runProgram({QStringLiteral("new"), path("p.odo")}).exitStatus, 0);
        QFile table(path("track.csv"));
        QVERIFY(table.open(QIODevice::WriteOnly));
        table.write("t_s,x_mm,y_mm\n");
        for (int i = 0; i < 60; ++i)
            table.write(QByteArray::number(i / 30.0, 'f', 4) + ',' + QByteArray::number(10 * i) + ",0\n");
    }

    void isPlainTextOrRefused_data()
    {
        QTest::addColumn<QString>("name");
        constexpr int sample = 12;
        int number = 0;
        for (const QString &name : names()) {
            if (isWanted(++number, sample))
                QTest::addRow("%d", number) << name;
        }
        QVERIFY2(number >= 100, qPrintable(QString::number(number)));
    }
    void isPlainTextOrRefused()
    {
        QFETCH(QString, name);
        const QString project = path("p.odo"), table = QStringLiteral("R=") + path("track.csv");
        const QList<QStringList> calls{
            {QStringLiteral("camera"), QStringLiteral("add"), project, name},
            {QStringLiteral("robot"), QStringLiteral("add"), project, name, QStringLiteral("--colour"),
             QStringLiteral("#00aa00")},
            {QStringLiteral("import"), project, QStringLiteral("--trial"), name, QStringLiteral("--track"),
             table},
            {QStringLiteral("show"), project, name},
            {QStringLiteral("export"), project, name, QStringLiteral("-o"), path("out.csv")},
            {QStringLiteral("report"), project, name, QStringLiteral("-o"), path("out.pdf")},
            {QStringLiteral("list"), project},
            {QStringLiteral("list"), project, QStringLiteral("--json")},
            {QStringLiteral("show"), name},
            {QStringLiteral("new"), m_folder.filePath(name + QStringLiteral(".odo"))}};
        for (const QStringList &call : calls) {
            const AttackedRun run = attacked(call);
            QVERIFY2(faultOf(run).isEmpty(), qPrintable(call.first() + QStringLiteral(": ") + faultOf(run)));
        }
        const AttackedRun check = attacked({QStringLiteral("check"), project});
        QVERIFY2(check.exitStatus == 0, check.out.constData());
    }

private:
    static QStringList names()
    {
        QStringList names{QString(),
                          QStringLiteral(" "),
                          QStringLiteral("."),
                          QStringLiteral(".."),
                          QStringLiteral("/"),
                          QStringLiteral("../../x"),
                          QStringLiteral("/etc/passwd"),
                          QStringLiteral("~"),
                          QStringLiteral("-o"),
                          QStringLiteral("--json"),
                          QStringLiteral("--"),
                          QStringLiteral("-"),
                          QStringLiteral("<b>bold</b>"),
                          QStringLiteral("<img src=file:///etc/passwd>"),
                          QStringLiteral("a<b and c>d"),
                          QStringLiteral("&amp;"),
                          QStringLiteral("%1 %2 %n"),
                          QStringLiteral("%s%s%n"),
                          QStringLiteral("$(reboot)"),
                          QStringLiteral("`reboot`"),
                          QStringLiteral("; reboot"),
                          QStringLiteral("' OR 1=1 --"),
                          QStringLiteral("\"; DROP TABLE trial; --"),
                          QStringLiteral("=1+1"),
                          QStringLiteral("+1"),
                          QStringLiteral("@SUM(A1)"),
                          QStringLiteral("a,b"),
                          QStringLiteral("a;b"),
                          QStringLiteral("a\tb"),
                          QStringLiteral("a\nb"),
                          QStringLiteral("a\rb"),
                          QStringLiteral("CON"),
                          QStringLiteral("nul.txt"),
                          QStringLiteral("a:b"),
                          QStringLiteral("a*b?c"),
                          QStringLiteral("a|b"),
                          QStringLiteral("name="),
                          QStringLiteral("=name"),
                          QStringLiteral("A=B"),
                          QStringLiteral("0"),
                          QStringLiteral("1e300"),
                          QStringLiteral("null"),
                          QStringLiteral("NaN"),
                          QStringLiteral("Zoë"),
                          QStringLiteral("Zoe\u0308"),
                          QStringLiteral("İstanbul"),
                          QStringLiteral("ﬁnal"),
                          QStringLiteral("ß"),
                          QStringLiteral("الروبوت"),
                          QStringLiteral("רובוט"),
                          QStringLiteral("机器人"),
                          QStringLiteral("로봇"),
                          QStringLiteral("👩‍🚀"),
                          QStringLiteral("🤖🤖"),
                          QStringLiteral("a\u200bb"),
                          QStringLiteral("\u200b"),
                          QStringLiteral("\u00ad"),
                          QStringLiteral("\u202eevil"),
                          QStringLiteral("\u2066x\u2069"),
                          QStringLiteral("a\u2028b"),
                          QStringLiteral("\ufeffx"),
                          QStringLiteral("\u0300"),
                          QStringLiteral("x\u0301\u0301\u0301\u0301\u0301"),
                          QStringLiteral("\u3000"),
                          QStringLiteral(" blanks around "),
                          QStringLiteral("two  blanks")};
        for (const char32_t c :
             {0x01U,   0x07U,   0x08U,   0x0bU,   0x1bU,   0x7fU,   0x80U,    0x9bU,    0xa0U,
              0x34fU,  0x61cU,  0x115fU, 0x180eU, 0x2000U, 0x200eU, 0x200fU,  0x202aU,  0x2060U,
              0x2800U, 0x3164U, 0xe000U, 0xfff9U, 0xfffdU, 0xffffU, 0x1d173U, 0xe0001U, 0x10ffffU})
            names << QStringLiteral("x%1y").arg(QString::fromUcs4(&c, 1));
        // the longest that the system passes on
        for (const int length : {199, 200, 201, 255, 256, 1000, 60'000})
            names << QString(length, u'n') << QString(length, u'Ü');
        return names;
    }

    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    QTemporaryDir m_folder;
};

ODOGRAPH_TEST(TestCraftedNames, QCoreApplication)
#include "tst_crafted_names.moc"
