// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guarded_application.h"

#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <new>
#include <stdexcept>

using namespace odo;

namespace {

/// Throws at each event of a person.
class Thrower : public QObject
{
public:
    explicit Thrower(bool isShortage) : m_isShortage(isShortage) {}
    bool event(QEvent *event) override
    {
        if (event->type() != QEvent::User)
            return QObject::event(event);
        ++count;
        if (m_isShortage)
            throw std::bad_alloc();
        throw std::runtime_error("no such row");
    }
    int count = 0;

private:
    const bool m_isShortage;
};

} // namespace

/// An exception in an event is told, and the program goes on.
class TestGuardedApplication : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void anExceptionEndsTheEventOnly_data()
    {
        QTest::addColumn<bool>("isShortage");
        QTest::addColumn<QString>("words");
        QTest::newRow("memory") << true << QStringLiteral("not have enough free memory");
        QTest::newRow("unexpected") << false << QStringLiteral("something unexpected happened (no such row)");
    }
    void anExceptionEndsTheEventOnly()
    {
        QFETCH(bool, isShortage);
        QFETCH(QString, words);
        Thrower thrower(isShortage);
        QString told;
        int boxes = 0;
        QTimer look;
        connect(&look, &QTimer::timeout, this, [&] {
            if (auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget())) {
                ++boxes;
                told = box->text();
                box->accept();
            }
        });
        look.start(1);
        for (int i = 0; i < 3; ++i) // as of a painting that fails each time
            QCoreApplication::postEvent(&thrower, new QEvent(QEvent::User));
        QTRY_VERIFY(!told.isEmpty() && thrower.count == 3);
        QVERIFY2(told.contains(words), qPrintable(told));
        QTRY_VERIFY(!QApplication::activeModalWidget());
        QCOMPARE(boxes, 1);
    }

    void senselessScalesAreDropped_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("value");
        QTest::addColumn<bool>("isKept");
        const auto row = [](const char *name, const char *value, bool isKept) {
            QTest::addRow("%s=%s", name, value) << QByteArray(name) << QByteArray(value) << isKept;
        };
        for (const char *value : {"nan", "inf", "-inf", "0", "-1", "1e300", "x", ""})
            row("QT_SCALE_FACTOR", value, false);
        for (const char *value : {"1", "1.5", "0.5", "2"})
            row("QT_SCALE_FACTOR", value, true);
        row("QT_SCREEN_SCALE_FACTORS", "1;2", true);
        row("QT_SCREEN_SCALE_FACTORS", "HDMI-1=1.5;DP-1=2", true);
        row("QT_SCREEN_SCALE_FACTORS", "1;nan", false);
        row("QT_FONT_DPI", "96", true);
        row("QT_FONT_DPI", "0", false);
        row("QT_FONT_DPI", "nan", false);
    }
    void senselessScalesAreDropped()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, value);
        QFETCH(bool, isKept);
        qputenv(name.constData(), value);
        dropSenselessScales();
        QCOMPARE(qEnvironmentVariableIsSet(name.constData()), isKept);
        qunsetenv(name.constData());
    }
};

int main(int argc, char **argv)
{
    GuardedApplication application(argc, argv);
    TestGuardedApplication test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_guarded_application.moc"
