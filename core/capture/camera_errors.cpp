// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/camera_errors.h"

namespace odo {

Message cameraAtAddress(const std::string &uri)
{
    return ODO_TEXT("capture.camera_at_address", "camera %1")(uri);
}

tl::unexpected<Error> notUnderstood(const std::string &uri, const std::string &part, Message advice)
{
    return fail(ErrorCode::InvalidInput, cameraAtAddress(uri),
                ODO_TEXT("capture.part_not_understood", "'%1' is not understood")(part), std::move(advice));
}

tl::unexpected<Error> noSuchControl(const std::string &uri, const std::string &id)
{
    return fail(ErrorCode::NotFound, cameraAtAddress(uri),
                ODO_TEXT("capture.no_such_control", "it has nothing named '%1' that could be set")(id),
                ODO_TEXT("capture.leave_control_out", "leave it out"));
}

Message controlGoes(const std::string &name, MessageArgument from, MessageArgument to)
{
    return ODO_TEXT("capture.control_goes", "%1 goes from %2 to %3")(name, std::move(from), std::move(to));
}

Message usedByAnotherProgram()
{
    return ODO_TEXT("capture.used_by_another_program", "another program uses it");
}

Message closeThatProgram()
{
    return ODO_TEXT("capture.close_that_program", "close that program");
}

Message notRegisteredToFloor()
{
    return ODO_TEXT("capture.not_registered", "it is not registered to the floor");
}

} // namespace odo
