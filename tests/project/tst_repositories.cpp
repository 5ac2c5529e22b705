// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "sample_records.h"

#include <QTemporaryDir>
#include <QTest>
#include <bit>

using namespace odo;

namespace {

/// Equal to the last bit, so that -0 and NaN count too.
bool same(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <class A, class B>
bool sameMatrix(const Eigen::MatrixBase<A> &a, const Eigen::MatrixBase<B> &b)
{
    if (a.rows() != b.rows() || a.cols() != b.cols())
        return false;
    for (Eigen::Index r = 0; r < a.rows(); ++r) {
        for (Eigen::Index c = 0; c < a.cols(); ++c) {
            if (!same(a(r, c), b(r, c)))
                return false;
        }
    }
    return true;
}

bool sameLens(const Intrinsics &a, const Intrinsics &b)
{
    return a.widthPx == b.widthPx && a.heightPx == b.heightPx && same(a.fxPx, b.fxPx) &&
           same(a.fyPx, b.fyPx) && same(a.cxPx, b.cxPx) && same(a.cyPx, b.cyPx) && a.model == b.model &&
           a.distortion == b.distortion && sameMatrix(a.covariance, b.covariance);
}

bool sameObservation(const Observation &a, const Observation &b)
{
    return a.frame == b.frame && a.time == b.time && a.found == b.found &&
           a.duplicateFrame == b.duplicateFrame && a.touchesBorder == b.touchesBorder &&
           sameMatrix(a.ellipse.centrePx, b.ellipse.centrePx) &&
           same(a.ellipse.semiMajorPx, b.ellipse.semiMajorPx) &&
           same(a.ellipse.semiMinorPx, b.ellipse.semiMinorPx) &&
           same(a.ellipse.angleRad, b.ellipse.angleRad) &&
           sameMatrix(a.centreCovariancePx2, b.centreCovariancePx2) && same(a.areaPx, b.areaPx) &&
           same(a.score, b.score);
}

bool sameSample(const Sample &a, const Sample &b)
{
    return a.time == b.time && a.frame == b.frame && a.position.has_value() == b.position.has_value() &&
           (!a.position || sameMatrix(*a.position, *b.position)) && sameMatrix(a.covariance, b.covariance) &&
           sameMatrix(a.commonCovariance, b.commonCovariance) && a.views == b.views &&
           a.viewDisagreementM == b.viewDisagreementM && a.flags == b.flags;
}

bool samePoint(const ProfilePoint &a, const ProfilePoint &b)
{
    return sameMatrix(a.position, b.position) && sameMatrix(a.velocity, b.velocity) &&
           sameMatrix(a.acceleration, b.acceleration) && same(a.sigmaXM, b.sigmaXM) &&
           same(a.sigmaYM, b.sigmaYM) && same(a.speedMps, b.speedMps) &&
           same(a.sigmaSpeedMps, b.sigmaSpeedMps) && same(a.accelMps2, b.accelMps2) &&
           same(a.sigmaAccelMps2, b.sigmaAccelMps2) && a.valid == b.valid;
}

} // namespace

class TestRepositories : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        auto created = Project::create(file(), "Class 8b – été");
        QVERIFY2(created.has_value(), created ? "" : created.error().message().c_str());
        m_project = std::move(*created);
    }
    void cleanup()
    {
        m_project.reset();
        m_folder.reset();
    }

    void keepsTheTitle()
    {
        QCOMPARE(m_project->title(), std::string("Class 8b – été"));
        QVERIFY(m_project->setTitle("новый").has_value());
        reopen();
        QCOMPARE(m_project->title(), std::string("новый"));
    }

    void camerasRoundTrip()
    {
        const auto a = m_project->cameras().add({0, "Kamera ß", "v4l2:/dev/video0"});
        const auto b = m_project->cameras().add({0, "B", ""});
        QVERIFY(m_project->cameras().setDevice(b->id, "aravis:S1?rate=60"));
        QCOMPARE(m_project->cameras().find("B")->deviceUri, std::string("aravis:S1?rate=60"));
        QVERIFY(m_project->cameras().setDevice(b->id, ""));
        QVERIFY(a && b && a->id != 0 && a->id != b->id);
        reopen();
        QCOMPARE(m_project->cameras().all()->size(), std::size_t(2));
        QCOMPARE(m_project->cameras().find("Kamera ß")->deviceUri, std::string("v4l2:/dev/video0"));
        QCOMPARE(m_project->cameras().get(b->id)->name, std::string("B"));
        QVERIFY(m_project->cameras().get(b->id)->deviceUri.empty());
        QVERIFY(!m_project->cameras().currentIntrinsics(a->id)->has_value());
        QVERIFY(!m_project->cameras().currentRegistration(a->id)->has_value());
    }

    void intrinsicsRoundTripAndTheNewestIsInForce()
    {
        const RecordId camera = m_project->cameras().add({0, "A", ""})->id;
        const auto older = m_project->cameras().addIntrinsics(m_source.calibration(camera));
        IntrinsicsRecord wanted = m_source.calibration(camera);
        wanted.calibration.intrinsics = Intrinsics{640, 480, 1, 2, 3, 4, LensModel::Standard, {}, {}};
        const auto newer = m_project->cameras().addIntrinsics(wanted);
        QVERIFY(older && newer);
        reopen();
        const auto current = m_project->cameras().currentIntrinsics(camera);
        QVERIFY(current && *current);
        QCOMPARE((*current)->id, newer->id);
        QVERIFY(sameLens((*current)->calibration.intrinsics, wanted.calibration.intrinsics));
        const auto first = m_project->cameras().intrinsics(older->id);
        QVERIFY(first.has_value());
        QCOMPARE(first->camera, camera);
        QVERIFY(first->made == older->made);
        QCOMPARE(first->origin, older->origin);
        const IntrinsicCalibration &read = first->calibration, &stored = older->calibration;
        QVERIFY(sameLens(read.intrinsics, stored.intrinsics));
        QVERIFY(same(read.rmsPx, stored.rmsPx) && same(read.crossValidationPx, stored.crossValidationPx));
        QCOMPARE(read.pictures.size(), stored.pictures.size());
        for (std::size_t i = 0; i < read.pictures.size(); ++i) {
            QCOMPARE(read.pictures[i].view.source, stored.pictures[i].view.source);
            QVERIFY(same(read.pictures[i].rmsPx, stored.pictures[i].rmsPx));
            QCOMPARE(read.pictures[i].used, i == 0);
            QCOMPARE(read.pictures[i].view.columns, 9);
            QCOMPARE(read.pictures[i].view.pattern, BoardPattern::Charuco);
            QVERIFY(read.pictures[i].view.pixels == stored.pictures[i].view.pixels);
            QVERIFY(read.pictures[i].view.pointsOnBoard == stored.pictures[i].view.pointsOnBoard);
            QVERIFY(read.pictures[i].residualsPx == stored.pictures[i].residualsPx);
            QVERIFY(read.pictures[i].outliers == stored.pictures[i].outliers);
            QVERIFY(read.pictures[i].leftOut == stored.pictures[i].leftOut);
        }
        QCOMPARE(read.lensReason, stored.lensReason);
        QVERIFY(same(read.disagreeingPart, stored.disagreeingPart));
        QCOMPARE(first->softwareVersion, older->softwareVersion);
        QCOMPARE(first->board.rows, 6);
        QCOMPARE(first->board.dictionary, std::string("DICT_6X6_250"));
        QVERIFY(same(first->board.squareM, older->board.squareM) && same(first->board.markerRatio, older->board.markerRatio));
        QCOMPARE(first->files.size(), std::size_t(2));
        QCOMPARE(first->files[0].path, older->files[0].path);
        QCOMPARE(first->files[0].sha256, older->files[0].sha256);
        QCOMPARE(first->files[0].bytes, std::int64_t(12345));
        QVERIFY(first->files[1].path.empty());
        const auto all = m_project->cameras().allIntrinsics(camera);
        QVERIFY(all && all->size() == 2 && all->front().id == newer->id && all->back().id == older->id);
        QCOMPARE(read.rejected.size(), std::size_t(1));
        QCOMPARE(read.rejected[0].file, stored.rejected[0].file);
        QCOMPARE(read.rejected[0].reason, stored.rejected[0].reason);
        QCOMPARE(read.verdict, stored.verdict);
    }

    void registrationsRoundTrip()
    {
        const RecordId camera = m_project->cameras().add({0, "A", ""})->id;
        const RecordId layout = m_project->layouts().add(m_source.layout("hall"))->id;
        const RecordId lens = m_project->cameras().addIntrinsics(m_source.calibration(camera))->id;
        const auto assumed = m_project->cameras().addRegistration(m_source.registration(camera, layout, 0));
        const auto stored = m_project->cameras().addRegistration(m_source.registration(camera, layout, lens));
        QVERIFY(assumed && stored);
        reopen();
        QCOMPARE(m_project->cameras().registration(assumed->id)->intrinsics, RecordId(0));
        const auto current = m_project->cameras().currentRegistration(camera);
        QVERIFY(current && *current);
        const RegistrationRecord &read = **current;
        QCOMPARE(read.id, stored->id);
        QCOMPARE(read.camera, camera);
        QCOMPARE(read.layout, layout);
        QCOMPARE(read.intrinsics, lens);
        QVERIFY(read.made == stored->made);
        QVERIFY(sameLens(read.assumedIntrinsics, stored->assumedIntrinsics));
        QCOMPARE(read.pixels.size(), stored->pixels.size());
        for (std::size_t i = 0; i < read.pixels.size(); ++i) {
            QCOMPARE(read.pixels[i].label, stored->pixels[i].label);
            QVERIFY(sameMatrix(read.pixels[i].pixel, stored->pixels[i].pixel));
        }
        const FloorRegistration &a = read.registration, &b = stored->registration;
        QVERIFY(sameMatrix(a.worldFromCamera.rotation.coeffs(), b.worldFromCamera.rotation.coeffs()));
        QVERIFY(sameMatrix(a.worldFromCamera.translation, b.worldFromCamera.translation));
        QVERIFY(sameMatrix(a.poseCovariance, b.poseCovariance));
        QVERIFY(same(a.rmsPx, b.rmsPx) && same(a.rmsM, b.rmsM));
        QCOMPARE(a.verdict, b.verdict);
        QCOMPARE(a.markers.size(), b.markers.size());
        for (std::size_t i = 0; i < a.markers.size(); ++i) {
            QCOMPARE(a.markers[i].label, b.markers[i].label);
            QVERIFY(same(a.markers[i].errorM, b.markers[i].errorM) &&
                    same(a.markers[i].errorPx, b.markers[i].errorPx));
        }
    }

    void layoutsRoundTrip()
    {
        const MarkerLayout wanted = m_source.layout("hall");
        const auto stored = m_project->layouts().add(wanted);
        QVERIFY(stored.has_value());
        reopen();
        const auto read = m_project->layouts().find("hall");
        QVERIFY(read.has_value());
        QCOMPARE(m_project->layouts().all()->size(), std::size_t(1));
        QCOMPARE(m_project->layouts().get(stored->id)->layout.markers.size(), wanted.markers.size());
        for (std::size_t i = 0; i < wanted.markers.size(); ++i) {
            QCOMPARE(read->layout.markers[i].label, wanted.markers[i].label);
            QVERIFY(sameMatrix(read->layout.markers[i].pointInWorld, wanted.markers[i].pointInWorld));
        }
        MarkerLayout doubled = wanted;
        doubled.name = "doubled";
        doubled.markers.push_back(doubled.markers.front());
        const auto refused = m_project->layouts().add(doubled);
        QVERIFY(!refused);
        QCOMPARE(refused.error().message(),
                 std::string(
                     "layout 'doubled': the label 'O' is there twice; give each marker a label of its own"));
        QVERIFY(!m_project->layouts().find("doubled").has_value());
    }

    void robotsRoundTrip()
    {
        using Height = RobotRecord::Height;
        const RobotRecord wanted[] = {{0, "red", {1, 2, 255}, Height::Told, m_source.positive(), 0.26, 0.19, DrawingColour::SkyBlue},
                                      {0, "blau", {0, 0, 0}, Height::Automatic, {}, {}, {}},
                                      {0, "機器人", {9, 9, 9}, Height::Free, {}, 0.3, {}}};
        for (const RobotRecord &robot : wanted)
            QVERIFY(m_project->robots().add(robot).has_value());
        reopen();
        const auto all = m_project->robots().all();
        QVERIFY(all.has_value());
        QCOMPARE(all->size(), std::size(wanted));
        for (const RobotRecord &robot : wanted) {
            const auto read = m_project->robots().find(robot.name);
            QVERIFY(read.has_value());
            QCOMPARE(m_project->robots().get(read->id)->name, robot.name);
            QVERIFY(read->colour == robot.colour);
            QVERIFY(read->heightMode == robot.heightMode);
            QVERIFY(read->heightM == robot.heightM && read->lengthM == robot.lengthM &&
                    read->widthM == robot.widthM);
            QVERIFY(read->drawingColour == robot.drawingColour);
        }
        const auto unknown = m_project->robots().find("x");
        QCOMPARE(unknown.error().code, ErrorCode::NotFound);
        QCOMPARE(
            unknown.error().message(),
            std::string("robot 'x': there is no such robot in the project; it has 'red', 'blau', '機器人'"));
        QCOMPARE(m_project->robots().add(wanted[0]).error().code, ErrorCode::AlreadyExists);
    }

    void teamsRoundTrip()
    {
        QVERIFY(m_project->teams().add({0, "Dynamo", "8b"}).has_value());
        QVERIFY(m_project->teams().add({0, "Alone", ""}).has_value());
        reopen();
        QCOMPARE(m_project->teams().find("Dynamo")->className, std::string("8b"));
        QCOMPARE(m_project->teams().find("Alone")->className, std::string());
        QCOMPARE(m_project->teams().all()->size(), std::size_t(2));
    }

    void teamsHaveMembersAndRobots()
    {
        const RecordId red = m_project->robots().add(robotNamed("red"))->id, blue = m_project->robots().add(robotNamed("blue"))->id;
        QVERIFY(m_project->teams().add({0, "Dynamo", "8b", "", {"Zoë", "Anna", "Ben"}, {blue, red}}).has_value());
        QVERIFY(m_project->teams().add({0, "Other", "8b", "", {"Anna"}, {red}}).has_value());
        reopen();
        TeamRecord team = *m_project->teams().find("Dynamo");
        QCOMPARE(team.members, (std::vector<std::string>{"Zoë", "Anna", "Ben"}));
        QCOMPARE(team.robots, (std::vector<RecordId>{blue, red}));
        QCOMPARE(m_project->teams().all()->at(1).members, std::vector<std::string>{"Anna"});
        team.members = {"Ben"};
        QVERIFY(m_project->teams().set(team));
        QCOMPARE(m_project->teams().find("Dynamo")->members, std::vector<std::string>{"Ben"});
        QCOMPARE(m_project->teams().find("Other")->members, std::vector<std::string>{"Anna"});
        team.members = {"Ben", "two\nlines"};
        QCOMPARE(m_project->teams().set(team).error().message(),
                 std::string("name of a member: it holds a line break or another control character; use a name of one line"));
        team.members = {};
        team.robots = {red, red};
        QCOMPARE(m_project->teams().set(team).error().message(),
                 std::string("team 'Dynamo': a robot belongs to it twice; name each of its robots once"));
        team.robots = {999};
        QCOMPARE(m_project->teams().set(team).error().code, ErrorCode::NotFound);
        // What is refused leaves it as it was, and a robot or a team that goes takes only its own rows along.
        QCOMPARE(m_project->teams().find("Dynamo")->robots, (std::vector<RecordId>{blue, red}));
        QVERIFY(m_project->robots().remove(red));
        QCOMPARE(m_project->teams().find("Dynamo")->robots, std::vector<RecordId>{blue});
        QVERIFY(m_project->teams().find("Other")->robots.empty());
        QVERIFY(m_project->teams().remove(m_project->teams().find("Other")->id));
        QCOMPARE(m_project->teams().find("Dynamo")->members, std::vector<std::string>{"Ben"});
    }

    void trialsRoundTrip()
    {
        const RecordId camera = m_project->cameras().add({0, "A", ""})->id;
        const RecordId red = m_project->robots().add(robotNamed("red"))->id;
        const RecordId blue = m_project->robots().add(robotNamed("blue"))->id;
        TrialRecord wanted;
        wanted.name = "Lauf „1“";
        wanted.team = m_project->teams().add({0, "Dynamo", "8b"})->id;
        wanted.task = "figure eight";
        wanted.date = m_source.instant();
        wanted.notes = "two\nlines\tand a tab";
        wanted.syncMethod = "auto";
        wanted.syncOffsetS = m_source.number();
        wanted.syncOffsetSigmaS = m_source.number();
        wanted.syncScore = m_source.number();
        wanted.robots = {blue, red};
        wanted.durationS = m_source.number();
        const std::vector<RecordingRecord> recordings = {m_source.recording(camera, 20000),
                                                         m_source.recording(camera, 0)};
        const auto stored = m_project->trials().add(wanted, recordings);
        QVERIFY2(stored.has_value(), stored ? "" : stored.error().message().c_str());
        reopen();
        const auto read = m_project->trials().find("Lauf „1“");
        QVERIFY(read.has_value());
        QCOMPARE(read->id, stored->id);
        QCOMPARE(read->team, wanted.team);
        QCOMPARE(read->teamName, std::string("Dynamo"));
        QCOMPARE(read->className, std::string("8b"));
        QCOMPARE(read->task, wanted.task);
        QVERIFY(read->date == wanted.date);
        QCOMPARE(read->notes, wanted.notes);
        QCOMPARE(read->syncMethod, wanted.syncMethod);
        QVERIFY(same(read->syncOffsetS, wanted.syncOffsetS) && same(read->syncScore, wanted.syncScore));
        QVERIFY(same(read->syncOffsetSigmaS, wanted.syncOffsetSigmaS) &&
                same(read->durationS, wanted.durationS));
        QVERIFY(read->robots == wanted.robots);
        QVERIFY((read->robotNames == std::vector<std::string>{"blue", "red"}));
        QCOMPARE(read->viewCount, 2);
        const auto views = m_project->trials().recordings(stored->id);
        QCOMPARE(views->size(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i) {
            const RecordingRecord &a = (*views)[i], &b = recordings[i];
            QCOMPARE(a.position, int(i));
            QCOMPARE(a.cameraName, std::string("A"));
            QVERIFY(a.path == b.path && a.sha256 == b.sha256 && a.bytes == b.bytes && a.widthPx == b.widthPx);
            QVERIFY(a.heightPx == b.heightPx && same(a.framesPerSecond, b.framesPerSecond));
            QVERIFY(same(a.startOffsetS, b.startOffsetS) && same(a.clockRate, b.clockRate));
            QVERIFY(a.syncMethod == b.syncMethod && same(a.startOffsetSigmaS, b.startOffsetSigmaS));
            QVERIFY(a.frameTimes == b.frameTimes);
        }
    }

    void tasksRoundTrip()
    {
        const Task wanted = m_source.task();
        const auto stored = m_project->tasks().add({0, "Übung 1", wanted});
        QVERIFY2(stored.has_value(), stored ? "" : stored.error().message().c_str());
        QVERIFY(m_project->tasks().add({0, "empty", {}}).has_value());
        reopen();
        QCOMPARE(m_project->tasks().all()->size(), std::size_t(2));
        const Task read = m_project->tasks().find("Übung 1")->task;
        QVERIFY(read.kind == wanted.kind && read.path.closed && read.limits.maxSpeedMps == wanted.limits.maxSpeedMps);
        QVERIFY(read.limits.maxAccelMps2 == wanted.limits.maxAccelMps2);
        QVERIFY(read.path.points == wanted.path.points && read.gates.size() == wanted.gates.size());
        for (std::size_t i = 0; i < wanted.gates.size(); ++i) {
            const Gate &a = read.gates[i], &b = wanted.gates[i];
            QVERIFY(a.name == b.name && a.role == b.role && sameMatrix(a.from, b.from) && sameMatrix(a.to, b.to));
        }
        QCOMPARE(read.zones.size(), wanted.zones.size());
        for (std::size_t i = 0; i < wanted.zones.size(); ++i)
            QVERIFY(read.zones[i].name == wanted.zones[i].name && read.zones[i].rule == wanted.zones[i].rule &&
                    read.zones[i].corners == wanted.zones[i].corners);
        const Task empty = m_project->tasks().get(m_project->tasks().find("empty")->id)->task;
        QVERIFY(empty.gates.empty() && empty.path.points.empty() && !empty.limits.maxAccelMps2);
        QCOMPARE(m_project->tasks().add({0, "empty", {}}).error().code, ErrorCode::AlreadyExists);
        const auto missing = m_project->tasks().find("x");
        QCOMPARE(missing.error().message(),
                 std::string("task 'x': there is no such task in the project; it has 'Übung 1', 'empty'"));
    }

    void aTaskThatCannotBeMeasuredIsRefusedWhole()
    {
        Task task = m_source.task();
        task.gates[2].name = "half";
        QCOMPARE(m_project->tasks().add({0, "t", task}).error().message(),
                 std::string("gate 'half': the name is there twice; give each gate a name of its own"));
        task = m_source.task();
        task.zones[0].corners.pop_back();
        task.zones[0].corners.pop_back();
        QCOMPARE(m_project->tasks().add({0, "t", task}).error().message(),
                 std::string("zone 'поле': it has less than three corners; give the corners of its outline, all the way round"));
        task = m_source.task();
        task.gates[1].name = "a\nb";
        QCOMPARE(m_project->tasks().add({0, "t", task}).error().code, ErrorCode::InvalidInput);
        QVERIFY(m_project->tasks().all()->empty());
    }

    void aTrialIsGivenAnotherTask()
    {
        TrialRecord trial;
        trial.name = "run";
        trial.task = "not described yet"; // a name alone is a task too
        const auto stored = m_project->trials().add(trial, {});
        QVERIFY(stored.has_value());
        QCOMPARE(stored->task, trial.task);
        QVERIFY(m_project->tasks().add({0, "line", m_source.task()}).has_value());
        QVERIFY(m_project->trials().setTask(stored->id, "line").has_value());
        QCOMPARE(m_project->trials().get(stored->id)->task, std::string("line"));
        QVERIFY(m_project->trials().setTask(stored->id, "").has_value());
        QVERIFY(m_project->trials().get(stored->id)->task.empty());
        QCOMPARE(m_project->trials().setTask(999, "line").error().code, ErrorCode::NotFound);
    }

    void trialsAreListedNewestFirstAndCanBeChanged()
    {
        const RecordId robot = m_project->robots().add(robotNamed("red"))->id;
        const RecordId camera = m_project->cameras().add({0, "A", ""})->id;
        for (int i : {2, 1, 3}) {
            TrialRecord trial;
            trial.name = std::to_string(i);
            trial.date = Instant(std::chrono::milliseconds(i));
            QVERIFY(m_project->trials().add(trial,
                                            {m_source.recording(camera, 1), m_source.recording(camera, 1)}));
        }
        const auto all = m_project->trials().all();
        QCOMPARE(all->front().name, std::string("3"));
        QCOMPARE(all->back().name, std::string("1"));
        TrialRecord trial = all->front();
        QVERIFY(m_project->trials().setNotes(trial.id, "wet floor"));
        QVERIFY(m_project->trials().setRobots(trial.id, {robot}));
        trial.syncMethod = "told";
        trial.syncOffsetS = 0.25;
        trial.syncOffsetSigmaS = 0.01;
        trial.syncRate = 2e-4;
        trial.syncRateSigma = 3e-6;
        QVERIFY(m_project->trials().setSync(trial));
        const auto changed = m_project->trials().get(trial.id);
        QCOMPARE(changed->notes, std::string("wet floor"));
        QVERIFY(changed->robots == std::vector<RecordId>{robot});
        QCOMPARE(changed->syncMethod, std::string("told"));
        QCOMPARE(changed->syncRate, 2e-4);
        QCOMPARE(changed->syncRateSigma, 3e-6);
        QCOMPARE(m_project->trials().recordings(trial.id)->at(1).startOffsetS, 0.25);
        QCOMPARE(m_project->trials().recordings(trial.id)->at(1).clockRate, 2e-4);
        QCOMPARE(m_project->trials().recordings(trial.id)->at(1).syncMethod, std::string("told"));
        QCOMPARE(m_project->trials().recordings(trial.id)->at(1).startOffsetSigmaS, 0.01);
        QCOMPARE(m_project->trials().setNotes(999, "").error().code, ErrorCode::NotFound);
    }

    void observationsRoundTripAndTheNewestSeriesIsCurrent()
    {
        const auto filled = fill(*m_project, m_source);
        QVERIFY2(filled.has_value(), filled ? "" : filled.error().message().c_str());
        ObservationSeries wanted{filled->recordings[0], filled->robot, "colour 2", {}};
        for (int i = 0; i < 20000; ++i) // more than two chunks
            wanted.observations.push_back(m_source.observation(i));
        QVERIFY(m_project->trials().addObservations(wanted).has_value());
        reopen();
        const auto read = m_project->trials().currentObservations(wanted.recording, wanted.robot);
        QVERIFY(read && *read);
        QCOMPARE((*read)->algorithm, wanted.algorithm);
        QCOMPARE((*read)->observations.size(), wanted.observations.size());
        for (std::size_t i = 0; i < wanted.observations.size(); ++i)
            QVERIFY(sameObservation((*read)->observations[i], wanted.observations[i]));
        QVERIFY(!m_project->trials().currentObservations(wanted.recording, 999)->has_value());
        const auto refused = m_project->trials().addObservations({999, 999, "", {}});
        QCOMPARE(refused.error().code, ErrorCode::InvalidInput);
    }

    void analysesRoundTrip()
    {
        const auto filled = fill(*m_project, m_source);
        QVERIFY(filled.has_value());
        AnalysisRecord wanted = m_source.analysis(filled->trial, filled->robot, 333);
        wanted.registrations = {1, 0};
        wanted.task = m_project->tasks().find("line")->id;
        wanted.options.overrules = {{3, true}, {17, false}};
        wanted.profile.points[3].sigmaXM = std::numeric_limits<double>::infinity();
        wanted.profile.points[4].accelMps2 = -0.0;
        const auto stored = m_project->analyses().add(wanted);
        QVERIFY2(stored.has_value(), stored ? "" : stored.error().message().c_str());
        reopen();
        const auto current = m_project->analyses().current(filled->trial);
        QVERIFY2(current.has_value(), current ? "" : current.error().message().c_str());
        QCOMPARE(current->size(), std::size_t(1));
        const AnalysisRecord &read = current->front();
        QCOMPARE(read.id, stored->id);
        QCOMPARE(read.robotName, std::string("red"));
        QVERIFY(read.trial == wanted.trial && read.robot == wanted.robot && read.made == wanted.made);
        QCOMPARE(read.softwareVersion, wanted.softwareVersion);
        QVERIFY(read.options.smoother == wanted.options.smoother);
        QVERIFY(same(read.options.maxSpeedMps, wanted.options.maxSpeedMps));
        QVERIFY(same(read.options.maxAccelMps2, wanted.options.maxAccelMps2));
        QVERIFY(read.options.longestBridgedGap == wanted.options.longestBridgedGap);
        QVERIFY(read.options.overrules == wanted.options.overrules);
        QVERIFY(read.registrations == wanted.registrations && read.views == wanted.views);
        const Profile &a = read.profile, &b = wanted.profile;
        QVERIFY(same(a.heightM, b.heightM) && a.heightEstimated == b.heightEstimated);
        QVERIFY(same(a.meanViewDisagreementM, b.meanViewDisagreementM));
        QCOMPARE(a.samples.size(), b.samples.size());
        for (std::size_t i = 0; i < b.samples.size(); ++i)
            QVERIFY(sameSample(a.samples[i], b.samples[i]) && samePoint(a.points[i], b.points[i]));
        QCOMPARE(a.spikes.size(), b.spikes.size());
        QVERIFY(a.spikes[0].sampleIndex == b.spikes[0].sampleIndex && a.spikes[0].time == b.spikes[0].time);
        QVERIFY(a.spikes[0].flags == b.spikes[0].flags && a.spikes[0].reason == b.spikes[0].reason);
        compareMetrics(a.metrics, b.metrics);
        QCOMPARE(read.task, wanted.task);
        QCOMPARE(a.passages.size(), b.passages.size());
        for (std::size_t i = 0; i < b.passages.size(); ++i) {
            QVERIFY(a.passages[i].gate == b.passages[i].gate && a.passages[i].role == b.passages[i].role);
            QVERIFY(a.passages[i].time == b.passages[i].time && same(a.passages[i].sigmaS, b.passages[i].sigmaS));
            QVERIFY(same(a.passages[i].commonSigmaS, b.passages[i].commonSigmaS));
        }
        const auto cheap = m_project->analyses().currentMetrics(filled->trial);
        QVERIFY(cheap && cheap->size() == 1 && cheap->front().profile.samples.empty());
        compareMetrics(cheap->front().profile.metrics, b.metrics);
    }

    void analysesThatCannotBeRightAreRefusedWhole()
    {
        const auto filled = fill(*m_project, m_source);
        const auto before = m_project->analyses().current(filled->trial)->front().id;
        AnalysisRecord analysis = m_source.analysis(filled->trial, filled->robot, 5);
        analysis.profile.metrics[1].value = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(m_project->analyses().add(analysis).error().message(),
                 std::string("metric 'duration': it is not a finite number; analyse the trial again"));
        analysis = m_source.analysis(filled->trial, filled->robot, 5);
        analysis.profile.points.pop_back();
        QCOMPARE(m_project->analyses().add(analysis).error().code, ErrorCode::InvalidInput);
        QCOMPARE(m_project->analyses().add(m_source.analysis(999, 1, 5)).error().code,
                 ErrorCode::InvalidInput);
        QCOMPARE(m_project->analyses().current(filled->trial)->front().id, before);
    }

    void overrulesRoundTripAndAreReplaced()
    {
        const auto filled = fill(*m_project, m_source);
        QVERIFY(filled.has_value());
        const auto said = [&] { return m_project->trials().overrules(filled->trial, filled->robot).value(); };
        QVERIFY(said().empty());
        QVERIFY(m_project->trials().setOverrules(filled->trial, filled->robot, {{9, true}, {2, false}}));
        reopen();
        QVERIFY((said() == std::vector<Overrule>{{2, false}, {9, true}}));
        // Two words on one frame: refused, and the old ones stay.
        QVERIFY(!m_project->trials().setOverrules(filled->trial, filled->robot, {{4, true}, {4, false}}));
        QCOMPARE(said().size(), std::size_t(2));
        QVERIFY(m_project->trials().setOverrules(filled->trial, filled->robot, {}));
        QVERIFY(said().empty());
        QVERIFY(!m_project->trials().setOverrules(filled->trial + 99, filled->robot, {{1, true}}));
    }
    void importedTracksRoundTripAndTheNewestIsCurrent()
    {
        const RecordId robot = m_project->robots().add(robotNamed("red"))->id;
        TrialRecord trial; // nothing was recorded of it
        trial.name = "from elsewhere";
        trial.robots = {robot};
        trial.id = m_project->trials().add(trial, {})->id;
        QVERIFY(!m_project->trials().currentImportedTrack(trial.id, robot)->has_value());
        ImportedTrack wanted{trial.id, robot, m_source.instant(), "lauf ß.txt", "00ff", 123, "tum", "metres, σ 5 mm", {}};
        for (int i = 0; i < 77; ++i) {
            Sample sample;
            sample.time = Nanoseconds(i * 10);
            sample.frame = i;
            if (i != 5)
                sample.position = m_source.vector();
            sample.covariance = m_source.covariance();
            sample.flags = i == 5 ? flagBit(SampleFlag::Lost) : 0;
            wanted.samples.push_back(sample);
        }
        QVERIFY(m_project->trials().addImportedTrack(wanted).has_value());
        wanted.format = "csv";
        QVERIFY(m_project->trials().addImportedTrack(wanted).has_value());
        reopen();
        const auto read = m_project->trials().currentImportedTrack(trial.id, robot);
        QVERIFY(read && *read);
        const ImportedTrack &track = **read;
        QVERIFY(track.imported == wanted.imported && track.file == wanted.file && track.sha256 == wanted.sha256);
        QVERIFY(track.bytes == wanted.bytes && track.format == "csv" && track.reading == wanted.reading);
        QVERIFY(std::equal(track.samples.begin(), track.samples.end(), wanted.samples.begin(), wanted.samples.end(), sameSample));
        QCOMPARE(m_project->robots().remove(robot).error().why, std::string("it drove in a trial"));
        QVERIFY(m_project->check(false)->empty());

        std::swap(wanted.samples[3], wanted.samples[4]);
        QCOMPARE(m_project->trials().addImportedTrack(wanted).error().message(),
                 std::string("track 'lauf ß.txt': its times do not rise; import another file"));
        wanted.samples.clear();
        QCOMPARE(m_project->trials().addImportedTrack(wanted).error().why, std::string("it has no samples"));
    }

    void truthRoundTripsAndIsReplaced()
    {
        const auto filled = fill(*m_project, m_source);
        const TruthSeries wanted = m_source.truth(filled->trial, filled->robot, 77);
        QVERIFY(m_project->trials().setTruth(wanted).has_value());
        reopen();
        const auto read = m_project->trials().truth(filled->trial, filled->robot);
        QVERIFY(read && *read);
        QVERIFY((*read)->times == wanted.times);
        for (std::size_t i = 0; i < wanted.times.size(); ++i) {
            QVERIFY(sameMatrix((*read)->positions[i], wanted.positions[i]));
            QVERIFY(sameMatrix((*read)->velocities[i], wanted.velocities[i]));
            QVERIFY(sameMatrix((*read)->accelerations[i], wanted.accelerations[i]));
        }
        QVERIFY(!m_project->trials().truth(filled->trial, 999)->has_value());
        TruthSeries uneven = wanted;
        uneven.velocities.pop_back();
        QCOMPARE(m_project->trials().setTruth(uneven).error().code, ErrorCode::InvalidInput);
    }

    void namesAreChecked_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QString>("why");
        QTest::newRow("empty") << QByteArray("") << QStringLiteral("it is empty");
        QTest::newRow("blank") << QByteArray(" \xc2\xa0 ") << QStringLiteral("it is empty");
        QTest::newRow("line break") << QByteArray("a\nb") << QStringLiteral("control character");
        QTest::newRow("line separator") << QByteArray("a\xe2\x80\xa8") << QStringLiteral("control character");
        QTest::newRow("nul") << QByteArray("a\0b", 3) << QStringLiteral("control character");
        QTest::newRow("too long") << QByteArray(201, 'x') << QStringLiteral("it has 201 characters");
        QTest::newRow("no UTF-8") << QByteArray("a\xff") << QStringLiteral("not valid UTF-8");
    }
    void namesAreChecked()
    {
        QFETCH(QByteArray, name);
        QFETCH(QString, why);
        const std::string bad = name.toStdString();
        TrialRecord trial;
        trial.name = bad;
        const Error errors[] = {
            m_project->cameras().add({0, bad, ""}).error(), m_project->layouts().add({bad, {}}).error(),
            m_project->robots().add(robotNamed(bad)).error(), m_project->teams().add({0, bad, ""}).error(),
            m_project->tasks().add({0, bad, {}}).error(),
            m_project->trials().add(trial, {}).error()};
        for (const Error &error : errors) {
            QCOMPARE(error.code, ErrorCode::InvalidInput);
            QVERIFY2(error.message().find(why.toStdString()) != std::string::npos, error.message().c_str());
        }
    }
    void longAndOddNamesAreKeptAsTheyAre()
    {
        std::string emoji;
        for (int i = 0; i < 200; ++i)
            emoji += "🤖";
        for (const std::string &name :
             {emoji, std::string("<img src=file:///etc/passwd>"), std::string("'; DROP TABLE robot;--"),
              std::string("\xe2\x80\xae"
                          "abc")}) {
            QVERIFY(m_project->robots().add(robotNamed(name)).has_value());
            QCOMPARE(m_project->robots().find(name)->name, name);
        }
    }

private:
    static RobotRecord robotNamed(const std::string &name)
    {
        RobotRecord robot;
        robot.name = name;
        return robot;
    }
    std::filesystem::path file() const
    {
        return std::filesystem::path(m_folder->path().toStdString()) / "Прогон 1.odo";
    }
    void reopen()
    {
        m_project.reset();
        auto opened = Project::open(file(), Project::Access::ReadWrite);
        QVERIFY2(opened.has_value(), opened ? "" : opened.error().message().c_str());
        m_project = std::move(*opened);
    }
    static void compareMetrics(const std::vector<Metric> &a, const std::vector<Metric> &b)
    {
        QCOMPARE(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            QCOMPARE(a[i].name, b[i].name);
            QCOMPARE(a[i].unit, b[i].unit);
            QVERIFY(same(a[i].value, b[i].value) && a[i].sigma == b[i].sigma);
        }
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    RecordSource m_source{7};
};

QTEST_GUILESS_MAIN(TestRepositories)
#include "tst_repositories.moc"
