// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/project/sample_records.h"

namespace odo {

Eigen::Matrix2d RecordSource::covariance()
{
    const double shared = number();
    return (Eigen::Matrix2d() << positive(), shared, shared, positive()).finished();
}

Intrinsics RecordSource::intrinsics(LensModel model)
{
    Intrinsics lens;
    lens.widthPx = 1280;
    lens.heightPx = 721;
    lens.fxPx = positive();
    lens.fyPx = positive();
    lens.cxPx = number();
    lens.cyPx = number();
    lens.model = model;
    const int count = model == LensModel::Rational ? 8 : model == LensModel::Fisheye ? 4 : 5;
    for (int i = 0; i < count; ++i)
        lens.distortion.push_back(number());
    lens.covariance = Eigen::MatrixXd::NullaryExpr(4 + count, 4 + count, [this] { return number(); });
    return lens;
}

IntrinsicsRecord RecordSource::calibration(RecordId camera)
{
    IntrinsicsRecord record;
    record.camera = camera;
    record.made = instant();
    record.origin = foreignWords("imported from Kamera–ß.yaml");
    record.calibration.intrinsics = intrinsics(LensModel::Rational);
    record.calibration.rmsPx = positive();
    for (const char *file : {"bild 1.jpg", "картина.png"}) {
        record.calibration.images.emplace_back();
        record.calibration.images.back().view.source = file;
        record.calibration.images.back().rmsPx = positive();
        record.calibration.images.back().view.pixels = {vector(), vector(), vector()};
        record.calibration.images.back().view.pointsOnBoard = {vector(), vector(), vector()};
        record.calibration.images.back().residualsPx = {vector(), vector(), vector()};
    }
    record.calibration.images[0].outliers = {0, 2};
    record.calibration.images[0].leftOut = {2};
    record.calibration.images[1].used = false;
    record.calibration.modelReason = foreignWords("told");
    record.calibration.disagreeingPart = positive();
    record.board = {BoardPattern::Charuco, 9, 6, positive(), positive(), "DICT_6X6_250"};
    record.softwareVersion = "0.1.0";
    record.files = {{"run.media/calibration/A_1.png", "00ff", 12345}, {}};
    record.calibration.rejected = {{"c.jpg", foreignWords("no board found")}};
    record.calibration.crossValidationPx = positive();
    record.calibration.verdict = foreignWords("good");
    return record;
}

RegistrationRecord RecordSource::registration(RecordId camera, RecordId layout, RecordId intrinsics)
{
    RegistrationRecord record;
    record.camera = camera;
    record.layout = layout;
    record.intrinsics = intrinsics;
    record.made = instant();
    record.assumedIntrinsics = this->intrinsics(LensModel::Fisheye);
    record.pixels = {{"O", vector()}, {"U", vector()}, {"Ü", vector()}};
    FloorRegistration &registration = record.registration;
    registration.worldFromCamera.rotation = {number(), number(), number(), number()};
    registration.worldFromCamera.translation = {number(), number(), number()};
    registration.poseCovariance = Eigen::Matrix<double, 6, 6>::NullaryExpr([this] { return number(); });
    registration.markers = {{"O", positive(), positive()}, {"U", positive(), positive()}};
    const MarkerError &o = registration.markers[0], &u = registration.markers[1];
    registration.rmsPx = std::hypot(o.errorPx, u.errorPx) / std::sqrt(2.0);
    registration.rmsM = std::hypot(o.errorM, u.errorM) / std::sqrt(2.0);
    registration.verdict = foreignWords("typical error 1.8 mm");
    return record;
}

MarkerLayout RecordSource::layout(const std::string &name)
{
    return {name, {{"O", vector()}, {"U", vector()}, {"V", vector()}, {"D ✓", vector()}}};
}

Task RecordSource::task()
{
    Task task;
    task.kind = TaskTemplate::Slalom;
    task.gates = {{"départ", GateRole::Start, vector(), vector()},
                  {"half", GateRole::Split, vector(), vector()},
                  {"финиш", GateRole::Finish, vector(), vector()}};
    task.path = {{vector(), vector(), vector(), vector()}, true};
    task.limits = {positive(), positive()};
    const Eigen::Vector2d corner = vector();
    task.zones = {
        {"поле",
         ZoneRule::StayInside,
         {corner, corner + Eigen::Vector2d(2, 0), corner + Eigen::Vector2d(0.1, 3)}},
        rectangularZone("Wand", ZoneRule::StayOutside, corner, corner + Eigen::Vector2d(-0.1, -0.7))};
    return task;
}

RecordingRecord RecordSource::recording(RecordId camera, std::size_t frames)
{
    RecordingRecord record;
    record.camera = camera;
    record.path = "run.media/трасса 1.mkv";
    record.sha256 = "00ff";
    record.bytes = integer();
    record.widthPx = 1088;
    record.heightPx = 1920;
    record.framesPerSecond = positive();
    record.startOffsetS = number();
    record.clockRate = number();
    record.syncMethod = "flash";
    record.startOffsetSigmaS = positive();
    for (std::size_t i = 0; i < frames; ++i)
        record.frameTimes.emplace_back(integer());
    return record;
}

Observation RecordSource::observation(std::int64_t frame)
{
    Observation observation;
    observation.frame = frame;
    observation.time = Nanoseconds(integer());
    observation.found = frame % 2 == 0;
    observation.duplicateFrame = frame % 3 == 0;
    observation.touchesBorder = frame % 5 == 0;
    observation.ellipse = {vector(), positive(), positive(), number()};
    observation.centreCovariancePx2 = covariance();
    observation.areaPx = positive();
    observation.score = positive();
    return observation;
}

AnalysisRecord RecordSource::analysis(RecordId trial, RecordId robot, std::size_t samples)
{
    AnalysisRecord record;
    record.trial = trial;
    record.robot = robot;
    record.made = instant();
    record.softwareVersion = "0.1.0";
    record.options = {Smoother::SavGol, positive(), positive(), Nanoseconds(integer())};
    record.views = {"A", "Б"};
    record.registrations = {0, 0};
    Profile &profile = record.profile;
    for (std::size_t i = 0; i < samples; ++i) {
        Sample sample;
        sample.time = Nanoseconds(integer());
        sample.frame = integer();
        if (i % 3 != 0)
            sample.position = vector();
        sample.covariance = covariance();
        sample.commonCovariance = covariance();
        sample.views = 0x80000001u;
        if (i % 4 != 0)
            sample.viewDisagreementM = number();
        sample.flags = static_cast<SampleFlags>(i);
        if (i % 5 == 1)
            sample.heading = MeasuredHeading{positive(), positive(), positive()};
        profile.samples.push_back(sample);
        profile.points.push_back({vector(), vector(), vector(), positive(), positive(), positive(),
                                  positive(), positive(), positive(), i % 2 == 0});
        if (i % 5 == 2)
            profile.points.back().body = BodyHeading{positive(), positive(), positive(), positive()};
    }
    if (samples > 0)
        profile.spikes = {{0, Nanoseconds(integer()), 0x80000003u, foreignWords("views disagree by 84 mm")}};
    profile.metrics = {{"max_speed", "m/s", number(), positive()}, {"duration", "s", number(), std::nullopt}};
    profile.passages = {{"départ", GateRole::Start, Nanoseconds(integer()), positive(), positive()},
                        {"финиш", GateRole::Finish, Nanoseconds(integer()), positive(), 0}};
    profile.heightM = positive();
    profile.heightEstimated = true;
    profile.meanViewDisagreementM = positive();
    record.ambiguousNames = {{Nanoseconds(5), Nanoseconds(9), {robot}, {}},
                             {Nanoseconds(20), Nanoseconds(20), {}, {}}};
    return record;
}

TruthSeries RecordSource::truth(RecordId trial, RecordId robot, std::size_t rows)
{
    TruthSeries truth;
    truth.trial = trial;
    truth.robot = robot;
    for (std::size_t i = 0; i < rows; ++i) {
        truth.times.emplace_back(integer());
        truth.positions.push_back(vector());
        truth.velocities.push_back(vector());
        truth.accelerations.push_back(vector());
    }
    return truth;
}

void describe(TrialRecord &trial, const std::vector<RecordingRecord> &views)
{
    const RecordingRecord &second = views.at(1);
    trial.durationS = toSeconds(views.front().frameTimes.back());
    trial.syncMethod = second.syncMethod;
    trial.syncOffsetS = second.startOffsetS;
    trial.syncOffsetSigmaS = second.startOffsetSigmaS;
    trial.syncRate = second.clockRate;
}

Result<FilledProject> fill(Project &project, RecordSource &source)
{
    FilledProject filled;
    const auto store = [&]() -> Result<void> {
        const auto a = project.cameras().add({0, "A", "v4l2:/dev/video0"});
        const auto b = project.cameras().add({0, "Б", ""});
        const auto layout = project.layouts().add(source.layout("hall"));
        const auto robot = project.robots().add(
            {0, "red", RgbColour{0xd7, 0x23, 0x28}, RobotRecord::Height::Given, 0.06, {}, {}});
        const auto team = project.teams().add({0, "Los Niños", "8b"});
        const auto task = project.tasks().add({0, "line", source.task()});
        const auto intrinsics = project.cameras().addIntrinsics(source.calibration(a->id));
        if (!project.cameras().addRegistration(source.registration(a->id, layout->id, intrinsics->id)))
            return fail(ErrorCode::Internal, foreignWords("sample project"), foreignWords("no registration"),
                        {});
        TrialRecord trial;
        trial.name = "run 1";
        trial.team = team->id;
        trial.task = "line";
        trial.robots = {robot->id};
        const std::vector<RecordingRecord> views{source.recording(a->id, 50), source.recording(b->id, 50)};
        describe(trial, views);
        const auto stored = project.trials().add(trial, views);
        if (!stored)
            return tl::unexpected(stored.error());
        filled.trial = stored->id;
        filled.robot = robot->id;
        const auto recordings = project.trials().recordings(stored->id);
        for (const RecordingRecord &recording : *recordings) {
            filled.recordings.push_back(recording.id);
            ObservationSeries series{recording.id, robot->id, "colour 1", {}};
            for (int i = 0; i < 50; ++i)
                series.observations.push_back(source.observation(i));
            if (auto added = project.trials().addObservations(series); !added)
                return added;
        }
        AnalysisRecord analysis = source.analysis(stored->id, robot->id, 50);
        analysis.task = task->id;
        if (auto added = project.analyses().add(analysis); !added)
            return tl::unexpected(added.error());
        return project.trials().setTruth(source.truth(stored->id, robot->id, 50));
    };
    if (auto stored = project.inTransaction(store); !stored)
        return tl::unexpected(stored.error());
    return filled;
}

} // namespace odo
