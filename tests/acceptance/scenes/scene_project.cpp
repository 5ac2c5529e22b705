// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/scene_project.h"

#include "tests/acceptance/scenes/drawn_testbed.h"
#include "tests/acceptance/scenes/seeded_draw.h"
#include "tests/support/program.h"

#include <QElapsedTimer>
#include <QFile>

namespace odo::test {

namespace {

namespace fs = std::filesystem;

QString q(const std::string &text)
{
    return QString::fromStdString(text);
}

QString q(const fs::path &path)
{
    return QString::fromStdString(path.string());
}

class ProjectMaker
{
public:
    ProjectMaker(const AccuracyScene &scene, const SceneMedia &media, const MeasureSettings &settings)
        : m_media(media), m_settings(settings),
          m_project(q(settings.folder / "scene.odo")), m_out{scene, {}, {}, 0, {}}
    {
    }

    MeasuredScene measure()
    {
        fs::create_directories(m_settings.folder);
        fs::remove(m_settings.folder / "scene.odo");
        fs::remove_all(m_settings.folder / "scene.media");
        QElapsedTimer clock;
        clock.start();
        const bool done = call({s("new"), m_project}) && addCameras() && addRobots() && import() &&
                          call({s("track"), m_project, s("run"), s("--json")}, "track.json") &&
                          exportTracks();
        m_out.wallS = double(clock.elapsed()) / 1000;
        if (done)
            call({s("show"), m_project, s("run"), s("--json")}, "show.json");
        fs::remove_all(m_settings.folder / "scene.media");
        return m_out;
    }

private:
    static QString s(const char *text) { return QString::fromLatin1(text); }
    const SimulatedScene &scene() const { return m_out.scene.scene; }

    /// Calls the program; keeps its answer in a file where one is named.
    bool call(const QStringList &arguments, const std::string &answer = {}, ProgramRun *result = nullptr)
    {
        const ProgramRun run = runCommand(m_settings.program, arguments);
        if (result)
            *result = run;
        if (run.exitStatus != 0) {
            m_out.problem = arguments.first() + s(": ") + QString::fromUtf8(run.err).trimmed();
            return false;
        }
        return answer.empty() || keep(q(m_settings.folder / answer), run.out);
    }

    bool keep(const QString &name, const QByteArray &content)
    {
        QFile file(name);
        if (file.open(QIODevice::WriteOnly) && file.write(content) == content.size())
            return true;
        m_out.problem = name + s(": ") + file.errorString();
        return false;
    }

    /// Writes where a camera sees the markers: those in the picture, not at its very edge, as someone would
    /// pick them.
    bool writePixels(const SimulatedCamera &camera)
    {
        SeededDraw draw("markers of " + m_out.scene.name + camera.name, m_out.scene.seed);
        QByteArray text = "label,u,v\n";
        for (const Marker &marker : scene().floor.markers.markers) {
            const Eigen::Vector3d place(marker.pointInWorld.x(), marker.pointInWorld.y(), 0);
            if (!isInImage(camera.view, place, 3))
                continue;
            const Eigen::Vector2d pixel = *camera.view.pixelFromWorld(place);
            const double du = draw.gaussian(1), dv = draw.gaussian(1);
            text += QByteArray::fromStdString(marker.label) + ',' +
                    QByteArray::number(pixel.x() + m_settings.markerErrorPx * du, 'f', 4) + ',' +
                    QByteArray::number(pixel.y() + m_settings.markerErrorPx * dv, 'f', 4) + '\n';
        }
        return keep(pixelsFile(camera), text);
    }

    QString pixelsFile(const SimulatedCamera &camera) const
    {
        return q(m_settings.folder / ("pixels_" + camera.name + ".csv"));
    }

    bool addCameras()
    {
        if (!call({s("layout"), s("add"), m_project, s("floor"), q(m_media.layout())}))
            return false;
        for (const SimulatedCamera &camera : scene().cameras) {
            const QString name = q(camera.name);
            QStringList calibrate{s("calibrate"), m_project, name};
            for (int i = 0; i < boardImages; ++i)
                calibrate << q(m_media.board(camera, i));
            calibrate << s("--board") << s("9x6") << s("--square") << s("25mm") << s("--json");
            const bool done = writePixels(camera) && call({s("camera"), s("add"), m_project, name}) &&
                              call(calibrate, "calibrate_" + camera.name + ".json") &&
                              call({s("register"), m_project, s("--camera"), name, s("--layout"), s("floor"),
                                    s("--pixels"), pixelsFile(camera), s("--json")},
                                   "register_" + camera.name + ".json");
            if (!done)
                return false;
        }
        return true;
    }

    bool addRobots()
    {
        for (const GivenRobot &robot : m_out.scene.given) {
            QStringList arguments{s("robot"), s("add"), m_project, q(robot.name)};
            if (!robot.colour.empty())
                arguments << s("--colour") << q(robot.colour);
            if (!robot.height.empty())
                arguments << s("--height") << q(robot.height);
            if (!robot.size.empty())
                arguments << s("--size") << q(robot.size);
            if (!call(arguments))
                return false;
        }
        return true;
    }

    bool import()
    {
        QStringList arguments{s("import"), m_project, s("--trial"), s("run")};
        for (const SimulatedCamera &camera : scene().cameras)
            arguments << s("--video") << q(camera.name) + s("=") + q(m_media.video(camera));
        for (const GivenRobot &robot : m_out.scene.given)
            arguments << s("--robot") << q(robot.name);
        const bool several = scene().cameras.size() > 1;
        const auto offsetS = [&](std::size_t camera) {
            return frameSceneTime(scene(), static_cast<int>(camera), 0) - frameSceneTime(scene(), 0, 0);
        };
        QStringList offsets;
        for (std::size_t camera = 1; camera < scene().cameras.size(); ++camera)
            offsets << QString::number(offsetS(camera), 'f', 6);
        arguments << s("--sync")
                  << (m_out.scene.findsOffset ? s("auto")
                      : several               ? offsets.join(u',')
                                              : s("none"))
                  << s("--json");
        ProgramRun run;
        if (!call(arguments, "import.json", &run))
            return false;
        if (m_out.scene.findsOffset)
            m_out.offsetErrorS =
                run.json().value(s("sync")).toObject().value(s("offset_s")).toDouble() - offsetS(1);
        return true;
    }

    /// Names that are the program's own choice, among robots of no colour, are those of the robots that they
    /// fit best.
    std::optional<AccuracySums> comparedWith(const QByteArray &csv, std::size_t robot) const
    {
        if (!m_out.scene.given[robot].colour.empty())
            return compareWithTruth(csv, m_out.scene, robot);
        std::optional<AccuracySums> best;
        for (std::size_t other = 0; other < scene().robots.size(); ++other) {
            const auto sums = compareWithTruth(csv, m_out.scene, other);
            if (sums && (!best || sums->squaredMm < best->squaredMm))
                best = sums;
        }
        return best;
    }

    bool exportTracks()
    {
        for (std::size_t robot = 0; robot < scene().robots.size(); ++robot) {
            const QString name = q(scene().robots[robot].name),
                          file = q(m_settings.folder) + s("/track_") + name + s(".csv");
            if (!call({s("export"), m_project, s("run"), s("-o"), file, s("--format"), s("csv"), s("--robot"),
                       name}))
                return false;
            QFile csv(file);
            const auto sums =
                csv.open(QIODevice::ReadOnly) ? comparedWith(csv.readAll(), robot) : std::nullopt;
            if (!sums) {
                m_out.problem = file + s(": not the table that is promised");
                return false;
            }
            m_out.robots.push_back(*sums);
        }
        return true;
    }

    const SceneMedia m_media;
    const MeasureSettings m_settings;
    const QString m_project;
    MeasuredScene m_out;
};

} // namespace

AccuracySums MeasuredScene::sums() const
{
    AccuracySums total;
    for (const AccuracySums &robot : robots)
        total += robot;
    return total;
}

MeasuredScene measureScene(const AccuracyScene &scene, const SceneMedia &media,
                           const MeasureSettings &settings)
{
    return ProjectMaker(scene, media, settings).measure();
}

} // namespace odo::test
