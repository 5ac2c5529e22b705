// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/main_window/preferences/preferences_dialog.h"
#include "ui/record/record_page.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTest>

using namespace odo;

/// Live positions are sent nowhere unless somebody says so, and then stay on this machine unless somebody
/// says otherwise.
class TestNetworkPage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void init() { QSettings().clear(); }
    void cleanupTestCase() { QSettings().clear(); }

    void isOffAndStaysHere()
    {
        QCOMPARE(SentPositions::chosen(), SentPositions());
        QVERIFY(!SentPositions::chosen().wanted());
        QCOMPARE(SentPositions::chosen().target.interface, std::string("lo"));
        const NetworkPage page;
        QVERIFY(!page.findChild<QCheckBox *>()->isChecked());
        QVERIFY(!page.findChild<QLineEdit *>()->isEnabled());
        QVERIFY(hasWords(page, QStringLiteral("Odograph sends nothing.")));
    }
    void whatIsChosenIsKept()
    {
        const NetworkPage page;
        page.findChild<QCheckBox *>()->click();
        QCOMPARE(SentPositions::chosen().wanted(), std::optional(BroadcastTarget()));
        QVERIFY(hasWords(page, QStringLiteral("They do not leave this computer.")));
        page.findChild<QLineEdit *>()->setText(QStringLiteral("10.0.0.7"));
        QVERIFY(hasWords(page, QStringLiteral("They go only to the computer with this address.")));
        QVERIFY(!page.findChild<QComboBox *>()->isEnabled());
        page.findChild<QSpinBox *>()->setValue(10020);
        QCOMPARE(SentPositions::chosen().target.address, std::string("10.0.0.7"));
        QCOMPARE(SentPositions::chosen().target.port, std::uint16_t(10020));
        page.findChild<QLineEdit *>()->setText(QStringLiteral("10.0.0.")); // while it is being typed
        QVERIFY(hasWords(page, QStringLiteral("This is not an IPv4 address; enter one such as 224.5.23.2.")));
        QCOMPARE(SentPositions::chosen().target.address, std::string("10.0.0.7"));
        const NetworkPage again;
        QVERIFY(again.findChild<QCheckBox *>()->isChecked());
        QCOMPARE(again.findChild<QLineEdit *>()->text(), QStringLiteral("10.0.0.7"));
        page.findChild<QCheckBox *>()->click();
        QVERIFY(!SentPositions::chosen().wanted());
    }
    void anInterfaceThatIsGoneIsShown()
    {
        SentPositions sent;
        sent.target.interface = "gone0";
        sent.choose();
        const NetworkPage page;
        QCOMPARE(page.findChild<QComboBox *>()->currentText(), QStringLiteral("gone0: not available now"));
    }
    void settingsOfNobodyKnowsWhat()
    {
        QSettings().setValue(QStringLiteral("sslVision/port"), QStringLiteral("many"));
        QCOMPARE(SentPositions::chosen().target.port, std::uint16_t(10006));
    }

private:
    static bool hasWords(const QWidget &page, const QString &words)
    {
        const auto labels = page.findChildren<QLabel *>();
        return std::ranges::any_of(labels, [&](const QLabel *label) { return label->text() == words; });
    }
};

ODOGRAPH_TEST(TestNetworkPage, QApplication)
#include "tst_network_page.moc"
