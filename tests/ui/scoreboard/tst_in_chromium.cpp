// SPDX-License-Identifier: GPL-3.0-or-later
// The page in a real browser, where one is installed: what it shows, its themes, its widths, and that it
// follows.
#include "core/project/project.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/slalom_lesson.h"
#include "ui/scoreboard/scoreboard.h"
#include "ui/views/widgets/theme.h"

#include <QElapsedTimer>
#include <QFile>
#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QSocketNotifier>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <map>
#include <memory>
#include <unistd.h>

using namespace odo;
using namespace odo::test;

namespace {

/// Chromium without a window, by its DevTools protocol over two pipes: a message ends with a zero byte.
class Browser
{
public:
    explicit Browser(const QString &program)
    {
        if (::pipe(m_in.data()) != 0 || ::pipe(m_out.data()) != 0)
            qFatal("no pipe");
        m_process.setChildProcessModifier([this] {
            ::dup2(m_in[0], 3); // where it reads commands and writes answers
            ::dup2(m_out[1], 4);
        });
        m_process.start(program, {QStringLiteral("--headless=new"), QStringLiteral("--no-sandbox"),
                                  QStringLiteral("--disable-gpu"), QStringLiteral("--hide-scrollbars"),
                                  QStringLiteral("--remote-debugging-pipe"),
                                  QStringLiteral("--user-data-dir=") + m_folder.path(),
                                  QStringLiteral("about:blank")});
        m_notifier = std::make_unique<QSocketNotifier>(m_out[0], QSocketNotifier::Read);
        QObject::connect(m_notifier.get(), &QSocketNotifier::activated, &m_process, [this] { read(); });
        const QJsonObject target =
            call("Target.createTarget", {{QStringLiteral("url"), QStringLiteral("about:blank")}});
        m_session =
            call("Target.attachToTarget", {{QStringLiteral("targetId"), target[QStringLiteral("targetId")]},
                                           {QStringLiteral("flatten"), true}})[QStringLiteral("sessionId")]
                .toString();
        for (const char *domain : {"Log.enable", "Runtime.enable", "Page.enable"})
            call(domain);
    }
    ~Browser()
    {
        m_process.kill();
        m_process.waitForFinished();
        for (const int end : {m_in[0], m_in[1], m_out[0], m_out[1]})
            ::close(end);
    }

    QJsonObject call(const char *method, const QJsonObject &parameters = {})
    {
        const int id = ++m_last;
        QJsonObject message{{QStringLiteral("id"), id},
                            {QStringLiteral("method"), QLatin1String(method)},
                            {QStringLiteral("params"), parameters}};
        if (!m_session.isEmpty())
            message[QStringLiteral("sessionId")] = m_session;
        const QByteArray bytes = QJsonDocument(message).toJson(QJsonDocument::Compact) + '\0';
        if (::write(m_in[1], bytes.constData(), std::size_t(bytes.size())) != bytes.size())
            qFatal("the browser does not listen");
        if (!QTest::qWaitFor([&] { return m_answers.count(id) > 0; }, 30'000 * slowness))
            qFatal("no answer to %s", method);
        return m_answers.at(id)[QStringLiteral("result")].toObject();
    }
    QVariant value(const QString &expression)
    {
        return call("Runtime.evaluate", {{QStringLiteral("expression"),
                                          expression}})[QStringLiteral("result")][QStringLiteral("value")]
            .toVariant();
    }
    void setSize(int width, int height, bool isPhone)
    {
        call("Emulation.setDeviceMetricsOverride", {{QStringLiteral("width"), width},
                                                    {QStringLiteral("height"), height},
                                                    {QStringLiteral("deviceScaleFactor"), 1},
                                                    {QStringLiteral("mobile"), isPhone}});
    }
    void setTheme(const char *theme)
    {
        const QJsonObject feature{{QStringLiteral("name"), QStringLiteral("prefers-color-scheme")},
                                  {QStringLiteral("value"), QLatin1String(theme)}};
        call("Emulation.setEmulatedMedia", {{QStringLiteral("features"), QJsonArray{feature}}});
    }
    /// Keeps an image where somebody wants to look at them: in the folder ODOGRAPH_IMAGES.
    void keepImage(const QString &name)
    {
        const QString folder = qEnvironmentVariable("ODOGRAPH_IMAGES");
        QFile file(folder + u'/' + name + QStringLiteral(".png"));
        if (!folder.isEmpty() && file.open(QIODevice::WriteOnly))
            file.write(QByteArray::fromBase64(
                call("Page.captureScreenshot")[QStringLiteral("data")].toString().toLatin1()));
    }
    const QStringList &complaints() const { return m_complaints; }

private:
    void read()
    {
        std::array<char, 65536> bytes;
        const auto count = ::read(m_out[0], bytes.data(), bytes.size());
        if (count <= 0)
            return m_notifier->setEnabled(false);
        m_got.append(bytes.data(), count);
        for (qsizetype end = m_got.indexOf('\0'); end >= 0; end = m_got.indexOf('\0')) {
            const QJsonObject message = QJsonDocument::fromJson(m_got.first(end)).object();
            m_got.remove(0, end + 1);
            const QString method = message[QStringLiteral("method")].toString();
            if (message.contains(QStringLiteral("id")))
                m_answers[message[QStringLiteral("id")].toInt()] = message;
            else if (method == QLatin1String("Log.entryAdded") ||
                     method == QLatin1String("Runtime.exceptionThrown"))
                m_complaints << QString::fromUtf8(
                    QJsonDocument(message[QStringLiteral("params")].toObject()).toJson());
        }
    }

    QTemporaryDir m_folder;
    QProcess m_process;
    std::array<int, 2> m_in{}, m_out{};
    std::unique_ptr<QSocketNotifier> m_notifier;
    QByteArray m_got;
    QString m_session;
    std::map<int, QJsonObject> m_answers;
    QStringList m_complaints; ///< what the browser's console says
    int m_last = 0;
};

QString cssColour(const QColor &colour)
{
    return QStringLiteral("rgb(%1, %2, %3)").arg(colour.red()).arg(colour.green()).arg(colour.blue());
}

const QString rowCount = QStringLiteral("document.querySelectorAll('#teams tr').length");

} // namespace

class TestInChromium : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    std::unique_ptr<Scoreboard> m_board;
    std::unique_ptr<Browser> m_browser;

private Q_SLOTS:
    void initTestCase()
    {
        const QString program = QStandardPaths::findExecutable(QStringLiteral("chromium"));
        if (program.isEmpty())
            QSKIP("ODOGRAPH-SKIPPED: no Chromium is installed");
        m_project = makeSlalomLesson(m_folder.path().toStdString());
        addSlalomRun(*m_project, "Falcon", 8.20);
        addSlalomRun(*m_project, "Heron", 9.00);
        ScoreboardSettings settings;
        settings.port = 0;
        m_board = *Scoreboard::start(*Project::open(m_project->file(), Project::Access::ReadOnly), settings);
        m_browser = std::make_unique<Browser>(program);
        m_browser->setSize(1920, 1080, false);
        m_browser->call("Page.navigate", {{QStringLiteral("url"), m_board->url()}});
        QTRY_COMPARE(m_browser->value(rowCount).toInt(), 2);
    }
    void cleanupTestCase() { m_browser.reset(); }

    void showsStandingsAndMap()
    {
        QCOMPARE(m_browser->value(QStringLiteral("document.title")).toString(), QStringLiteral("Slalom"));
        QTRY_VERIFY(m_browser->value(QStringLiteral("document.querySelectorAll('#map svg polyline').length"))
                        .toInt() > 0);
        QVERIFY(m_browser->value(QStringLiteral("document.getElementById('link').hidden")).toBool());
        QVERIFY(m_browser->value(QStringLiteral("document.getElementById('rule').innerText"))
                    .toString()
                    .contains(QStringLiteral("share a rank")));
        QCOMPARE(m_browser->complaints(), QStringList()); // of the content-security policy, or of the script
    }

    void followsWithinASecond()
    {
        QElapsedTimer timer;
        timer.start();
        addSlalomRun(*m_project, "Otter", 8.27);
        QTRY_COMPARE_WITH_TIMEOUT(m_browser->value(rowCount).toInt(), 3, 5000 * slowness);
        qInfo("shown %lld ms after it began to be stored", static_cast<long long>(timer.elapsed()));
        QVERIFY(timer.elapsed() < 1000 * slowness);
        const QString ranks = QStringLiteral(
            "[...document.querySelectorAll('#teams .rank')].map((each) => each.innerText).join()");
        QCOMPARE(m_browser->value(ranks).toString(), QStringLiteral("1,1,3"));
    }

    void followsTheTheme_data()
    {
        QTest::addColumn<QByteArray>("theme");
        QTest::addColumn<QPalette>("palette");
        QTest::newRow("light") << QByteArray("light") << lightPalette();
        QTest::newRow("dark") << QByteArray("dark") << darkPalette();
    }
    void followsTheTheme()
    {
        QFETCH(QByteArray, theme);
        QFETCH(QPalette, palette);
        m_browser->setTheme(theme);
        const auto style = [this](const char *property) {
            return m_browser
                ->value(QStringLiteral("getComputedStyle(document.body).") + QLatin1String(property))
                .toString();
        };
        QCOMPARE(style("backgroundColor"), cssColour(palette.color(QPalette::Base)));
        QCOMPARE(style("color"), cssColour(palette.color(QPalette::Text)));
        m_browser->keepImage(QString::fromLatin1(theme));
    }

    void fitsTheScreen_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::newRow("phone") << 390 << 844;
        QTest::newRow("small phone") << 320 << 568;
        QTest::newRow("laptop") << 1024 << 600;
        QTest::newRow("projector") << 1920 << 1080;
        QTest::newRow("large") << 3840 << 2160;
    }
    void fitsTheScreen()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        m_browser->setSize(width, height, width < 500);
        QCOMPARE(m_browser->value(QStringLiteral("innerWidth")).toInt(), width);
        QVERIFY(m_browser->value(QStringLiteral("document.documentElement.scrollWidth")).toInt() <= width);
        // of an image two metres wide, letters of 40 mm, which are read from ten metres
        const double pixels =
            m_browser
                ->value(QStringLiteral("parseFloat(getComputedStyle(document.querySelector('#teams .best'))"
                                       ".fontSize)"))
                .toDouble();
        QVERIFY2(pixels >= (width >= 1920 ? 0.02 * width : 13.0), qPrintable(QString::number(pixels)));
        m_browser->keepImage(QString::number(width));
    }
};

ODOGRAPH_TEST(TestInChromium, QGuiApplication)
#include "tst_in_chromium.moc"
