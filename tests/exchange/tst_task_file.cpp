// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/task_file.h"

#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestTaskFile : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    Result<Task> readText(const QByteArray &text) const
    {
        const QString name = m_folder.filePath(QStringLiteral("task.json"));
        QFile file(name);
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write");
        file.close();
        return readTaskFile(name.toStdString());
    }

private Q_SLOTS:
    void everyPartIsRead()
    {
        const auto task =
            readText("{\n"
                     "\t\"template\": \"straight_line\",\n"
                     "\t\"gates\": [\n"
                     "\t\t{\"name\": \"Z\\u00fcrich \\\"A\\\"\", \"role\": \"start\",\n"
                     "\t\t \"from_mm\": [0, -200], \"to_mm\": [0, 200.5]},\n"
                     "\t\t{\"name\": \"end, #2\", \"role\": \"finish\", \"from_mm\": [2e3, -200], \"to_mm\": "
                     "[2000, 200]}],\n"
                     "\t\"reference_path\": {\"points_mm\": [[0, 0], [2000, 0]], \"closed\": false},\n"
                     "\t\"limits\": {\"speed_mm_s\": 3000, \"acceleration_mm_s2\": 15000}\n"
                     "}\n");
        QVERIFY2(task.has_value(), task ? "" : task.error().message().c_str());
        QVERIFY(task->kind == TaskTemplate::StraightLine);
        QCOMPARE(task->gates.size(), std::size_t(2));
        QCOMPARE(task->gates[0].name, std::string("Zürich \"A\""));
        QCOMPARE(task->gates[0].to.y(), 0.2005);
        QCOMPARE(task->gates[1].name, std::string("end, #2"));
        QVERIFY(task->gates[1].role == GateRole::Finish && task->gates[1].from.x() == 2.0);
        QVERIFY(task->path.points.size() == 2 && !task->path.closed && task->path.points[1].x() == 2.0);
        QVERIFY(task->limits.maxSpeedMps == 3.0 && task->limits.maxAccelMps2 == 15.0);
    }
    void allIsOptional()
    {
        for (const char *text :
             {"{}",
              "{\"template\": \"free\", \"reference_path\": null, \"limits\": {\"speed_mm_s\": null}}"}) {
            const auto task = readText(text);
            QVERIFY2(task.has_value(), task ? "" : task.error().message().c_str());
            QVERIFY(task->gates.empty() && task->path.points.empty() && !task->limits.maxSpeedMps);
        }
    }
    void zonesAreRead()
    {
        const auto task = readText(
            "{\"zones\": [\n"
            "{\"name\": \"Field\", \"rule\": \"stay_inside\", \"rectangle_mm\": [[3000, 0], [0, 2200]]},\n"
            "{\"name\": \"Pond\", \"rule\": \"stay_outside\", \"corners_mm\": [[500, 500], [900, 500], [700, "
            "800]]}]}");
        QVERIFY2(task.has_value(), task ? "" : task.error().message().c_str());
        QCOMPARE(task->zones.size(), std::size_t(2));
        QVERIFY(task->zones[0].rule == ZoneRule::StayInside && task->zones[0].corners.size() == 4);
        QVERIFY(task->zones[0].corners[2] == Eigen::Vector2d(3, 2.2));
        QVERIFY(task->zones[1].rule == ZoneRule::StayOutside &&
                task->zones[1].corners[2] == Eigen::Vector2d(0.7, 0.8));
        QVERIFY(readText("{\"zones\": []}")->zones.empty());
    }
    void curvesAreSampled()
    {
        const auto circle =
            readText("{\"reference_path\": {\"circle\": {\"centre_mm\": [1500, 1100], \"radius_mm\": 750}}}");
        QVERIFY(circle->path.closed);
        for (const Eigen::Vector2d &point : circle->path.points)
            QVERIFY(std::abs((point - Eigen::Vector2d(1.5, 1.1)).norm() - 0.75) < 1e-12);
        const auto eight = readText(
            "{\"reference_path\": {\"figure_eight\": {\"centre_mm\": [0, 0], \"half_width_mm\": 900, "
            "\"half_height_mm\": 600}}}");
        QVERIFY(eight->path.closed && eight->path.points.front().norm() < 1e-12);
        const auto slalom =
            readText("{\"reference_path\": {\"slalom\": {\"from_mm\": [0, 0], \"to_mm\": [3000, 0], "
                     "\"poles\": 3, \"swing_mm\": 200}}}");
        QVERIFY2(slalom.has_value(), slalom ? "" : slalom.error().message().c_str());
        QVERIFY(!slalom->path.closed && (slalom->path.points.back() - Eigen::Vector2d(3, 0)).norm() < 1e-9);
    }
    void sameAsYaml()
    {
        const auto task =
            readText("template: circle\ngates:\n  - name: line\n    role: start_finish\n    from_mm: [0, 0]\n"
                     "    to_mm: [100, 0]\n");
        QVERIFY2(task.has_value(), task ? "" : task.error().message().c_str());
        QVERIFY(task->gates.front().role == GateRole::StartFinish);
    }
    void errorsNameTheLine_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const char *text, const char *message) {
            QTest::newRow(name) << QByteArray(text) << QString::fromUtf8(message);
        };
        row("empty", "", ":1: the file is empty; write the task as");
        row("no task", "[1, 2]", ":1: the file holds no task");
        row("not closed", "{\n\"template\": \"circle\",",
            ":1: a key is not text, or a bracket is not closed");
        row("unknown key", "{\n\"template\": \"free\",\n\"gatez\": []}",
            ":3: the key 'gatez' is not known; use template, gates, reference_path, limits, zones or name");
        row("twice", "{\"template\": \"free\",\n\"template\": \"circle\"}",
            ":2: the key 'template' appears twice");
        row("template", "{\n\"template\": \"spiral\"}",
            ":2: template 'spiral': no template has this name; use free, straight_line, circle, figure_eight "
            "or slalom");
        row("role",
            "{\"gates\": [\n{\"name\": \"a\", \"role\": \"goal\", \"from_mm\": [0,0], \"to_mm\": [1,0]}]}",
            ":2: role 'goal': gates have no such role; use start, finish, start_finish or split");
        row("no end", "{\"gates\": [\n{\"name\": \"a\", \"role\": \"split\", \"from_mm\": [0,0]}]}",
            ":2: the entry 'to_mm' is missing");
        row("point",
            "{\"gates\": [{\"name\": \"a\", \"role\": \"split\",\n\"from_mm\": [0], \"to_mm\": [1,0]}]}",
            ":2: 'from_mm' is not a point [x, y] in mm");
        row("number",
            "{\"gates\": [{\"name\": \"a\", \"role\": \"split\",\n\"from_mm\": [0, nan], \"to_mm\": [1,0]}]}",
            ":2: 'from_mm' is not a finite number");
        row("no length",
            "{\"gates\": [\n\n{\"name\": \"a\", \"role\": \"split\", \"from_mm\": [5,5], \"to_mm\": [5,5]}]}",
            ":3: gate 'a': its ends are less than 1 mm apart");
        row("two starts",
            "{\"gates\": [{\"name\": \"a\", \"role\": \"start\", \"from_mm\": [0,0], \"to_mm\": [5,5]},\n"
            "{\"name\": \"b\", \"role\": \"start_finish\", \"from_mm\": [0,0], \"to_mm\": [5,5]}]}",
            ":2: gate 'b': gate 'a' is already the start; keep one start and one finish");
        row("same name",
            "{\"gates\": [{\"name\": \"a\", \"role\": \"split\", \"from_mm\": [0,0], \"to_mm\": [5,5]},\n"
            "{\"name\": \"a\", \"role\": \"split\", \"from_mm\": [0,0], \"to_mm\": [5,5]}]}",
            ":2: gate 'a': the name is used twice");
        row("one point", "{\n\"reference_path\": {\"points_mm\": [[0, 0]]}}",
            ":2: reference path: it has too few points");
        row("two paths",
            "{\n\"reference_path\": {\"points_mm\": [[0, 0], [1, 0]], \"circle\": {\"centre_mm\": [0,0], "
            "\"radius_mm\": 5}}}",
            ":2: the reference path has more than one shape");
        row("radius", "{\"reference_path\": {\"circle\": {\"centre_mm\": [0, 0],\n\"radius_mm\": -5}}}",
            ":2: 'radius_mm' is not above zero");
        row("radius that is zero in metres",
            "{\"reference_path\": {\"circle\": {\"centre_mm\": [0, 0],\n\"radius_mm\": 1e-322}}}",
            ":2: 'radius_mm' is not above zero");
        row("poles",
            "{\"reference_path\": {\"slalom\": {\"from_mm\": [0, 0], \"to_mm\": [1, 0], \"swing_mm\": "
            "1,\n\"poles\": 1.5}}}",
            ":2: 'poles' is not a whole number from 1 to 100");
        row("limit", "{\"limits\": {\n\"speed_mm_s\": 0}}", ":2: 'speed_mm_s' is not above zero");
        row("rule",
            "{\"zones\": [\n{\"name\": \"a\", \"rule\": \"inside\", \"rectangle_mm\": [[0, 0], [1, 1]]}]}",
            ":2: rule 'inside': zones have no such rule; use stay_inside or stay_outside");
        row("no corners", "{\"zones\": [\n{\"name\": \"a\", \"rule\": \"stay_inside\"}]}",
            ":2: the zone has no shape; give all corners in order as corners_mm, or two opposite corners as "
            "rectangle_mm");
        row("rectangle",
            "{\"zones\": [{\"name\": \"a\", \"rule\": \"stay_inside\",\n\"rectangle_mm\": [[0, 0]]}]}",
            ":2: 'rectangle_mm' is not two corners; give two opposite corners: [[x, y], [x, y]]");
        row("bow",
            "{\"zones\": [\n{\"name\": \"a\", \"rule\": \"stay_inside\", \"corners_mm\": [[0, 0], [9, 9], "
            "[9, 0], [0, 9]]}]}",
            ":2: zone 'a': its outline crosses itself; enter the corners in order");
        row("zone twice",
            "{\"zones\": [{\"name\": \"a\", \"rule\": \"stay_inside\", \"rectangle_mm\": [[0, 0], [9, 9]]},\n"
            "{\"name\": \"a\", \"rule\": \"stay_inside\", \"rectangle_mm\": [[0, 0], [9, 9]]}]}",
            ":2: zone 'a': the name is used twice");
        row("closed", "{\"reference_path\": {\"points_mm\": [[0, 0], [1, 0]],\n\"closed\": 1}}",
            ":2: 'closed' is neither true nor false");
    }
    void errorsNameTheLine()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);
        const auto task = readText(text);
        QVERIFY(!task.has_value());
        const QString told = QString::fromStdString(task.error().message());
        QVERIFY2(told.contains(QStringLiteral("task.json") + message), qPrintable(told));
        QVERIFY(!told.contains(u'\n'));
    }
    void aMissingFileIsSaid()
    {
        QCOMPARE(readTaskFile("/no/such/task.json").error().code, ErrorCode::NotFound);
    }
};

ODOGRAPH_TEST(TestTaskFile, QCoreApplication)
#include "tst_task_file.moc"
