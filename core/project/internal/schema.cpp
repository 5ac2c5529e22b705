// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/schema.h"

#include "core/project/internal/old_sentences.h"

#include <QFile>
#include <QRegularExpression>

/// Outside of any namespace, as the macro wants it.
static void initSchema()
{
    Q_INIT_RESOURCE(schema);
}

namespace odo {

namespace {

/// The statements of a step, from core/project/schema. Units and meanings are those of
/// core/project/records.h; docs/project_file.md describes tables and blobs.
std::vector<std::string> step(const char *name)
{
    QFile file(QStringLiteral(":/schema/%1.sql").arg(QLatin1String(name)));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("the program was built without its schema");
    std::vector<std::string> statements;
    static const QRegularExpression comments(QStringLiteral("^--.*\n"), QRegularExpression::MultilineOption),
        ends(QStringLiteral(";\n+(?! )"));
    for (const QString &statement :
         QString::fromUtf8(file.readAll()).remove(comments).split(ends, Qt::SkipEmptyParts))
        statements.push_back(statement.simplified().toStdString());
    return statements;
}

} // namespace

std::vector<Migration> projectMigrations()
{
    initSchema();
    return {
        sqlMigration(ODO_TEXT("project.format_1", "the first schema"), step("01_first_schema")),
        sqlMigration(ODO_TEXT("project.format_2", "manual overrides of samples"), step("02_overrules")),
        sqlMigration(ODO_TEXT("project.format_3", "clock rates of the cameras"), step("03_clock_rates")),
        sqlMigration(ODO_TEXT("project.format_4", "tasks with gates, a reference path and limits"),
                     step("04_tasks")),
        sqlMigration(ODO_TEXT("project.format_5", "synchronisation of each view"),
                     step("05_view_synchronisation")),
        sqlMigration(ODO_TEXT("project.format_6", "calibrations with their boards, corners and images"),
                     step("06_calibration_pictures")),
        sqlMigration(ODO_TEXT("project.format_7", "chosen revisions and registration checks"),
                     step("07_chosen_revisions")),
        sqlMigration(
            ODO_TEXT("project.format_8", "trials during recording, and the raw times of their frames"),
            step("08_running_recordings")),
        sqlMigration(ODO_TEXT("project.format_9", "images of registrations"),
                     step("09_registration_pictures")),
        sqlMigration(
            ODO_TEXT(
                "project.format_10",
                "for a school year: stars, tags, archive, bin, pseudonyms, scoring and the list of changes"),
            step("10_school_year")),
        sqlMigration(ODO_TEXT("project.format_11", "members and robots of teams, zones and the archive of "
                                                   "tasks, and imported tracks"),
                     step("11_teams_and_zones")),
        sqlMigration(ODO_TEXT("project.format_12", "digests of analyses, and long series in chunks"),
                     step("12_proved_analyses")),
        sqlMigration(ODO_TEXT("project.format_13", "reference points of robots"),
                     step("13_reference_points")),
        sqlMigration(ODO_TEXT("project.format_14", "periods with ambiguous robot names"),
                     step("14_doubtful_names")),
        sqlMigration(ODO_TEXT("project.format_15", "robots marked by hand in a frame"),
                     step("15_pointed_out_robots")),
        {ODO_TEXT("project.format_16", "messages as codes with their arguments"), storeMessages},
        sqlMigration(ODO_TEXT("project.format_17", "verdicts, and their acceptance"), step("17_verdicts")),
        sqlMigration(ODO_TEXT("project.format_18", "how the frames of recordings are turned"),
                     step("18_upright_frames")),
        sqlMigration(ODO_TEXT("project.format_19", "ranges and variables of trials"),
                     step("19_ranges_and_variables")),
        sqlMigration(ODO_TEXT("project.format_20", "which observations are in force"),
                     step("20_series_in_force")),
        sqlMigration(ODO_TEXT("project.format_21", "guidance of the tracker, and the school's hub"),
                     step("21_guidance_and_school")),
    };
}

const Migrator &projectMigrator()
{
    static const Migrator migrator(projectMigrations());
    return migrator;
}

} // namespace odo
