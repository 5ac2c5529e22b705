// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/empty_bin.h"

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
        const RecordId one = addTrial("one", {"year.media/own.mkv", "year.media/shared.mkv", "elsewhere.mkv"});
        const RecordId two = addTrial("two", {"year.media/shared.mkv"});
        QVERIFY(m_project->trials().setBinned(one, true));
        const BinContent content = binContent(*m_project).value();
        QCOMPARE(content.trials, std::vector<RecordId>{one});
        QCOMPARE(content.bytes, std::int64_t(30));
        const auto left = emptyBin(*m_project, content);
        QVERIFY2(left, left ? "" : left.error().message().c_str());
        QVERIFY(left->empty());
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
        QCOMPARE(emptyBin(*m_project, binContent(*m_project).value()).value(), std::vector<std::string>{path("year.media/folder").string()});
    }

    void nothingGoesWhenOneWasTakenOut()
    {
        const RecordId one = addTrial("one", {"year.media/one.mkv"}), two = addTrial("two", {"year.media/two.mkv"});
        QVERIFY(m_project->trials().setBinned(one, true) && m_project->trials().setBinned(two, true));
        const BinContent content = binContent(*m_project).value();
        QVERIFY(m_project->trials().setBinned(two, false));
        QCOMPARE(emptyBin(*m_project, content).error().message(), std::string("trial 'two': it is not in the bin; put it into the bin first"));
        QCOMPARE(m_project->trials().all()->size(), std::size_t(2));
        QVERIFY(std::filesystem::exists(path("year.media/one.mkv")));
    }

private:
    std::filesystem::path path(const char *name) const { return m_folder->filePath(QString::fromLatin1(name)).toStdString(); }
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

QTEST_GUILESS_MAIN(TestEmptyBin)
#include "tst_empty_bin.moc"
