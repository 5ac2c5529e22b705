// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sources: the rules of docs/architecture.md that a compiler doesn't see.
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>
#include <QTest>

class TestHouse : public QObject
{
    Q_OBJECT

    struct Source
    {
        QStringList lines;
        QStringList includes; ///< of ours, from the tree's root
    };

    /// Headers of one system only.
    static const QRegularExpression &platformHeader()
    {
        static const QRegularExpression header(QStringLiteral(
            "^\\s*#\\s*include\\s*<((arpa|linux|mach|net|netinet|netpacket|sys|asm|asm-generic)/.*|"
            "csignal|signal\\.h|(aio|alloca|dirent|dlfcn|elf|execinfo|fcntl|features|fnmatch|ftw|getopt|glob|"
            "grp|iconv|ifaddrs|io|langinfo|libgen|libudev|link|malloc|mntent|mqueue|netdb|poll|pthread|pwd|"
            "regex|sched|semaphore|spawn|strings|syslog|termios|ucontext|ulimit|unistd|utime|utmp|wait|"
            "windows|winsock2|wordexp)\\.h)>"));
        return header;
    }

    QString m_root;
    QMap<QString, Source> m_sources; ///< by their paths from the tree's root

    static QString folderOf(const QString &path) { return path.section(u'/', 0, -2); }
    static bool isTest(const QString &path) { return path.startsWith(QLatin1String("tests/")); }
    /// Whether a header of ours can be reached from another by includes alone; the way is left in `way`.
    bool leadsTo(const QString &from, const QString &to, QSet<QString> &seen, QStringList &way) const;

private Q_SLOTS:
    void initTestCase();
    void linesHaveAtMost110Columns();
    void foldersHaveAtMost30Files();
    void internalHeadersStayInTheirFolder();
    void otherHeadersAreUsedOutsideTheirFolder();
    void includesRunInNoCircle();
    void platformHeadersStayInTheirFolders();
    void everyTypeHasANameOfItsOwn();
    void everyFileIsFormatted();
};

void TestHouse::initTestCase()
{
    static const QRegularExpression include(QStringLiteral("^#include \"((core|ui|app|tests)/.*)\""));
    m_root = qEnvironmentVariable("ODOGRAPH_SOURCE_DIR");
    for (const char *top : {"core", "ui", "app", "tests"}) {
        QDirIterator each(m_root + u'/' + QLatin1String(top),
                          {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                          QDirIterator::Subdirectories);
        while (each.hasNext()) {
            QFile file(each.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            Source source{QString::fromUtf8(file.readAll()).split(u'\n'), {}};
            for (const QString &line : std::as_const(source.lines))
                if (const auto match = include.match(line); match.hasMatch())
                    source.includes << match.captured(1);
            m_sources.insert(file.fileName().mid(m_root.size() + 1), source);
        }
    }
    QVERIFY(m_sources.size() > 500);
}

void TestHouse::linesHaveAtMost110Columns()
{
    constexpr int most = 110;
    static const QRegularExpression rawBegin(QStringLiteral("R\"(\\w*)\\("));
    QStringList wrong;
    for (auto source = m_sources.cbegin(); source != m_sources.cend(); ++source) {
        QString rawEnd; // what ends text for other programs, whose lines are theirs; empty outside of it
        for (int i = 0; i < source->lines.size(); ++i) {
            const QString &line = source->lines[i];
            const auto begin = rawBegin.match(line);
            if (begin.hasMatch())
                rawEnd = u')' + begin.captured(1) + u'"';
            if (rawEnd.isEmpty() && line.toUcs4().size() > most)
                wrong << QStringLiteral("%1:%2").arg(source.key()).arg(i + 1);
            if (!rawEnd.isEmpty() && line.indexOf(rawEnd, std::max(0, int(begin.capturedEnd()))) >= 0)
                rawEnd.clear();
        }
    }
    QCOMPARE(wrong.join(u'\n'), QString());
}

void TestHouse::foldersHaveAtMost30Files()
{
    constexpr int most = 30;
    QMap<QString, int> files;
    for (const QString &path : m_sources.keys())
        if (!isTest(path) && !folderOf(path).endsWith(QLatin1String("/internal")))
            ++files[folderOf(path)];
    QStringList wrong;
    for (auto folder = files.cbegin(); folder != files.cend(); ++folder)
        if (folder.value() > most)
            wrong << QStringLiteral("%1: %2").arg(folder.key()).arg(folder.value());
    QCOMPARE(wrong.join(u'\n'), QString());
}

void TestHouse::internalHeadersStayInTheirFolder()
{
    QStringList wrong;
    for (auto source = m_sources.cbegin(); source != m_sources.cend(); ++source) {
        for (const QString &include : source->includes) {
            const QString internal = folderOf(include), owner = folderOf(internal),
                          user = folderOf(source.key());
            if (internal.endsWith(QLatin1String("/internal")) && !isTest(source.key()) && user != internal &&
                user != owner)
                wrong << source.key() + QLatin1String(" includes ") + include;
        }
    }
    QCOMPARE(wrong.join(u'\n'), QString());
}

/// Two types of one name, in whatever folders, are one to the linker, which takes the functions of either.
void TestHouse::everyTypeHasANameOfItsOwn()
{
    static const QRegularExpression type(
        QStringLiteral("^(?:class|struct|enum class) (\\w+)(?: final)?(?: :[^;]*)?(?: \\{)?$"));
    QMap<QString, QString> known;
    QStringList wrong;
    for (auto source = m_sources.cbegin(); source != m_sources.cend(); ++source)
        for (const QString &line : source->lines)
            if (const auto match = type.match(line);
                match.hasMatch() && source.key().endsWith(QLatin1String(".h")) && !isTest(source.key())) {
                if (known.contains(match.captured(1)))
                    wrong << QStringLiteral("%1: %2 and %3")
                                 .arg(match.captured(1), known.value(match.captured(1)), source.key());
                known.insert(match.captured(1), source.key());
            }
    QVERIFY(known.size() > 300);
    QCOMPARE(wrong.join(u'\n'), QString());
}

/// Pages of windows and what main calls are there for nobody else.
void TestHouse::otherHeadersAreUsedOutsideTheirFolder()
{
    QSet<QString> used;
    for (auto source = m_sources.cbegin(); source != m_sources.cend(); ++source)
        for (const QString &include : source->includes)
            if (folderOf(source.key()) != folderOf(include) &&
                folderOf(source.key()) != folderOf(include) + QLatin1String("/internal"))
                used << include;
    QStringList wrong;
    for (const QString &path : m_sources.keys())
        if (path.endsWith(QLatin1String(".h")) && !isTest(path) && !path.startsWith(QLatin1String("app/")) &&
            !folderOf(path).endsWith(QLatin1String("/internal")) && !used.contains(path))
            wrong << path;
    QCOMPARE(wrong.join(u'\n'), QString());
}

bool TestHouse::leadsTo(const QString &from, const QString &to, QSet<QString> &seen, QStringList &way) const
{
    for (const QString &include : m_sources.value(from).includes) {
        if (include == to ||
            (!seen.contains(include) && (seen << include, leadsTo(include, to, seen, way)))) {
            way.prepend(include);
            return true;
        }
    }
    return false;
}

void TestHouse::includesRunInNoCircle()
{
    for (const QString &path : m_sources.keys()) {
        QSet<QString> seen;
        QStringList way;
        QVERIFY2(!leadsTo(path, path, seen, way),
                 qPrintable(path + QLatin1String(" -> ") + way.join(QLatin1String(" -> "))));
    }
}

/// Others ask the headers of core/base/platform, which name nothing of a system either.
void TestHouse::platformHeadersStayInTheirFolders()
{
    QStringList wrong;
    int allowed = 0;
    for (auto source = m_sources.cbegin(); source != m_sources.cend(); ++source) {
        static const QRegularExpression own(
            QStringLiteral("^core/(base/platform/\\w+|capture/(v4l2|aravis))/"));
        const bool isPlatform = own.match(source.key()).hasMatch();
        for (const QString &line : source->lines)
            if (!isTest(source.key()) && platformHeader().match(line).hasMatch()) {
                if (isPlatform)
                    ++allowed;
                else
                    wrong << source.key() + QLatin1String(": ") + line;
            }
    }
    QCOMPARE(wrong.join(u'\n'), QString());
    QVERIFY(allowed > 30);
}

void TestHouse::everyFileIsFormatted()
{
    const QString formatter = QStandardPaths::findExecutable(QStringLiteral("clang-format-14"));
    QVERIFY2(!formatter.isEmpty(), "install clang-format-14 (packaging/packages_tests.txt)");
    QStringList arguments{QStringLiteral("--dry-run"), QStringLiteral("--Werror")};
    for (const QString &path : m_sources.keys())
        arguments << m_root + u'/' + path;
    const odo::test::ProgramRun checked = odo::test::runCommand(formatter, arguments);
    QVERIFY2(checked.exitStatus == 0, checked.err.left(2000).constData());
}

ODOGRAPH_TEST(TestHouse, QCoreApplication)
#include "tst_house.moc"
