// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/slalom_lesson.h"
#include "ui/scoreboard/internal/qr_code.h"
#include "ui/scoreboard/scoreboard_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QPushButton>
#include <QSignalSpy>
#include <QTcpServer>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

QPushButton *button(const QWidget &dialog, const char *text)
{
    for (QPushButton *each : dialog.findChildren<QPushButton *>())
        if (each->text() == QLatin1String(text))
            return each;
    qFatal("no button %s", text);
}

QLabel *address(const QWidget &dialog)
{
    for (QLabel *each : dialog.findChildren<QLabel *>())
        if (each->accessibleName() == QLatin1String("Address of the page"))
            return each;
    qFatal("no address");
}

} // namespace

class TestScoreboardDialog : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;

private Q_SLOTS:
    void initTestCase()
    {
        m_project = makeSlalomLesson(m_folder.path().toStdString());
        addSlalomRun(*m_project, "Falcon", 8.2);
    }

    void servesThePageWhileItIsOpen()
    {
        QUrl url;
        QNetworkAccessManager network;
        {
            ScoreboardDialog dialog(*m_project);
            dialog.setAttribute(Qt::WA_DeleteOnClose, false);
            dialog.show();
            QTRY_VERIFY(address(dialog)->text().startsWith(QStringLiteral("http://127.0.0.1:")));
            url = QUrl(address(dialog)->text());
            QCOMPARE(dialog.findChild<QrWidget *>()->accessibleName(), url.toString());
            button(dialog, "&Copy address")->click();
            QCOMPARE(QGuiApplication::clipboard()->text(), url.toString());
            const std::unique_ptr<QNetworkReply> reply(network.get(QNetworkRequest(url)));
            QVERIFY(QSignalSpy(reply.get(), &QNetworkReply::finished).wait());
            QVERIFY(reply->readAll().contains("<table"));
        }
        const std::unique_ptr<QNetworkReply> reply(network.get(QNetworkRequest(url)));
        QVERIFY(QSignalSpy(reply.get(), &QNetworkReply::finished).wait());
        QCOMPARE(reply->error(), QNetworkReply::ConnectionRefusedError);
    }

    void anotherProgramsPortIsLeftAlone()
    {
        QTcpServer other;
        other.listen(QHostAddress(QHostAddress::LocalHost), 8080); // if nobody else has it
        ScoreboardDialog dialog(*m_project);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        QTRY_VERIFY(!address(dialog)->text().isEmpty());
        QVERIFY(QUrl(address(dialog)->text()).port() != 8080);
    }

    void aNetworkIsServedOnlyWhenAsked()
    {
        ScoreboardDialog dialog(*m_project);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        const auto says = [&dialog](const char *words) {
            const auto labels = dialog.findChildren<QLabel *>();
            return std::ranges::any_of(labels, [words](const QLabel *label) {
                return label->text().contains(QLatin1String(words));
            });
        };
        QTRY_VERIFY(says("Only this computer can open this page"));
        QComboBox *audience = dialog.findChildren<QComboBox *>().last();
        audience->setCurrentIndex(1);
        QTRY_VERIFY(says("Everyone in the network can open this page"));
        audience->setCurrentIndex(0);
        QTRY_VERIFY(says("Only this computer can open this page"));
    }
};

ODOGRAPH_TEST(TestScoreboardDialog, QApplication)
#include "tst_scoreboard_dialog.moc"
