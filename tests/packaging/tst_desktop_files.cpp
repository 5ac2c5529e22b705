// SPDX-License-Identifier: GPL-3.0-or-later
// What a desktop reads of Odograph: its entry, metadata, file type, icons, manual page and completion.
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
    static const QRegularExpression line(QStringLiteral("^  ([a-z]+) +"),
                                         QRegularExpression::MultilineOption);
    auto matches = line.globalMatch(QString::fromUtf8(runProgram({QStringLiteral("help")}).out));
    while (matches.hasNext())
        names << matches.next().captured(1);
    return names;
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

    QStringList completed(const QStringList &words)
    {
        const QString script =
            QStringLiteral(
                "source '%1'; PATH=\"$(dirname '%2')\":$PATH; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); "
                "_odograph; printf '%s\\n' \"${COMPREPLY[@]}\"")
                .arg(source(QStringLiteral("packaging/desktop/odograph.bash")),
                     qEnvironmentVariable("ODOGRAPH_PROGRAM"));
        const ProgramRun run =
            runCommand(QStringLiteral("bash"),
                       QStringList{QStringLiteral("-c"), script, QStringLiteral("bash")} + words);
        return QString::fromUtf8(run.out).split(u'\n', Qt::SkipEmptyParts);
    }

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

    void theManualPageTellsEveryCommandAndOption()
    {
        const ProgramRun made =
            runCommand(source(QStringLiteral("packaging/desktop/man_page.sh")),
                       {qEnvironmentVariable("ODOGRAPH_PROGRAM"), QStringLiteral("2026-11-22")});
        QVERIFY2(made.exitStatus == 0, made.err.constData());
        const QString page = QString::fromUtf8(made.out);
        QVERIFY(page.startsWith(QStringLiteral(".TH ODOGRAPH 1 \"2026-11-22\" \"odograph ")));
        const QStringList names = commands();
        QVERIFY(names.size() > 20);
        static const QRegularExpression option(QStringLiteral("--[a-z][a-z-]*"));
        for (const QString &name : names) {
            const auto begin = page.indexOf(QStringLiteral("\n.SS %1\n").arg(name));
            QVERIFY2(begin > 0, qPrintable(name));
            const auto end = page.indexOf(QRegularExpression(QStringLiteral("\n\\.S[SH] ")), begin + 5);
            const QString part = page.mid(begin, end - begin);
            const QString help = QString::fromUtf8(runProgram({name, QStringLiteral("--help")}).out);
            auto options = option.globalMatch(help.section(QStringLiteral("\nOptions:"), 1));
            QVERIFY2(options.hasNext(), qPrintable(name));
            while (options.hasNext()) {
                const QString told = options.next().captured().replace(u'-', QStringLiteral("\\-"));
                QVERIFY2(part.contains(told), qPrintable(name + u' ' + told));
            }
        }
        // No line is taken for a request of roff that is none.
        static const QRegularExpression known(
            QStringLiteral("^\\.(TH|SH|SS|B|I|BR|RB|RI|IR|TP|PP|br|nf|fi)( |$)"));
        for (const QString &line : page.split(u'\n'))
            QVERIFY2(!line.startsWith(u'.') || known.match(line).hasMatch(), qPrintable(line));
    }

    void wordsAreCompleted()
    {
        QCOMPARE(completed({QStringLiteral("odograph"), QStringLiteral("exp")}),
                 QStringList{QStringLiteral("export")});
        const QStringList all = completed({QStringLiteral("odograph"), QString()});
        for (const QString &name : commands())
            QVERIFY2(all.contains(name), qPrintable(name));
        QCOMPARE(completed({QStringLiteral("odograph"), QStringLiteral("export"), QStringLiteral("--csv")}),
                 QStringList{QStringLiteral("--csv-style")});
        QCOMPARE(completed({QStringLiteral("odograph"), QStringLiteral("export"), QStringLiteral("--format"),
                            QStringLiteral("t")}),
                 (QStringList{QStringLiteral("tum"), QStringLiteral("tracker")}));
        QVERIFY(completed({QStringLiteral("odograph"), QStringLiteral("nonsense"), QStringLiteral("--x")})
                    .isEmpty());
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
