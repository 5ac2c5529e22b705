// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/temporary.h"

#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <fcntl.h>
#include <set>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

using namespace odo;

class TestClaimedFile : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void aNameThatIsTakenGetsANumber()
    {
        const auto first = ClaimedFile::create(path(), "run", ".mkv"),
                   second = ClaimedFile::create(path(), "run", ".mkv");
        QCOMPARE(first->path(), path("run.mkv"));
        QCOMPARE(second->path(), path("run_2.mkv"));
    }

    /// What a link leads to is somebody else's, even where there is nothing yet.
    void aLinkIsATakenName()
    {
        std::filesystem::create_symlink(path("elsewhere"), path("run.mkv"));
        const auto file = ClaimedFile::create(path(), "run", ".mkv");
        QCOMPARE(file->path(), path("run_2.mkv"));
        QVERIFY(!std::filesystem::exists(path("elsewhere")));
    }

    void whatIsNotKeptGoes()
    {
        {
            auto kept = ClaimedFile::create(path(), "kept", ".mkv");
            const auto other = ClaimedFile::create(path(), "other", ".mkv");
            QVERIFY(!kept->write(std::string("abc")));
            kept->keep();
        }
        QCOMPARE(names(), QStringList({QStringLiteral("kept.mkv")}));
        QCOMPARE(std::filesystem::file_size(path("kept.mkv")), std::uintmax_t(3));
        auto again = ClaimedFile::hold(path("kept.mkv"));
        again->remove(); // it did not make it
        QCOMPARE(names(), QStringList({QStringLiteral("kept.mkv")}));
        auto recorded = ClaimedFile::create(path(), "recorded", ".mkv");
        recorded->keep();
        recorded->remove();
        QCOMPARE(names(), QStringList({QStringLiteral("kept.mkv")}));
    }

    /// As when two imports of one name removed each other's videos.
    void anotherFileOfItsNameStays()
    {
        {
            const auto mine = ClaimedFile::create(path(), "run", ".mkv");
            std::filesystem::rename(path("run.mkv"), path("moved.mkv"));
            write("run.mkv", "somebody else's");
        }
        QCOMPARE(names(), (QStringList({QStringLiteral("moved.mkv"), QStringLiteral("run.mkv")})));
    }

    void whatWasBegunGetsItsNameWhenItIsWhole()
    {
        write("run.mkv", "there before");
        {
            auto file = ClaimedFile::begin(path());
            QVERIFY(!file->write(std::string("whole")));
            QVERIFY(!file->sync());
            const QString name = QString::fromStdString(file->path().filename().string());
            QVERIFY2(name.startsWith(QStringLiteral(".new-")) && name.endsWith(QStringLiteral(".part")),
                     qPrintable(name));
            QVERIFY(!file->publish("run", ".mkv"));
            QCOMPARE(file->path(), path("run_2.mkv"));
            file->keep();
        }
        QCOMPARE(names(), (QStringList({QStringLiteral("run.mkv"), QStringLiteral("run_2.mkv")})));
        QCOMPARE(content("run.mkv"), QByteArray("there before"));
        QCOMPARE(content("run_2.mkv"), QByteArray("whole"));
        {
            const auto dropped = ClaimedFile::begin(path());
        }
        QCOMPARE(names().size(), 2);
    }

    void threadsNeverShareAName()
    {
        constexpr int each = 50, workers = 4;
        std::vector<std::vector<ClaimedFile>> claimed(workers);
        std::vector<std::thread> threads;
        for (int i = 0; i < workers; ++i)
            threads.emplace_back([&, i] {
                for (int n = 0; n < each; ++n) {
                    auto file =
                        n % 2 == 0 ? ClaimedFile::create(path(), "run", ".mkv") : ClaimedFile::begin(path());
                    if (file && (n % 2 == 0 || !file->publish("run", ".mkv")))
                        claimed[std::size_t(i)].push_back(std::move(*file));
                }
            });
        for (std::thread &thread : threads)
            thread.join();
        std::set<std::filesystem::path> paths;
        for (const auto &files : claimed)
            for (const ClaimedFile &file : files)
                paths.insert(file.path());
        QCOMPARE(paths.size(), std::size_t(each * workers));
        QCOMPARE(names().size(), each * workers);
    }

    void othersSeeThatItIsClaimed()
    {
        auto file = ClaimedFile::create(path(), "run", ".mkv");
        file->keep();
        const auto held = ClaimedFile::hold(path("run.mkv"));
        QVERIFY(!held && held.error() == std::errc::resource_unavailable_try_again);
        file.value() = ClaimedFile();
        const auto one = ClaimedFile::hold(path("run.mkv")), two = ClaimedFile::hold(path("run.mkv"));
        QVERIFY(one && two);
        const int descriptor = ::open(path("run.mkv").c_str(), O_RDONLY | O_CLOEXEC);
        QVERIFY(::flock(descriptor, LOCK_EX | LOCK_NB) != 0); // who would remove it
        ::close(descriptor);
    }

    void theSystemsReasonIsGiven()
    {
        QVERIFY(ClaimedFile::create(path("nowhere"), "run", ".mkv").error() ==
                std::errc::no_such_file_or_directory);
        QVERIFY(ClaimedFile::begin(path("nowhere")).error() == std::errc::no_such_file_or_directory);
        QVERIFY(ClaimedFile::create(path(), std::string(300, 'x'), ".mkv").error() ==
                std::errc::filename_too_long);
    }

private:
    std::filesystem::path path(const std::string &name = {}) const
    {
        const std::filesystem::path folder = m_folder->path().toStdString();
        return name.empty() ? folder : folder / name;
    }
    QStringList names() const
    {
        return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden | QDir::System, QDir::Name);
    }
    void write(const std::string &name, const QByteArray &bytes) const
    {
        QFile file(QString::fromStdString(path(name).string()));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    QByteArray content(const std::string &name) const
    {
        QFile file(QString::fromStdString(path(name).string()));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

ODOGRAPH_TEST(TestClaimedFile, QCoreApplication)
#include "tst_claimed_file.moc"
