// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/subjects.h"

namespace odo {

Message cameraSubject(std::string name)
{
    return ODO_TEXT("base.camera", "camera '%1'")(Named::camera(std::move(name)));
}

Message robotSubject(std::string name)
{
    return ODO_TEXT("base.robot", "robot '%1'")(Named::robot(std::move(name)));
}

Message teamSubject(std::string name)
{
    return ODO_TEXT("base.team", "team '%1'")(Named::team(std::move(name)));
}

Message classSubject(std::string name)
{
    return ODO_TEXT("base.class", "class '%1'")(Named::schoolClass(std::move(name)));
}

Message taskSubject(std::string name)
{
    return ODO_TEXT("base.task", "task '%1'")(Named::task(std::move(name)));
}

Message trialSubject(std::string name)
{
    return ODO_TEXT("base.trial", "trial '%1'")(Named::trial(std::move(name)));
}

Message layoutSubject(std::string name)
{
    return ODO_TEXT("base.layout", "layout '%1'")(Named::layout(std::move(name)));
}

Message fileSubject(const std::filesystem::path &path)
{
    return nameAlone(Named::file(path));
}

Message quotedFileSubject(const std::filesystem::path &path)
{
    return ODO_TEXT("base.file", "file '%1'")(Named::file(path));
}

Message quotedName(MessageArgument name)
{
    return ODO_TEXT("base.quoted_name", "'%1'")(std::move(name));
}

Message robotInTrialSubject(std::string robot, std::string trial)
{
    return ODO_TEXT("base.robot_in_trial", "robot '%1' in trial '%2'")(Named::robot(std::move(robot)),
                                                                       Named::trial(std::move(trial)));
}

Message viewInTrialSubject(std::string camera, std::string trial)
{
    return ODO_TEXT("base.view_in_trial", "view '%1' in trial '%2'")(Named::camera(std::move(camera)),
                                                                     Named::trial(std::move(trial)));
}

} // namespace odo
