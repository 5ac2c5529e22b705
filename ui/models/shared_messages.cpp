// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/shared_messages.h"

namespace odo {

Message pictureSubject()
{
    return ODO_TEXT("ui.picture", "the picture");
}

Message anotherJobRuns()
{
    return ODO_TEXT("ui.another_job_runs", "another job is running");
}

Message waitOrCancel()
{
    return ODO_TEXT("ui.wait_or_cancel", "wait until it is done, or cancel it");
}

Message noProjectIsOpen()
{
    return ODO_TEXT("ui.no_project_open", "no project is open");
}

Message addCameraWords(const std::string &name)
{
    return ODO_TEXT("ui.add_camera", "add camera %1")(Named::camera(name));
}

Message addRobotWords(std::string robot)
{
    return ODO_TEXT("ui.add_robot", "add robot %1")(Named::robot(std::move(robot)));
}

Message addTaskWords(std::string task)
{
    return ODO_TEXT("ui.add_task", "add task %1")(Named::task(std::move(task)));
}

Message addLayoutWords(std::string layout)
{
    return ODO_TEXT("ui.add_layout", "add layout %1")(Named::layout(std::move(layout)));
}

} // namespace odo
