// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.h"

namespace odo {

std::span<const NamedCommand> allCommands()
{
    static constexpr NamedCommand commands[] = {
        {"new", "create an empty project", runNew, false},
        {"demo", "create a project with a simulated class and its videos", runDemo, false},
        {"robot", "add a robot to a project", runRobot, false},
        {"camera", "add a camera to a project", runCamera, false},
        {"cameras", "list the cameras that can be opened now", runCameras, false},
        {"calibrate", "compute a camera's intrinsics from images of a board", runCalibrate, false},
        {"calibrate-pair", "compute where one camera is by another, from a board that both see",
         runCalibratePair, false},
        {"intrinsics", "import or export a camera's intrinsics", runIntrinsics, false},
        {"layout", "add, show, transform and export layouts of floor markers", runLayout, false},
        {"register", "register a camera to the floor", runRegister, false},
        {"locate", "compute floor positions of image points", runLocate, false},
        {"moved", "check whether a camera or a marker has moved since the registration", runCheckPosition,
         false},
        {"revisions", "list the calibrations and registrations of a camera, choose one to use", runRevisions,
         false},
        {"advise", "say which camera to move, and how much more accurate that makes the set-up", runAdvise,
         false},
        {"task", "add a task with gates, path and limits; list tasks; set a trial's task", runTask, false},
        {"trial", "change, delete, restore or copy a trial, or accept its doubtful results", runTrial, false},
        {"import", "import the videos of a trial", runImport, false},
        {"record", "record a trial from cameras", runRecord, false},
        {"track", "track the robots of a trial and analyse them", runTrack, false},
        {"reprocess", "show what reanalysing a trial with the current registrations changes", runReprocess,
         false},
        {"flag", "mark a sample as a spike or as valid, and reanalyse", runFlag, false},
        {"list", "list the trials", runList, false},
        {"show", "show a trial's metrics, spikes and provenance", runShow, false},
        {"compare", "compare two runs: time difference, sectors, metrics", runCompare, true},
        {"evaluate", "compare a robot's own log with its measured run: pose errors and drift", runEvaluate,
         false},
        {"report", "write a printable report of trials or of a class", runReport, true},
        {"certificate", "simulate the set-up with a known run and report how accurate it is", runCertificate,
         true},
        {"table", "write the metrics of all trials to a table for spreadsheets", runTable, false},
        {"export", "write a trial's samples, a page to take along, or its annotated video", runExport, false},
        {"school", "exchange trials, tasks and class lists with the school's hub", runSchool, false},
        {"scoreboard", "show the standings of a task as a web page that follows the project or the hub",
         runScoreboard, false},
        {"snapshot", "save an image of the window", runSnapshot, true},
        {"target", "write a board or floor markers for printing", runTarget, true},
        {"backup", "make, list, show and restore backups of a project", runBackup, false},
        {"check", "check a project and its recordings", runCheck, false},
    };
    return commands;
}

} // namespace odo
