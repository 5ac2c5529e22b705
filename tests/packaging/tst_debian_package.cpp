// SPDX-License-Identifier: GPL-3.0-or-later
// The Debian package: made by CPack, looked through by lintian, put into an empty tree and taken out again.
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>
#include <unistd.h>

using namespace odo::test;

namespace {

QSet<QString> filesIn(const QString &folder)
{
    QSet<QString> files;
    QDirIterator each(folder, QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
                      QDirIterator::Subdirectories);
    while (each.hasNext())
        files << each.next().mid(folder.size());
    return files;
}

} // namespace

class TestDebianPackage : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    QString m_package;

    QByteArray field(const char *name) const
    {
        return runCommand(QStringLiteral("dpkg-deb"),
                          {QStringLiteral("-f"), m_package, QString::fromLatin1(name)})
            .out.trimmed();
    }
    /// dpkg on a tree of our own; as root, or as what seems to be.
    ProgramRun dpkg(const QString &tree, const QStringList &arguments) const
    {
        QStringList call{QStringLiteral("dpkg"), QStringLiteral("--root=") + tree,
                         QStringLiteral("--force-depends"), QStringLiteral("--force-not-root"),
                         QStringLiteral("--force-script-chrootless")};
        call += arguments;
        if (geteuid() != 0)
            call.prepend(QStringLiteral("fakeroot"));
        return runCommand(call.first(), call.mid(1));
    }

private Q_SLOTS:
    void initTestCase()
    {
        const ProgramRun made =
            runCommand(QStringLiteral("cpack"),
                       {QStringLiteral("--config"),
                        qEnvironmentVariable("ODOGRAPH_BUILD_DIR") + QStringLiteral("/CPackConfig.cmake"),
                        QStringLiteral("-B"), m_folder.path()});
        QVERIFY2(made.exitStatus == 0, (made.out + made.err).constData());
        const QStringList packages = QDir(m_folder.path()).entryList({QStringLiteral("odograph_*.deb")});
        QCOMPARE(packages.size(), 1);
        m_package = m_folder.filePath(packages.first());
    }

    void namesWhatItNeeds()
    {
        QCOMPARE(field("Package"), QByteArray("odograph"));
        QCOMPARE(field("Section"), QByteArray("science"));
        const QByteArray needed = field("Depends");
        for (const char *library : {"libc6", "libqt6widgets6", "libqt6svg6", "libqt6sql6-sqlite",
                                    "libopencv-core", "libavcodec", "libaravis", "fonts-dejavu-core"})
            QVERIFY2(needed.contains(library), (QByteArray(library) + " is not among " + needed).constData());
        QVERIFY2(!needed.contains("qt5") && !needed.contains("-dev"), needed.constData());
        QVERIFY(field("Recommends").contains("qt6-wayland"));
    }

    void lintianFindsNoError()
    {
        const ProgramRun run =
            runCommand(QStringLiteral("lintian"),
                       {QStringLiteral("--fail-on"), QStringLiteral("error"), QStringLiteral("--allow-root"),
                        QStringLiteral("--tag-display-limit"), QStringLiteral("0"), m_package});
        QVERIFY2(run.exitStatus == 0, (run.out + run.err).constData());
    }

    void comesAndGoesWithoutATrace()
    {
        const QString tree = m_folder.filePath(QStringLiteral("tree"));
        for (const char *folder : {"var/lib/dpkg/info", "var/lib/dpkg/updates", "var/lib/dpkg/triggers"})
            QVERIFY(QDir().mkpath(tree + u'/' + QString::fromLatin1(folder)));
        for (const char *file : {"var/lib/dpkg/status", "var/lib/dpkg/available"}) {
            QFile empty(tree + u'/' + QString::fromLatin1(file));
            QVERIFY(empty.open(QIODevice::WriteOnly));
        }
        const auto installed = [&tree] {
            QSet<QString> files;
            for (const QString &file : filesIn(tree))
                if (!file.startsWith(QStringLiteral("/var/")))
                    files << file;
            return files;
        };
        const QSet<QString> before = installed();
        const ProgramRun in = dpkg(tree, {QStringLiteral("--install"), m_package});
        QVERIFY2(in.exitStatus == 0, (in.out + in.err).constData());
        const QSet<QString> there = installed();
        for (const char *file :
             {"/usr/bin/odograph", "/usr/share/applications/org.odograph.Odograph.desktop",
              "/usr/share/metainfo/org.odograph.Odograph.metainfo.xml",
              "/usr/share/mime/packages/org.odograph.Odograph.xml",
              "/usr/share/icons/hicolor/scalable/apps/org.odograph.Odograph.svg",
              "/usr/share/icons/hicolor/48x48/apps/org.odograph.Odograph.png",
              "/usr/share/icons/hicolor/48x48/mimetypes/application-x-odograph-project.png",
              "/usr/lib/udev/rules.d/70-odograph-cameras.rules", "/usr/share/man/man1/odograph.1.gz",
              "/usr/share/man/man1/odograph-track.1.gz", "/usr/share/bash-completion/completions/odograph",
              "/usr/share/zsh/vendor-completions/_odograph",
              "/usr/share/fish/vendor_completions.d/odograph.fish", "/usr/share/doc/odograph/copyright",
              "/usr/share/doc/odograph/changelog.gz"})
            QVERIFY2(there.contains(QString::fromLatin1(file)), file);
        const ProgramRun version =
            runCommand(tree + QStringLiteral("/usr/bin/odograph"), {QStringLiteral("--version")});
        QCOMPARE(version.out.trimmed(), "odograph " + field("Version"));
        const ProgramRun out = dpkg(tree, {QStringLiteral("--purge"), QStringLiteral("odograph")});
        QVERIFY2(out.exitStatus == 0, (out.out + out.err).constData());
        QVERIFY((installed() - before).isEmpty());
    }
};

ODOGRAPH_TEST(TestDebianPackage, QCoreApplication)
#include "tst_debian_package.moc"
