// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/project/same_records.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

class TestRepositories : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_project = std::make_unique<StoredProject>(); }

    void keepsTheTitle()
    {
        QCOMPARE((*m_project)->title().value(), std::string("Class 8b – été"));
        QVERIFY((*m_project)->setTitle("новый").has_value());
        m_project->reopen();
        QCOMPARE((*m_project)->title().value(), std::string("новый"));
    }

    void camerasRoundTrip()
    {
        const auto a = (*m_project)->cameras().add({0, "Kamera ß", "v4l2:/dev/video0"});
        const auto b = (*m_project)->cameras().add({0, "B", ""});
        QVERIFY((*m_project)->cameras().setDevice(b->id, "aravis:S1?rate=60"));
        QCOMPARE((*m_project)->cameras().find("B")->deviceUri, std::string("aravis:S1?rate=60"));
        QVERIFY((*m_project)->cameras().setDevice(b->id, ""));
        QVERIFY(a && b && a->id != 0 && a->id != b->id);
        m_project->reopen();
        QCOMPARE((*m_project)->cameras().all()->size(), std::size_t(2));
        QCOMPARE((*m_project)->cameras().find("Kamera ß")->deviceUri, std::string("v4l2:/dev/video0"));
        QCOMPARE((*m_project)->cameras().get(b->id)->name, std::string("B"));
        QVERIFY((*m_project)->cameras().get(b->id)->deviceUri.empty());
        QVERIFY(!(*m_project)->cameras().currentIntrinsics(a->id)->has_value());
        QVERIFY(!(*m_project)->cameras().currentRegistration(a->id)->has_value());
    }

    void intrinsicsRoundTripAndTheNewestIsInForce()
    {
        const RecordId camera = (*m_project)->cameras().add({0, "A", ""})->id;
        const auto older = (*m_project)->cameras().addIntrinsics(m_source.calibration(camera));
        IntrinsicsRecord wanted = m_source.calibration(camera);
        wanted.calibration.intrinsics = Intrinsics{640, 480, 1, 2, 3, 4, LensModel::Standard, {}, {}};
        const auto newer = (*m_project)->cameras().addIntrinsics(wanted);
        QVERIFY(older && newer);
        m_project->reopen();
        const auto current = (*m_project)->cameras().currentIntrinsics(camera);
        QVERIFY(current && *current);
        QCOMPARE((*current)->id, newer->id);
        QVERIFY(sameIntrinsics((*current)->calibration.intrinsics, wanted.calibration.intrinsics));
        const auto first = (*m_project)->cameras().intrinsics(older->id);
        QVERIFY(first.has_value());
        QCOMPARE(first->camera, camera);
        QVERIFY(first->made == older->made);
        QCOMPARE(first->origin, older->origin);
        const IntrinsicCalibration &read = first->calibration, &stored = older->calibration;
        QVERIFY(sameIntrinsics(read.intrinsics, stored.intrinsics));
        QVERIFY(same(read.rmsPx, stored.rmsPx) && same(read.crossValidationPx, stored.crossValidationPx));
        QCOMPARE(read.images.size(), stored.images.size());
        for (std::size_t i = 0; i < read.images.size(); ++i) {
            QCOMPARE(read.images[i].view.source, stored.images[i].view.source);
            QVERIFY(same(read.images[i].rmsPx, stored.images[i].rmsPx));
            QCOMPARE(read.images[i].used, i == 0);
            QCOMPARE(read.images[i].view.columns, 9);
            QCOMPARE(read.images[i].view.pattern, BoardPattern::Charuco);
            QVERIFY(read.images[i].view.pixels == stored.images[i].view.pixels);
            QVERIFY(read.images[i].view.pointsOnBoard == stored.images[i].view.pointsOnBoard);
            QVERIFY(read.images[i].residualsPx == stored.images[i].residualsPx);
            QVERIFY(read.images[i].outliers == stored.images[i].outliers);
            QVERIFY(read.images[i].leftOut == stored.images[i].leftOut);
        }
        QCOMPARE(read.modelReason, stored.modelReason);
        QVERIFY(same(read.disagreeingPart, stored.disagreeingPart));
        QCOMPARE(first->softwareVersion, older->softwareVersion);
        QCOMPARE(first->board.rows, 6);
        QCOMPARE(first->board.dictionary, std::string("DICT_6X6_250"));
        QVERIFY(same(first->board.squareM, older->board.squareM) &&
                same(first->board.markerRatio, older->board.markerRatio));
        QCOMPARE(first->files.size(), std::size_t(2));
        QCOMPARE(first->files[0].path, older->files[0].path);
        QCOMPARE(first->files[0].sha256, older->files[0].sha256);
        QCOMPARE(first->files[0].bytes, std::int64_t(12345));
        QVERIFY(first->files[1].path.empty());
        const auto all = (*m_project)->cameras().allIntrinsics(camera);
        QVERIFY(all && all->size() == 2 && all->front().id == newer->id && all->back().id == older->id);
        QCOMPARE(read.rejected.size(), std::size_t(1));
        QCOMPARE(read.rejected[0].file, stored.rejected[0].file);
        QCOMPARE(read.rejected[0].reason, stored.rejected[0].reason);
        QCOMPARE(read.verdict, stored.verdict);
    }

    void registrationsRoundTrip()
    {
        const RecordId camera = (*m_project)->cameras().add({0, "A", ""})->id;
        const RecordId layout = (*m_project)->layouts().add(m_source.layout("hall"))->id;
        const RecordId lens = (*m_project)->cameras().addIntrinsics(m_source.calibration(camera))->id;
        const auto assumed =
            (*m_project)->cameras().addRegistration(m_source.registration(camera, layout, 0));
        const auto stored =
            (*m_project)->cameras().addRegistration(m_source.registration(camera, layout, lens));
        QVERIFY(assumed && stored);
        m_project->reopen();
        QCOMPARE((*m_project)->cameras().registration(assumed->id)->intrinsics, RecordId(0));
        const auto current = (*m_project)->cameras().currentRegistration(camera);
        QVERIFY(current && *current);
        const RegistrationRecord &read = **current;
        QCOMPARE(read.id, stored->id);
        QCOMPARE(read.camera, camera);
        QCOMPARE(read.layout, layout);
        QCOMPARE(read.intrinsics, lens);
        QVERIFY(read.made == stored->made);
        QVERIFY(sameIntrinsics(read.assumedIntrinsics, stored->assumedIntrinsics));
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
        const auto stored = (*m_project)->layouts().add(wanted);
        QVERIFY(stored.has_value());
        m_project->reopen();
        const auto read = (*m_project)->layouts().find("hall");
        QVERIFY(read.has_value());
        QCOMPARE((*m_project)->layouts().all()->size(), std::size_t(1));
        QCOMPARE((*m_project)->layouts().get(stored->id)->layout.markers.size(), wanted.markers.size());
        for (std::size_t i = 0; i < wanted.markers.size(); ++i) {
            QCOMPARE(read->layout.markers[i].label, wanted.markers[i].label);
            QVERIFY(sameMatrix(read->layout.markers[i].pointInWorld, wanted.markers[i].pointInWorld));
        }
        MarkerLayout doubled = wanted;
        doubled.name = "doubled";
        doubled.markers.push_back(doubled.markers.front());
        const auto refused = (*m_project)->layouts().add(doubled);
        QVERIFY(!refused);
        QCOMPARE(refused.error().message(),
                 std::string(
                     "layout 'doubled': the label 'O' appears twice; give each marker a label of its own"));
        QVERIFY(!(*m_project)->layouts().find("doubled").has_value());
    }

    void robotsRoundTrip()
    {
        using Height = RobotRecord::Height;
        const RobotRecord wanted[] = {{0,
                                       "red",
                                       RgbColour{1, 2, 255},
                                       Height::Given,
                                       m_source.positive() / 200,
                                       0.26,
                                       0.19,
                                       DrawingColour::SkyBlue,
                                       {0.02, -0.005}},
                                      {0, "blau", RgbColour{0, 0, 0}, Height::Automatic, {}, {}, {}},
                                      {0, "機器人", RgbColour{9, 9, 9}, Height::Free, {}, 0.3, {}},
                                      {0, "of any look", {}, Height::Automatic, {}, {}, {}}};
        for (const RobotRecord &robot : wanted)
            QVERIFY((*m_project)->robots().add(robot).has_value());
        m_project->reopen();
        const auto all = (*m_project)->robots().all();
        QVERIFY(all.has_value());
        QCOMPARE(all->size(), std::size(wanted));
        for (const RobotRecord &robot : wanted) {
            const auto read = (*m_project)->robots().find(robot.name);
            QVERIFY(read.has_value());
            QCOMPARE((*m_project)->robots().get(read->id)->name, robot.name);
            QVERIFY(read->colour == robot.colour);
            QVERIFY(read->heightMode == robot.heightMode);
            QVERIFY(read->heightM == robot.heightM && read->lengthM == robot.lengthM &&
                    read->widthM == robot.widthM);
            QVERIFY(read->drawingColour == robot.drawingColour);
            QVERIFY(read->referenceM == robot.referenceM);
        }
        const auto unknown = (*m_project)->robots().find("x");
        QCOMPARE(unknown.error().code, ErrorCode::NotFound);
        QCOMPARE(
            unknown.error().message(),
            std::string(
                "robot 'x': the project has no such robot; it has 'red', 'blau', '機器人', 'of any look'"));
        QCOMPARE((*m_project)->robots().add(wanted[0]).error().code, ErrorCode::AlreadyExists);
    }

    void teamsRoundTrip()
    {
        QVERIFY((*m_project)->teams().add({0, "Dynamo", "8b"}).has_value());
        QVERIFY((*m_project)->teams().add({0, "Alone", ""}).has_value());
        m_project->reopen();
        QCOMPARE((*m_project)->teams().find("Dynamo")->className, std::string("8b"));
        QCOMPARE((*m_project)->teams().find("Alone")->className, std::string());
        QCOMPARE((*m_project)->teams().all()->size(), std::size_t(2));
    }

    void teamsHaveMembersAndRobots()
    {
        const RecordId red = (*m_project)->robots().add(robotNamed("red"))->id,
                       blue = (*m_project)->robots().add(robotNamed("blue"))->id;
        QVERIFY((*m_project)
                    ->teams()
                    .add({0, "Dynamo", "8b", "", {"Zoë", "Anna", "Ben"}, {blue, red}})
                    .has_value());
        QVERIFY((*m_project)->teams().add({0, "Other", "8b", "", {"Anna"}, {red}}).has_value());
        m_project->reopen();
        TeamRecord team = *(*m_project)->teams().find("Dynamo");
        QCOMPARE(team.members, (std::vector<std::string>{"Zoë", "Anna", "Ben"}));
        QCOMPARE(team.robots, (std::vector<RecordId>{blue, red}));
        QCOMPARE((*m_project)->teams().all()->at(1).members, std::vector<std::string>{"Anna"});
        team.members = {"Ben"};
        QVERIFY((*m_project)->teams().set(team));
        QCOMPARE((*m_project)->teams().find("Dynamo")->members, std::vector<std::string>{"Ben"});
        QCOMPARE((*m_project)->teams().find("Other")->members, std::vector<std::string>{"Anna"});
        team.members = {"Ben", "two\nlines"};
        QCOMPARE((*m_project)->teams().set(team).error().message(),
                 std::string("name of a member: it holds a line break or another control character; use a "
                             "name of one line"));
        team.members = {};
        team.robots = {red, red};
        QCOMPARE((*m_project)->teams().set(team).error().message(),
                 std::string("team 'Dynamo': it has a robot twice; list each of its robots once"));
        team.robots = {999};
        QCOMPARE((*m_project)->teams().set(team).error().code, ErrorCode::NotFound);
        // What is refused leaves it as it was, and a robot or a team that goes takes only its own rows along.
        QCOMPARE((*m_project)->teams().find("Dynamo")->robots, (std::vector<RecordId>{blue, red}));
        QVERIFY((*m_project)->robots().remove(red));
        QCOMPARE((*m_project)->teams().find("Dynamo")->robots, std::vector<RecordId>{blue});
        QVERIFY((*m_project)->teams().find("Other")->robots.empty());
        QVERIFY((*m_project)->teams().remove((*m_project)->teams().find("Other")->id));
        QCOMPARE((*m_project)->teams().find("Dynamo")->members, std::vector<std::string>{"Ben"});
    }

    void importedTracksRoundTripAndTheNewestIsCurrent()
    {
        const RecordId robot = (*m_project)->robots().add(robotNamed("red"))->id;
        TrialRecord trial; // nothing was recorded of it
        trial.name = "from elsewhere";
        trial.robots = {robot};
        trial.durationS = 760e-9;
        trial.id = (*m_project)->trials().add(trial, {})->id;
        QVERIFY(!(*m_project)->trials().currentImportedTrack(trial.id, robot)->has_value());
        ImportedTrack wanted{trial.id,
                             robot,
                             m_source.instant(),
                             "lauf ß.txt",
                             "00ff",
                             123,
                             "tum",
                             foreignWords("metres, σ 5 mm"),
                             {}};
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
        QVERIFY((*m_project)->trials().addImportedTrack(wanted).has_value());
        wanted.format = "csv";
        QVERIFY((*m_project)->trials().addImportedTrack(wanted).has_value());
        m_project->reopen();
        const auto read = (*m_project)->trials().currentImportedTrack(trial.id, robot);
        QVERIFY(read && *read);
        const ImportedTrack &track = **read;
        QVERIFY(track.imported == wanted.imported && track.file == wanted.file &&
                track.sha256 == wanted.sha256);
        QVERIFY(track.bytes == wanted.bytes && track.format == "csv" && track.reading == wanted.reading);
        QVERIFY(std::equal(track.samples.begin(), track.samples.end(), wanted.samples.begin(),
                           wanted.samples.end(), sameSample));
        QCOMPARE((*m_project)->robots().remove(robot).error().why.english(), std::string("a trial uses it"));
        QVERIFY((*m_project)->check(false)->empty());

        std::swap(wanted.samples[3], wanted.samples[4]);
        QCOMPARE((*m_project)->trials().addImportedTrack(wanted).error().message(),
                 std::string("track 'lauf ß.txt': its times do not increase; import another file"));
        wanted.samples.clear();
        QCOMPARE((*m_project)->trials().addImportedTrack(wanted).error().why.english(),
                 std::string("it has no samples"));
    }

    void namesAreChecked_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QString>("why");
        QTest::newRow("empty") << QByteArray("") << QStringLiteral("it is empty");
        QTest::newRow("blank") << QByteArray(" \xc2\xa0 ") << QStringLiteral("it is empty");
        QTest::newRow("line break") << QByteArray("a\nb") << QStringLiteral("control character");
        QTest::newRow("line separator") << QByteArray("a\xe2\x80\xa8"
                                                      "b")
                                        << QStringLiteral("control character");
        QTest::newRow("nul") << QByteArray("a\0b", 3) << QStringLiteral("control character");
        QTest::newRow("of no width") << QByteArray("\xe2\x80\x8b")
                                     << QStringLiteral("it holds an invisible character, U+200B");
        QTest::newRow("soft hyphen") << QByteArray("Fal\xc2\xad"
                                                   "con")
                                     << QStringLiteral("it holds an invisible character, U+00AD");
        QTest::newRow("order turned around") << QByteArray("\xe2\x80\xae"
                                                           "abc")
                                             << QStringLiteral("it holds an invisible character, U+202E");
        QTest::newRow("only joiners")
            << QByteArray("\xe2\x80\x8d\xe2\x80\x8c") << QStringLiteral("it is empty");
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
        const Error errors[] = {(*m_project)->cameras().add({0, bad, ""}).error(),
                                (*m_project)->layouts().add({bad, {}}).error(),
                                (*m_project)->robots().add(robotNamed(bad)).error(),
                                (*m_project)->teams().add({0, bad, ""}).error(),
                                (*m_project)->tasks().add({0, bad, {}}).error(),
                                (*m_project)->trials().add(trial, {}).error()};
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
              std::string("می‌خواهم"), std::string("👩‍🚀")}) {
            QVERIFY((*m_project)->robots().add(robotNamed(name)).has_value());
            QCOMPARE((*m_project)->robots().find(name)->name, name);
        }
    }

private:
    std::unique_ptr<StoredProject> m_project;
    RecordSource m_source{7};
};

ODOGRAPH_TEST(TestRepositories, QCoreApplication)
#include "tst_repositories.moc"
