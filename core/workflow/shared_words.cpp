// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/shared_words.h"

#include "core/base/error.h"
#include "core/files/file_words.h"

namespace odo {

Message folderCalled(const std::filesystem::path &folder)
{
    return ODO_TEXT("workflow.folder", "folder '%1'")(Named::file(folder));
}

Message importSubject(const std::string &trial)
{
    return ODO_TEXT("workflow.import_of_trial", "import of trial '%1'")(Named::trial(trial));
}

Message importChange(const std::string &trial)
{
    return ODO_TEXT("workflow.import_trial", "import trial %1")(Named::trial(trial));
}

Message giveTaskChange(const std::string &trial, const std::string &task)
{
    return ODO_TEXT("workflow.give_task", "give %1 the task %2")(Named::trial(trial), Named::task(task));
}

Message recordingSubject(const std::string &trial)
{
    return ODO_TEXT("workflow.recording_of_trial", "recording of trial '%1'")(Named::trial(trial));
}

Message trackingSubject()
{
    return ODO_TEXT("workflow.tracking", "tracking");
}

MessageArgument quotedNames(const std::vector<std::string> &names, MessageArgument::Kind kind)
{
    std::vector<Message> quoted;
    for (const std::string &name : names)
        quoted.push_back(quotedName({kind, name}));
    return listed(std::move(quoted), MessageArgument::Joint::Comma);
}

tl::unexpected<Error> trialIsThere(Message what)
{
    return fail(ErrorCode::AlreadyExists, std::move(what),
                ODO_TEXT("workflow.trial_is_there", "the project already has a trial of that name"),
                chooseAnotherName());
}

Message notTrackedYet()
{
    return ODO_TEXT("workflow.not_tracked_yet", "it has not been tracked yet");
}

Message nothingToAnalyseAgain()
{
    return ODO_TEXT("workflow.nothing_to_analyse_again",
                    "it has not been tracked yet, so it cannot be reanalysed");
}

Message trackItFirst()
{
    return ODO_TEXT("workflow.track_it_first", "track it first");
}

Message severalRobots(const std::vector<std::string> &robots)
{
    return joined({ODO_TEXT("workflow.several_robots", "it has several robots"),
                   nameAlone(quotedNames(robots, MessageArgument::Kind::Robot))},
                  Join::Colon);
}

Message robotNotTracked(const std::string &robot, const std::vector<std::string> &robots)
{
    return ODO_TEXT("workflow.robot_not_tracked", "robot '%1' was not tracked in it, only %2")(
        Named::robot(robot), quotedNames(robots, MessageArgument::Kind::Robot));
}

Message noRobotToTrack()
{
    return ODO_TEXT("workflow.no_robot", "the project has no robot to track");
}

Message noSuchFrame()
{
    return ODO_TEXT("workflow.no_such_frame", "this frame does not exist");
}

Message chooseFrame(std::int64_t first, std::int64_t last)
{
    return ODO_TEXT("workflow.choose_frame", "choose one from %1 to %2")(first, last);
}

Message chooseAnotherOne()
{
    return ODO_TEXT("workflow.choose_another_one", "choose another one");
}

Message giveAnotherFile()
{
    return ODO_TEXT("workflow.give_another_file", "give another file");
}

Message giveEachViewItsCamera()
{
    return ODO_TEXT("workflow.give_each_view_its_camera", "give each view its own camera");
}

Message registerItFirst()
{
    return ODO_TEXT("workflow.register_it_first", "register it first, with markers or via another camera");
}

Message measuredByFields()
{
    return ODO_TEXT("workflow.interlaced",
                    "it is interlaced: each frame holds two fields taken one after the other, and each is "
                    "measured at its own time, with half the lines");
}

} // namespace odo
