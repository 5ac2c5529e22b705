// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/media_copy.h"

#include "tests/support/registered_test.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <fstream>
#include <future>
#include <thread>

using namespace odo;

class TestMediaCopy : public QObject
{
    Q_OBJECT

    static std::filesystem::path makeFile(const QTemporaryDir &folder, const QByteArray &content)
    {
        const QString name = folder.filePath(QStringLiteral("source.mkv"));
        QFile file(name);
        if (file.open(QIODevice::WriteOnly))
            file.write(content);
        return name.toStdString();
    }

private Q_SLOTS:
    void copiesWithItsHash()
    {
        const QTemporaryDir folder;
        const QByteArray content(9 << 20, 'x'); // more than two blocks
        const auto source = makeFile(folder, content);
        const std::filesystem::path media = folder.filePath(QStringLiteral("p.media")).toStdString();
        const auto copy = copyIntoMedia(source, media, "run 1_A", {});
        QVERIFY2(copy.has_value(), copy ? "" : copy.error().message().c_str());
        QCOMPARE(copy->file.path(), media / "run_1_A.mkv");
        QCOMPARE(copy->bytes, std::int64_t(content.size()));
        QCOMPARE(copy->sha256,
                 QCryptographicHash::hash(content, QCryptographicHash::Sha256).toHex().toStdString());
        QFile written(QString::fromStdString(copy->file.path().string()));
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll(), content);
    }

    void neverOverwritesAndNeverLeavesTheFolder()
    {
        const QTemporaryDir folder;
        const auto source = makeFile(folder, "abc");
        const std::filesystem::path media = folder.filePath(QStringLiteral("p.media")).toStdString();
        QCOMPARE(copyIntoMedia(source, media, "../../etc/A", {})->file.path().parent_path(), media);
        const auto first = copyIntoMedia(source, media, "A", {}),
                   second = copyIntoMedia(source, media, "A", {});
        QVERIFY(first->file.path() != second->file.path());
    }

    /// As an import that failed removes its own, whatever has the name by now.
    void onlyWhatIsKeptStays()
    {
        const QTemporaryDir folder;
        const auto source = makeFile(folder, "abc");
        const std::filesystem::path media = folder.filePath(QStringLiteral("p.media")).toStdString();
        {
            auto kept = copyIntoMedia(source, media, "A", {});
            const auto dropped = copyIntoMedia(source, media, "A", {});
            QCOMPARE(QDir(QString::fromStdString(media.string())).entryList(QDir::Files).size(), 2);
            kept->file.keep();
        }
        QCOMPARE(QDir(QString::fromStdString(media.string())).entryList(QDir::Files),
                 QStringList{QStringLiteral("A.mkv")});
    }

    void whatSomebodyWritesIsRefused()
    {
        const QTemporaryDir folder;
        const std::filesystem::path media = folder.path().toStdString();
        const auto written = claimMediaFile(media, "A", ".mkv");
        const auto copy = copyIntoMedia(written->path(), media, "B", {});
        QVERIFY(!copy && copy.error().code == ErrorCode::Unavailable);
        QVERIFY(copy.error().message().find("another program is writing or removing it") !=
                std::string::npos);
    }

    void aFileInTheMediaFolderStaysWhereItIs()
    {
        const QTemporaryDir folder;
        const auto source = makeFile(folder, "abc");
        std::optional<Result<MediaCopy>> made = copyIntoMedia(source, source.parent_path(), "A", {});
        QVERIFY(made->has_value());
        QCOMPARE((*made)->file.path(), source);
        made.reset();
        QVERIFY(std::filesystem::exists(source));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    /// As a project and its media folder are renamed while a video is hashed that lies there already.
    void theBytesOfAFileThatIsRenamedMeanwhileAreKnown()
    {
        const QTemporaryDir folder;
        const std::filesystem::path media = folder.filePath(QStringLiteral("p.media")).toStdString();
        std::filesystem::create_directory(media);
        constexpr std::uintmax_t bytes = 400'000'000; // of a file that takes no room
        {
            std::ofstream(media / "a.mkv");
        }
        std::filesystem::resize_file(media / "a.mkv", bytes);
        auto copy =
            std::async(std::launch::async, [&] { return copyIntoMedia(media / "a.mkv", media, "A", {}); });
        const auto isBeingHashed = [&] {
            int open = 0;
            std::error_code isGone;
            for (const auto &each : std::filesystem::directory_iterator("/proc/self/fd"))
                open += std::filesystem::read_symlink(each.path(), isGone) == media / "a.mkv";
            return open > 1; // it is claimed, and read
        };
        while (!isBeingHashed())
            std::this_thread::yield();
        std::filesystem::rename(media, folder.filePath(QStringLiteral("q.media")).toStdString());
        const auto made = copy.get();
        QVERIFY2(made.has_value(), made ? "" : made.error().message().c_str());
        QCOMPARE(made->bytes, std::int64_t(bytes));
    }

    void cancelledLeavesNothing()
    {
        const QTemporaryDir folder;
        const auto source = makeFile(folder, "abc");
        const std::filesystem::path media = folder.filePath(QStringLiteral("p.media")).toStdString();
        JobControl control;
        control.cancel.cancel();
        const auto copy = copyIntoMedia(source, media, "A", control);
        QVERIFY(!copy.has_value());
        QCOMPARE(copy.error().code, ErrorCode::Cancelled);
        QVERIFY(QDir(QString::fromStdString(media.string())).isEmpty(QDir::Files | QDir::Hidden));
    }

    void aFolderThatCannotBeMadeIsSaid()
    {
        const QTemporaryDir folder;
        const auto source = makeFile(folder, "abc");
        const auto copy = copyIntoMedia(source, source / "p.media", "A", {}); // below a file
        QVERIFY(!copy.has_value());
        QCOMPARE(copy.error().code, ErrorCode::Io);
        QVERIFY(copy.error().message().find("source.mkv") != std::string::npos);
    }
};

ODOGRAPH_TEST(TestMediaCopy, QCoreApplication)
#include "tst_media_copy.moc"
