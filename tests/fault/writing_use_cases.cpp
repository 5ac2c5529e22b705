// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fault/writing_use_cases.h"

#include "core/base/error.h"
#include "core/exchange/project_archive.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/verdict_repository.h"
#include "core/workflow/export_job.h"
#include "core/workflow/import/import_tracks_job.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/media_upkeep.h"
#include "core/workflow/project_copy.h"
#include "core/workflow/record/completed_recordings.h"
#include "core/workflow/track/reanalysis.h"
#include "core/workflow/track/track_job.h"
#include "tests/support/said_error.h"
#include "tests/ui/support/stored_example.h"

#include <QDir>
#include <QFile>
#include <sqlite3.h>

namespace odo::test {

namespace {

namespace fs = std::filesystem;

void storeExampleIn(const fs::path &folder)
{
    if (const auto made = storeExample(folder); !made)
        qFatal("%s", made.error().message().c_str());
}

void write(const fs::path &file, const QByteArray &text)
{
    QFile out(QString::fromStdString(file.string()));
    if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size())
        qFatal("cannot write the test's file");
}

using Change = std::function<Result<void>(Project &)>;

Change undoable(const char *words, Change work)
{
    return [words, work = std::move(work)](Project &project) {
        return project.change(foreignWords(words), [&] { return work(project); });
    };
}

/// What people change, one after the other.
std::vector<Change> changes()
{
    const auto trial = [](Project &project) { return project.trials().find("Trial 1"); };
    return {
        [](Project &p) { return p.setTitle("Another title"); },
        undoable("add a robot",
                 [](Project &p) {
                     RobotRecord robot;
                     robot.name = "Green 3";
                     return withoutValue(p.robots().add(robot));
                 }),
        undoable("write notes",
                 [=](Project &p) { return p.trials().setNotes(trial(p)->id, std::string(20'000, 'n')); }),
        undoable("set tags",
                 [=](Project &p) {
                     return p.trials().setTags(trial(p)->id, {"wet", "été"});
                 }),
        undoable("accept its results",
                 [trial](Project &p) {
                     const VerdictAcceptance acceptance{"a cat ran past", instantNow(), {"few_spikes"}};
                     return p.verdicts().setAcceptance(trial(p)->id, acceptance);
                 }),
        [](Project &p) { return withoutValue(p.undo()); },
        [](Project &p) { return withoutValue(p.redo()); },
        [](Project &p) {
            return p.note(foreignWords("add a team"), [&] {
                return withoutValue(p.teams().add({0, "Kestrel", "9C"}));
            });
        },
        [](Project &p) {
            return withoutValue(p.cameras().add({0, "C", "v4l2:/dev/video9"}));
        },
        [=](Project &p) {
            const auto of = trial(p);
            auto series =
                p.trials().currentObservations(p.trials().recordings(of->id)->front().id, of->robots.front());
            if (!series)
                return Result<void>(tl::unexpected(series.error()));
            for (int i = 0; i < 10; ++i)
                (*series)->observations.insert((*series)->observations.end(), (*series)->observations.begin(),
                                               (*series)->observations.begin() + 20);
            std::ranges::sort((*series)->observations, {}, &Observation::frame);
            return p.trials().addObservations(**series);
        },
        undoable("star", [=](Project &p) { return p.trials().setStarred(trial(p)->id, true); }),
    };
}

/// A change that fails is tried once more, as a person would.
Result<void> makeChanges(const fs::path &folder, const Acknowledge &acknowledge)
{
    const auto project = Project::open(folder / "example.odo", Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    for (const Change &change : changes()) {
        auto done = change(**project);
        if (!done)
            done = change(**project);
        if (!done)
            return done;
        acknowledge();
    }
    return {};
}

template <class MakeJob>
Work jobIn(const MakeJob &makeJob)
{
    return [makeJob](const fs::path &folder, const Acknowledge &acknowledge) -> Result<void> {
        {
            const auto project = Project::open(folder / "example.odo", Project::Access::ReadWrite);
            if (!project)
                return tl::unexpected(project.error());
            const auto job = makeJob(folder, **project);
            if (auto done = runToEnd(*job, **project, {}); !done)
                return done;
        }
        acknowledge();
        return {};
    };
}

/// Work of one step.
Work single(const std::function<Result<void>(const fs::path &)> &work)
{
    return [work](const fs::path &folder, const Acknowledge &acknowledge) -> Result<void> {
        if (auto done = work(folder); !done)
            return done;
        acknowledge();
        return {};
    };
}

UseCase exporting()
{
    return {QStringLiteral("export tables"), storeExampleIn, jobIn([](const fs::path &folder, Project &) {
                return std::make_unique<ExportJob>("Trial 2", folder, TrackExport());
            })};
}

UseCase unpacking()
{
    const auto prepare = [](const fs::path &folder) {
        storeExampleIn(folder);
        const auto project = Project::open(folder / "example.odo", Project::Access::ReadWrite);
        PackJob job(folder / "packed.zip");
        if (auto done = runToEnd(job, **project, {}); !done)
            qFatal("%s", done.error().message().c_str());
    };
    return {QStringLiteral("unpack"), prepare, single([](const fs::path &folder) {
                return withoutValue(unpackArchive(folder / "packed.zip", folder / "unpacked", {}));
            })};
}

UseCase importingTracks()
{
    const auto prepare = [](const fs::path &folder) {
        storeExampleIn(folder);
        QByteArray text = "t_s,x_mm,y_mm\n";
        for (int i = 0; i < 200; ++i)
            text += QByteArray::number(i / 50.0, 'f', 3) + ',' +
                    QByteArray::number(500 * std::cos(i / 25.0), 'f', 3) + ',' +
                    QByteArray::number(500 * std::sin(i / 25.0), 'f', 3) + '\n';
        write(folder / "track.csv", text);
    };
    return {QStringLiteral("import a track"), prepare, jobIn([](const fs::path &folder, Project &) {
                ImportTracksSettings settings;
                settings.trial = "elsewhere";
                settings.tracks = {{"Red 2", folder / "track.csv"}};
                return std::make_unique<ImportTracksJob>(settings);
            })};
}

UseCase importingVideos()
{
    const auto prepare = [](const fs::path &folder) {
        storeExampleIn(folder);
        fs::create_directory(folder / "camera");
        for (const auto &file : fs::directory_iterator(folder / "example.media"))
            fs::copy(file, folder / "camera");
    };
    return {QStringLiteral("import videos"), prepare, jobIn([](const fs::path &folder, Project &) {
                ImportSettings settings;
                settings.trial = "from cards";
                settings.videos = {{"A", folder / "camera" / "A.mkv"}, {"B", folder / "camera" / "B.mkv"}};
                settings.steps = {{SyncBy::None, 0}};
                return std::make_unique<ImportTrialJob>(settings);
            })};
}

UseCase emptyingTheBin()
{
    const auto prepare = [](const fs::path &folder) {
        storeExampleIn(folder);
        const auto project = Project::open(folder / "example.odo", Project::Access::ReadWrite);
        for (const char *name : {"Trial 1", "Trial 2"})
            if (auto binned = (*project)->trials().setBinned((*project)->trials().find(name)->id, true);
                !binned)
                qFatal("%s", binned.error().message().c_str());
    };
    const auto work = [](const fs::path &folder, const Acknowledge &acknowledge) -> Result<void> {
        for (const char *name : {"Trial 1", "Trial 2"}) {
            const auto project = Project::open(folder / "example.odo", Project::Access::ReadWrite);
            if (!project)
                return tl::unexpected(project.error());
            auto content = binContent(**project);
            if (!content)
                return tl::unexpected(content.error());
            std::erase_if(content->trials, [name](const TrialName &trial) { return trial.name != name; });
            EmptyBinJob job(*content);
            if (auto done = runToEnd(job, **project, {}); !done)
                return done;
            if (!job.left().empty())
                return test::saidFailure(ErrorCode::Io, "file '" + job.left().front() + "'",
                                         "it could not be deleted", "delete it");
            acknowledge();
        }
        return {};
    };
    return {QStringLiteral("empty the bin"), prepare, work};
}

UseCase hashing()
{
    const auto prepare = [](const fs::path &folder) {
        storeExampleIn(folder);
        const auto project = Project::open(folder / "example.odo", Project::Access::ReadWrite);
        const auto recordings = (*project)->trials().allRecordings();
        for (const RecordingRecord &recording : *recordings)
            if (auto done = (*project)->trials().setHash(recording.id, ""); !done)
                qFatal("%s", done.error().message().c_str());
    };
    return {QStringLiteral("make hashes"), prepare,
            jobIn([](const fs::path &, Project &) { return std::make_unique<HashJob>(); })};
}

} // namespace

std::vector<UseCase> writingUseCases()
{
    return {
        {QStringLiteral("change things"), storeExampleIn, makeChanges},
        {QStringLiteral("make a project"), [](const fs::path &) {}, single([](const fs::path &folder) {
             return withoutValue(Project::create(folder / "new.odo", "New"));
         })},
        {QStringLiteral("copy"), storeExampleIn, jobIn([](const fs::path &folder, Project &) {
             return std::make_unique<CopyJob>(folder / "copy.odo");
         })},
        {QStringLiteral("next year's project"), storeExampleIn, single([](const fs::path &folder) {
             return withoutValue(
                 makeProjectLike(folder / "example.odo", folder / "next.odo", "Next year", {}));
         })},
        {QStringLiteral("pack"), storeExampleIn, jobIn([](const fs::path &folder, Project &) {
             return std::make_unique<PackJob>(folder / "packed.zip");
         })},
        unpacking(),
        exporting(),
        importingTracks(),
        importingVideos(),
        {QStringLiteral("mark a spike"), storeExampleIn, jobIn([](const fs::path &, Project &) {
             OverrideRequest request;
             request.trial = "Trial 1";
             request.frame = 12;
             return std::make_unique<OverrideJob>(request);
         })},
        hashing(),
        emptyingTheBin(),
    };
}

UseCase migration(int format)
{
    const auto prepare = [format](const fs::path &folder) {
        QFile dump(QDir(qEnvironmentVariable("ODOGRAPH_SOURCE_DIR"))
                       .filePath(QStringLiteral("tests/data/project_format_%1.sql").arg(format)));
        if (!dump.open(QIODevice::ReadOnly))
            qFatal("no dump of format %d", format);
        sqlite3 *database = nullptr;
        if (sqlite3_open((folder / "old.odo").c_str(), &database) != SQLITE_OK ||
            sqlite3_exec(database, dump.readAll().constData(), nullptr, nullptr, nullptr) != SQLITE_OK)
            qFatal("format %d: %s", format, sqlite3_errmsg(database));
        sqlite3_close(database);
    };
    return {QStringLiteral("migrate format %1").arg(format), prepare, single([](const fs::path &folder) {
                return withoutValue(Project::open(folder / "old.odo", Project::Access::ReadWrite));
            })};
}

} // namespace odo::test
