// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include "core/base/plain_text.h"

#include <algorithm>

namespace odo {

namespace {

/// With its middle left out where nobody would read it to its end; whole characters of UTF-8.
std::string shortened(const std::string &part)
{
    constexpr std::size_t longest = 600, kept = longest / 2;
    if (part.size() <= longest)
        return part;
    const auto isInside = [&part](std::size_t at) {
        return (static_cast<unsigned char>(part[at]) & 0xC0) == 0x80;
    };
    std::size_t end = kept, begin = part.size() - kept;
    while (end > 0 && isInside(end))
        --end;
    while (begin < part.size() && isInside(begin))
        ++begin;
    return part.substr(0, end) + "…" + part.substr(begin);
}

} // namespace

std::string Error::message() const
{
    std::string line = shortened(what.english()) + ": " + shortened(why.english());
    if (!advice.isEmpty())
        line += "; " + shortened(advice.english());
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return plainLine(line);
}

tl::unexpected<Error> fail(ErrorCode code, Message what, Message why, Message advice)
{
    return tl::unexpected<Error>(Error{code, std::move(what), std::move(why), std::move(advice)});
}

tl::unexpected<Error> cancelled(Message what)
{
    return fail(ErrorCode::Cancelled, std::move(what), ODO_TEXT("base.cancelled", "cancelled"),
                ODO_TEXT("base.nothing_changed", "nothing was changed"));
}

Message wholeMessage(Message what, Message why, Message advice)
{
    return joined({joined({std::move(what), std::move(why)}, Join::Colon), std::move(advice)},
                  Join::Semicolon);
}

Message wholeMessage(const Error &error)
{
    return wholeMessage(error.what, error.why, error.advice);
}

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
