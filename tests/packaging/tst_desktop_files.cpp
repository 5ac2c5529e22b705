// SPDX-License-Identifier: GPL-3.0-or-later
// What a desktop reads of Odograph: its entry, metadata, file type, icons and manual pages.
#include "core/project/project.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QMimeDatabase>
#include <QPainter>
#include <QProcess>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;
using namespace odo::test;

namespace {

const QString appId = QStringLiteral("org.odograph.Odograph"),
              fileType = QStringLiteral("application/x-odograph-project");

QString source(const QString &path)
{
    return qEnvironmentVariable("ODOGRAPH_SOURCE_DIR") + u'/' + path;
}

QByteArray contentOf(const QString &file)
{
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
}

QStringList commands()
{
    QStringList names;
    static const QRegularExpression line(QStringLiteral("^  ([a-z-]+) +"),
                                         QRegularExpression::MultilineOption);
    auto matches = line.globalMatch(QString::fromUtf8(runProgram({QStringLiteral("help")}).out));
    while (matches.hasNext())
        names << matches.next().captured(1);
    return names;
}

/// No line is taken for a request of roff that is none.
void checkRequests(const QString &page)
{
    static const QRegularExpression known(
        QStringLiteral("^\\.(TH|SH|SS|B|I|BR|RB|RI|IR|TP|PP|br|nf|fi)( |$)"));
    for (const QString &line : page.split(u'\n'))
        QVERIFY2(!line.startsWith(u'.') || known.match(line).hasMatch(), qPrintable(line));
}

/// How far the pictures are apart on average, of 255, transparency counted.
double apart(const QImage &a, const QImage &b)
{
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            sum += std::abs(qAlpha(p) - qAlpha(q)) +
                   std::abs(qRed(p) * qAlpha(p) - qRed(q) * qAlpha(q)) / 255.0 +
                   std::abs(qBlue(p) * qAlpha(p) - qBlue(q) * qAlpha(q)) / 255.0;
        }
    return sum / (3.0 * a.width() * a.height());
}

} // namespace

class TestDesktopFiles : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

private Q_SLOTS:
    void theValidatorsAgree_data()
    {
        QTest::addColumn<QStringList>("call");
        QTest::newRow("desktop entry")
            << QStringList{QStringLiteral("desktop-file-validate"), QStringLiteral("--no-hints"),
                           source(QStringLiteral("packaging/desktop/%1.desktop").arg(appId))};
        QTest::newRow("metadata") << QStringList{
            QStringLiteral("appstreamcli"), QStringLiteral("validate"), QStringLiteral("--no-net"),
            source(QStringLiteral("packaging/desktop/%1.metainfo.xml").arg(appId))};
    }
    void theValidatorsAgree()
    {
        QFETCH(QStringList, call);
        const ProgramRun run = runCommand(call.first(), call.mid(1));
        QVERIFY2(run.exitStatus == 0, (run.out + run.err).constData());
    }

    void aProjectIsKnownByItsContent()
    {
        // As a desktop does, which has the descriptions of all types in one place.
        const QString types = m_folder.filePath(QStringLiteral("data/mime/packages"));
        QVERIFY(QDir().mkpath(types));
        QVERIFY(QFile::copy(QStringLiteral("/usr/share/mime/packages/freedesktop.org.xml"),
                            types + QStringLiteral("/freedesktop.org.xml")));
        qputenv("XDG_DATA_DIRS", "/no/such/folder");
        // read by the first question below
        qputenv("XDG_DATA_HOME", m_folder.filePath(QStringLiteral("data")).toUtf8());
        QVERIFY(QFile::copy(source(QStringLiteral("packaging/desktop/%1.mime.xml").arg(appId)),
                            types + QStringLiteral("/odograph.xml")));
        const std::filesystem::path file = m_folder.filePath(QStringLiteral("lesson.odo")).toStdString();
        QVERIFY(Project::create(file, "A lesson"));
        const QByteArray project = contentOf(QString::fromStdString(file.string()));
        QVERIFY(project.size() > 100);
        QByteArray other = project;
        other[68] = 0; // a database of another program
        const auto nameOf = [&](const QString &name, const QByteArray &content) {
            const QString path = m_folder.filePath(name);
            QFile written(path);
            return written.open(QIODevice::WriteOnly) && written.write(content) == content.size()
                       ? QMimeDatabase().mimeTypeForFile(path).name()
                       : QString();
        };
        QCOMPARE(nameOf(QStringLiteral("no ending"), project), fileType);
        QCOMPARE(nameOf(QStringLiteral("a.odo"), project), fileType);
        QVERIFY(nameOf(QStringLiteral("other"), other) != fileType);
        QVERIFY(nameOf(QStringLiteral("text"), "Odog") != fileType);
        QCOMPARE(QMimeDatabase().mimeTypeForName(fileType).iconName(),
                 QStringLiteral("application-x-odograph-project"));
        const QByteArray entry = contentOf(source(QStringLiteral("packaging/desktop/%1.desktop").arg(appId)));
        QVERIFY(entry.contains("\nMimeType=" + fileType.toUtf8() + ";\n"));
        QVERIFY(entry.contains("\nIcon=" + appId.toUtf8() + "\n"));
    }

    void iconsShowTheirDrawing_data()
    {
        QTest::addColumn<QString>("drawing");
        QTest::addColumn<QString>("name");
        QTest::newRow("program") << QStringLiteral("resources/icons/odograph.svg") << appId;
        QTest::newRow("project") << QStringLiteral(
                                        "packaging/desktop/icons/application-x-odograph-project.svg")
                                 << QStringLiteral("application-x-odograph-project");
    }
    void iconsShowTheirDrawing()
    {
        QFETCH(QString, drawing);
        QFETCH(QString, name);
        QSvgRenderer renderer(source(drawing));
        QVERIFY(renderer.isValid());
        for (const int side : {16, 24, 32, 48, 64, 128, 256}) {
            const QImage icon(
                source(QStringLiteral("packaging/desktop/icons/%1/%2.png").arg(side).arg(name)));
            QCOMPARE(icon.size(), QSize(side, side));
            QImage drawn(icon.size(), QImage::Format_ARGB32);
            drawn.fill(Qt::transparent);
            QPainter painter(&drawn);
            renderer.render(&painter, QRectF(0, 0, side, side));
            painter.end();
            const double difference = apart(icon, drawn); // another version of Qt may smooth edges otherwise
            QVERIFY2(difference < 3, qPrintable(QStringLiteral("%1 px: %2").arg(side).arg(difference)));
        }
    }

    void theManualPagesTellEveryCommandAndOption()
    {
        const QString folder = m_folder.filePath(QStringLiteral("pages"));
        const ProgramRun made =
            runCommand(source(QStringLiteral("packaging/desktop/man_pages.sh")),
                       {qEnvironmentVariable("ODOGRAPH_PROGRAM"), QStringLiteral("2026-11-22"), folder});
        QVERIFY2(made.exitStatus == 0, made.err.constData());
        const QString main = QString::fromUtf8(contentOf(folder + QStringLiteral("/odograph.1")));
        QVERIFY(main.startsWith(QStringLiteral(".TH ODOGRAPH 1 \"2026-11-22\" \"odograph ")));
        checkRequests(main);
        const QStringList names = commands();
        QVERIFY(names.size() > 20);
        QCOMPARE(QDir(folder).entryList(QDir::Files).size(), names.size() + 1);
        static const QRegularExpression option(QStringLiteral("--[a-z][a-z-]*"));
        for (const QString &name : names) {
            QVERIFY2(main.contains(QStringLiteral("\n.BR odograph\\-%1 (1)\n").arg(name)), qPrintable(name));
            const QString page =
                QString::fromUtf8(contentOf(folder + QStringLiteral("/odograph-%1.1").arg(name)));
            QVERIFY2(page.contains(QStringLiteral("\n.SH NAME\nodograph\\-%1 \\- ").arg(name)),
                     qPrintable(name));
            checkRequests(page);
            const QString help = QString::fromUtf8(runProgram({name, QStringLiteral("--help")}).out);
            auto options = option.globalMatch(help);
            QVERIFY2(options.hasNext(), qPrintable(name));
            while (options.hasNext()) {
                const QString told = options.next().captured().replace(u'-', QStringLiteral("\\-"));
                QVERIFY2(page.contains(told), qPrintable(name + u' ' + told));
            }
        }
    }

    void manReadsThePagesWithoutAWarning()
    {
        const QString folder = m_folder.filePath(QStringLiteral("read"));
        QCOMPARE(runCommand(source(QStringLiteral("packaging/desktop/man_pages.sh")),
                            {qEnvironmentVariable("ODOGRAPH_PROGRAM"), QStringLiteral("2026-11-22"), folder})
                     .exitStatus,
                 0);
        const auto pages = QDir(folder).entryInfoList(QDir::Files);
        QVERIFY(!pages.isEmpty());
        for (const QFileInfo &page : pages) { // as lintian calls it
            const ProgramRun run = runCommand(
                QStringLiteral("man"),
                {QStringLiteral("--warnings"), QStringLiteral("-E"), QStringLiteral("UTF-8"),
                 QStringLiteral("-l"), QStringLiteral("-Tutf8"), QStringLiteral("-Z"), page.filePath()});
            QVERIFY2(run.exitStatus == 0 && run.err.isEmpty(),
                     (page.fileName().toUtf8() + run.err).constData());
        }
    }

    /// Who double-clicks a file sees no terminal: the window stays, and tells what is wrong with the project.
    void aDesktopIsToldInTheWindow()
    {
        const QString missing = m_folder.filePath(QStringLiteral("missing.odo"));
        static const QRegularExpression line(QStringLiteral("^Exec=odograph (.*)$"),
                                             QRegularExpression::MultilineOption);
        QStringList arguments =
            line.match(QString::fromUtf8(
                           contentOf(source(QStringLiteral("packaging/desktop/%1.desktop").arg(appId)))))
                .captured(1)
                .split(u' ');
        QVERIFY(arguments.contains(QStringLiteral("%f")));
        arguments.replaceInStrings(QStringLiteral("%f"), missing);
        QProcess byDesktop;
        byDesktop.start(qEnvironmentVariable("ODOGRAPH_PROGRAM"), arguments);
        QVERIFY(byDesktop.waitForStarted());
        const ProgramRun byHand = runProgram({missing});
        QCOMPARE(byHand.exitStatus, 1);
        QVERIFY2(byHand.err.contains("missing.odo': the file does not exist; "), byHand.err.constData());
        // though it was begun before
        QVERIFY2(!byDesktop.waitForFinished(0), byDesktop.readAllStandardError().constData());
        byDesktop.kill();
        QVERIFY(byDesktop.waitForFinished());
    }

    void theVersionIsTheSameEverywhere()
    {
        const QByteArray version = runProgram({QStringLiteral("--version")}).out.trimmed().split(' ').last();
        QVERIFY(contentOf(source(QStringLiteral("packaging/desktop/%1.metainfo.xml").arg(appId)))
                    .contains("<release version=\"" + version + "\""));
        QVERIFY(contentOf(source(QStringLiteral("CHANGELOG.md"))).contains("## [" + version + "]"));
        QVERIFY(contentOf(source(QStringLiteral("packaging/flatpak/%1.yaml").arg(appId)))
                    .contains("\nid: " + appId.toUtf8() + "\n"));
    }
};

ODOGRAPH_TEST(TestDesktopFiles, QGuiApplication)
#include "tst_desktop_files.moc"
