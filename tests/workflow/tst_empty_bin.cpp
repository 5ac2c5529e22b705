// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/media_upkeep.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestEmptyBin : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = std::move(*Project::create(path("year.odo"), "Year"));
        std::filesystem::create_directories(m_project->mediaFolder());
        m_camera = m_project->cameras().add({0, "A", ""}).value().id;
    }

    /// Only files in the media folder that no other trial needs go; what is elsewhere is somebody's own.
    void filesOfItsOwnGo()
    {
        const RecordId one =
            addTrial("one", {"year.media/own.mkv", "year.media/shared.mkv", "elsewhere.mkv"});
        const RecordId two = addTrial("two", {"year.media/shared.mkv"});
        QVERIFY(m_project->trials().setBinned(one, true));
        const BinContent content = binContent(*m_project).value();
        QVERIFY(content.trials.size() == 1 && content.trials[0].id == one);
        QCOMPARE(content.bytes, std::int64_t(30));
        EmptyBinJob job(content);
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QVERIFY(job.left().empty());
        QCOMPARE(job.removedCount(), 1);
        QCOMPARE(m_project->changes()->front().words.english(), std::string("remove one for good"));
        QVERIFY(!std::filesystem::exists(path("year.media/own.mkv")));
        QVERIFY(std::filesystem::exists(path("year.media/shared.mkv")));
        QVERIFY(std::filesystem::exists(path("elsewhere.mkv")));
        QVERIFY(!m_project->trials().find("one") && m_project->trials().get(two));
    }

    /// A file that is gone already is no failure; one that cannot be removed is told.
    void whatCannotBeDeletedIsTold()
    {
        const RecordId one = addTrial("one", {"year.media/gone.mkv", "year.media/folder"});
        std::filesystem::remove(path("year.media/gone.mkv"));
        std::filesystem::remove(path("year.media/folder"));
        std::filesystem::create_directories(path("year.media/folder/full"));
        QVERIFY(m_project->trials().setBinned(one, true));
        EmptyBinJob job(binContent(*m_project).value());
        QVERIFY(runToEnd(job, *m_project, {}));
        QCOMPARE(job.left(), std::vector<std::string>{path("year.media/folder").string()});
    }

    /// A project may come from anyone, with a folder that is a link.
    void whatALinkLeadsToStays()
    {
        std::filesystem::create_directories(path("mine"));
        std::filesystem::create_symlink(path("mine"), path("year.media/link"));
        const RecordId one = addTrial("one", {"year.media/link/own.mkv"});
        QVERIFY(m_project->trials().setBinned(one, true));
        EmptyBinJob job(binContent(*m_project).value());
        QVERIFY(runToEnd(job, *m_project, {}));
        QVERIFY(std::filesystem::exists(path("mine/own.mkv")));
    }

    void whatWasTakenOutStays()
    {
        const RecordId one = addTrial("one", {"year.media/one.mkv"}),
                       two = addTrial("two", {"year.media/two.mkv"});
        QVERIFY(m_project->trials().setBinned(one, true) && m_project->trials().setBinned(two, true));
        EmptyBinJob job(binContent(*m_project).value());
        QVERIFY(m_project->trials().setBinned(two, false));
        QVERIFY(runToEnd(job, *m_project, {}));
        QCOMPARE(job.wantedCount(), 2);
        QCOMPARE(job.removedCount(), 1);
        QVERIFY(std::filesystem::exists(path("year.media/two.mkv")) && m_project->trials().get(two));
    }

    /// Cancelled, the rest stays where it was.
    void aCancelledOneEndsWell()
    {
        for (const char *name : {"one", "two", "three"})
            QVERIFY(m_project->trials().setBinned(addTrial(name, {}), true));
        EmptyBinJob job(binContent(*m_project).value());
        JobControl control;
        control.progress = [&](double fraction, const Message &) {
            if (fraction > 0.5)
                control.cancel.cancel();
        };
        QVERIFY(runToEnd(job, *m_project, control));
        QCOMPARE(job.removedCount(), 3);
        QVERIFY(m_project->trials().setBinned(addTrial("four", {}), true));
        EmptyBinJob none(binContent(*m_project).value());
        control.progress = nullptr;
        QVERIFY(runToEnd(none, *m_project, control)); // it is cancelled already
        QCOMPARE(none.removedCount(), 0);
        QVERIFY(m_project->trials().find("four")->binned);
    }

private:
    std::filesystem::path path(const char *name) const
    {
        return m_folder->filePath(QString::fromLatin1(name)).toStdString();
    }
    RecordId addTrial(const std::string &name, const std::vector<std::string> &paths)
    {
        TrialRecord trial;
        trial.name = name;
        std::vector<RecordingRecord> recordings;
        for (const std::string &each : paths) {
            QFile file(m_folder->filePath(QString::fromStdString(each)));
            if (!file.open(QIODevice::WriteOnly) || file.write("0123456789") != 10)
                qFatal("no file");
            RecordingRecord recording;
            recording.camera = m_camera;
            recording.path = path(each.c_str()).string();
            recording.bytes = 10;
            recordings.push_back(recording);
        }
        return m_project->trials().add(trial, recordings).value().id;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    RecordId m_camera = 0;
};

ODOGRAPH_TEST(TestEmptyBin, QCoreApplication)
#include "tst_empty_bin.moc"
