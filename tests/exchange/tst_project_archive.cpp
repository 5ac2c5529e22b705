// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/project_archive.h"

#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <archive.h>
#include <archive_entry.h>

using namespace odo;

namespace {

/// A file of an archive that somebody else has made.
struct Foreign
{
    const char *name, *content;
    unsigned type = AE_IFREG;
};

void writeForeign(const QString &file, const std::vector<Foreign> &entries)
{
    archive *writer = archive_write_new();
    archive_write_set_format_zip(writer);
    archive_write_open_filename(writer, qPrintable(file));
    for (const Foreign &each : entries) {
        archive_entry *entry = archive_entry_new();
        archive_entry_set_pathname_utf8(entry, each.name);
        archive_entry_set_filetype(entry, each.type);
        archive_entry_set_perm(entry, 0644);
        if (each.type == AE_IFLNK)
            archive_entry_set_symlink(entry, each.content);
        else
            archive_entry_set_size(entry, static_cast<la_int64_t>(qstrlen(each.content)));
        archive_write_header(writer, entry);
        if (each.type != AE_IFLNK)
            archive_write_data(writer, each.content, qstrlen(each.content));
        archive_entry_free(entry);
    }
    archive_write_free(writer);
}

} // namespace

class TestProjectArchive : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void whatIsPackedIsUnpacked()
    {
        const QByteArray video = QByteArray(3'000'000, 'v') + "end";
        std::vector<ArchiveEntry> entries{{"Übung 1.odo", write("a", "project")},
                                          {"Übung 1.media/run 1_A.mkv", write("b", video)},
                                          {"Übung 1.media/calibration/x.png", write("c", "")}};
        double last = 0;
        JobControl control;
        control.progress = [&last](double fraction, const Message &) {
            QVERIFY(fraction >= last && fraction <= 1);
            last = fraction;
        };
        const auto packed = writeArchive(path("p.zip").toStdString(), entries, control);
        QVERIFY2(packed, packed ? "" : packed.error().message().c_str());
        QVERIFY(last > 0.99);
        const auto unpacked = unpackArchive(path("p.zip").toStdString(), path("new").toStdString(), {});
        QVERIFY2(unpacked, unpacked ? "" : unpacked.error().message().c_str());
        QCOMPARE(QString::fromStdString(unpacked->string()), path("new/Übung 1.odo"));
        QCOMPARE(read("new/Übung 1.odo"), QByteArray("project"));
        QCOMPARE(read("new/Übung 1.media/run 1_A.mkv"), video);
        QVERIFY(QFile::exists(path("new/Übung 1.media/calibration/x.png")));
        QCOMPARE(files(), QStringList({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c"),
                                       QStringLiteral("new"), QStringLiteral("p.zip")}));
    }

    void nothingIsHalfWritten()
    {
        const auto file = write("a", QByteArray(5'000'000, 'x'));
        const QByteArray before = "PK\x03\x04 the one before";
        write("p.zip", before);
        JobControl control;
        control.progress = [&control](double, const Message &) { control.cancel.cancel(); };
        const auto cancelled =
            writeArchive(path("p.zip").toStdString(), {{"p.odo", file}, {"p.media/x", file}}, control);
        QCOMPARE(cancelled.error().code, ErrorCode::Cancelled);
        const auto missing =
            writeArchive(path("p.zip").toStdString(), {{"p.odo", path("no").toStdString()}}, {});
        QCOMPARE(missing.error().message(), "pack '" + path("no").toStdString() +
                                                "': the file does not exist; check the name and the folder");
        QCOMPARE(read("p.zip"), before);
        QCOMPARE(files(), QStringList({QStringLiteral("a"), QStringLiteral("p.zip")}));
        const auto refused = writeArchive("/no/such/folder/p.zip", {{"p.odo", file}}, {});
        QCOMPARE(refused.error().code, ErrorCode::NotFound);
    }

    void unpackingIsCancelled()
    {
        const auto file = write("a", QByteArray(9'000'000, 'x'));
        QVERIFY(writeArchive(path("p.zip").toStdString(), {{"p.odo", file}, {"p.media/x", file}}, {}));
        JobControl control;
        control.progress = [&control](double, const Message &) { control.cancel.cancel(); };
        QCOMPARE(unpackArchive(path("p.zip").toStdString(), path("new").toStdString(), control).error().code,
                 ErrorCode::Cancelled);
        QCOMPARE(files(), QStringList({QStringLiteral("a"), QStringLiteral("p.zip")}));
    }

    void anExistingFolderIsLeftAlone()
    {
        write("mine", "mine");
        writeForeign(path("p.zip"), {{"p.odo", "x"}});
        const auto refused = unpackArchive(path("p.zip").toStdString(), path("mine").toStdString(), {});
        QCOMPARE(refused.error().message(),
                 "unpack into '" + path("mine").toStdString() +
                     "': it already exists; choose a folder that does not exist yet");
        QCOMPARE(read("mine"), QByteArray("mine"));
    }

    void whatDoesNotBelongIsRefused_data()
    {
        QTest::addColumn<QList<QByteArray>>("names");
        QTest::addColumn<QString>("why");
        const auto row = [](const char *name, const QList<QByteArray> &names, const char *why) {
            QTest::addRow("%s", name) << names << QString::fromLatin1(why);
        };
        row("climbs out", {"p.odo", "../evil"}, "'../evil' does not belong in a packed project");
        row("climbs out of the media", {"p.odo", "p.media/../../evil"}, "does not belong");
        row("absolute", {"p.odo", "/tmp/evil"}, "does not belong");
        row("another folder", {"p.odo", "q.media/x"}, "does not belong");
        row("a second project", {"p.odo", "q.odo"}, "does not belong");
        row("beside", {"p.odo", "p.odo-wal"}, "does not belong");
        row("the same twice", {"p.odo", "p.media/x", "p.media/x"}, "it contains 'p.media/x' twice");
        row("a file as a folder", {"p.odo", "p.media/x", "p.media/x/y"}, "Not a directory");
        row("its own lock", {"p.odo", "p.odo.lock"}, "does not belong");
        row("by a detour", {"p.odo", "p.media/./x"}, "does not belong");
        row("in the folder's place", {"p.odo", "p.media/.."}, "does not belong");
        row("a link", {"p.odo", "@p.media/x"}, "does not belong");
        row("no project", {"p.media/x"}, "does not belong");
        row("a hidden one", {".odo"}, "does not belong");
        row("empty", {}, "it contains no project");
    }
    void whatDoesNotBelongIsRefused()
    {
        QFETCH(QList<QByteArray>, names);
        QFETCH(QString, why);
        std::vector<Foreign> entries;
        for (const QByteArray &name : names)
            entries.push_back(name.startsWith('@') ? Foreign{name.constData() + 1, "/etc/passwd", AE_IFLNK}
                                                   : Foreign{name.constData(), "x"});
        writeForeign(path("p.zip"), entries);
        const auto refused = unpackArchive(path("p.zip").toStdString(), path("new").toStdString(), {});
        QVERIFY(!refused);
        QVERIFY2(refused.error().message().find(why.toStdString()) != std::string::npos,
                 refused.error().message().c_str());
        QCOMPARE(files(), QStringList{QStringLiteral("p.zip")});
    }

    /// A hundred megabytes of nothing take a hundred kilobytes; a video takes what it has.
    void whatGrowsWithoutBoundIsRefused()
    {
        const auto bomb = write("bomb", QByteArray(100 << 20, '\0'));
        QVERIFY(writeArchive(path("p.zip").toStdString(), {{"p.odo", bomb}}, {}));
        const auto refused = unpackArchive(path("p.zip").toStdString(), path("new").toStdString(), {});
        QVERIFY(!refused);
        QCOMPARE(refused.error().message(),
                 "unpack '" + path("p.zip").toStdString() +
                     "': it unpacks to more than a hundred times its size; choose a file that Odograph has "
                     "packed; if it is damaged, copy it again");
        QVERIFY(writeArchive(path("q.zip").toStdString(),
                             {{"q.odo", write("a", "project")}, {"q.media/x", bomb}}, {}));
        QVERIFY(unpackArchive(path("q.zip").toStdString(), path("other").toStdString(), {}));
        QVERIFY(!QFile::exists(path("new")) && !QFile::exists(path("new.part")));
    }

    void whatIsNoArchiveIsRefused()
    {
        const auto file = write("a", QByteArray(2'000'000, 'x'));
        QVERIFY(writeArchive(path("p.zip").toStdString(), {{"p.odo", file}, {"p.media/x", file}}, {}));
        const QByteArray whole = read("p.zip");
        for (const QByteArray &bad :
             {QByteArray(), QByteArray("no archive at all"), whole.left(whole.size() / 2)}) {
            write("bad.zip", bad);
            const auto refused = unpackArchive(path("bad.zip").toStdString(), path("new").toStdString(), {});
            QVERIFY(!refused);
            QCOMPARE(refused.error().code, ErrorCode::InvalidInput);
            QCOMPARE(
                QDir(m_folder->path()).entryList({QStringLiteral("new*")}, QDir::AllEntries | QDir::Hidden),
                QStringList());
        }
    }

private:
    QString path(const char *name) const { return m_folder->filePath(QString::fromUtf8(name)); }
    std::filesystem::path write(const char *name, const QByteArray &content) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write the test's file");
        return path(name).toStdString();
    }
    QByteArray read(const char *name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("not there");
    }
    QStringList files() const
    {
        return QDir(m_folder->path())
            .entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden, QDir::Name);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

ODOGRAPH_TEST(TestProjectArchive, QCoreApplication)
#include "tst_project_archive.moc"
