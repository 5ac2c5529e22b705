// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <string>
#include <system_error>
#include <tl/expected.hpp>
#include <type_traits>

namespace odo {

/// What kind of failure it was; decides the exit status and what a window offers, never the words.
enum class ErrorCode {
    InvalidInput,  ///< the content given cannot be used (bad file content, bad geometry, bad value)
    NotFound,      ///< something named does not exist
    AlreadyExists, ///< something of that name is there already
    Io,            ///< reading or writing failed
    NewerFormat,   ///< a project written by a newer Odograph
    ReadOnly,      ///< the location cannot be written to
    Undetermined,  ///< the data do not determine what was asked (too few points, no board, no robot)
    WrongCall,     ///< the command line was not understood
    Unavailable,   ///< not there for the moment; it may come back by itself
    Cancelled,     ///< the user stopped it
    Internal,      ///< a library failed in a way that no input should cause
};

/// An expected failure, shown in one line: "WHAT: WHY; DO THIS". Plain value, safe to pass between threads.
struct Error
{
    ErrorCode code = ErrorCode::Internal;
    Message what;   ///< what could not be done, with the file or name at fault
    Message why;    ///< the cause, with line or number where there is one
    Message advice; ///< what the user can do now

    /// "what: why; advice" in English, on one line: control characters are replaced by spaces, and of a part
    /// of more than 600 bytes (a long path) the middle is left out.
    std::string message() const;
};

/// "what: why; advice" as one message.
Message wholeMessage(Message what, Message why, Message advice = {});
/// What went wrong as a message, alone or as a part of another one.
Message wholeMessage(const Error &error);

/// A value, or the Error that prevented it. Expected failures travel this way; broken invariants assert.
template <class T>
using Result = tl::expected<T, Error>;

/// A value, or the system's reason why there is none; no words for a person are chosen yet.
template <class T>
using SystemResult = tl::expected<T, std::error_code>;

/// Of a Result that is known to hold one.
template <class T>
T takeValue(Result<T> &&result)
{
    if constexpr (!std::is_void_v<T>)
        return *std::move(result);
}

/// The value of a Result, or the end of the function that asks for it, whose Result then holds the error:
///     const Layout layout = ODO_TRY(project.layouts().get(id));
/// It is the one way to pass an error on as it is. A statement expression, known to GCC and Clang.
#define ODO_TRY(...)                                                                                         \
    __extension__({                                                                                          \
        auto odoTried = (__VA_ARGS__);                                                                       \
        if (!odoTried)                                                                                       \
            return tl::unexpected(std::move(odoTried).error());                                              \
        ::odo::takeValue(std::move(odoTried));                                                               \
    })

/// Shorthand for returning a failure from a function that gives a Result.
tl::unexpected<Error> fail(ErrorCode code, Message what, Message why, Message advice);

/// The failure of a cancelled job.
tl::unexpected<Error> cancelled(Message what);

/// Whether it went well, where nobody wants the value.
template <class T>
Result<void> withoutValue(const Result<T> &outcome)
{
    return outcome ? Result<void>() : tl::unexpected(outcome.error());
}

/// What many errors and warnings are about, the same words everywhere: "camera 'Left'".
Message cameraSubject(std::string name);
Message robotSubject(std::string name);
Message teamSubject(std::string name);
Message classSubject(std::string name);
Message taskSubject(std::string name);
Message trialSubject(std::string name);
Message layoutSubject(std::string name);
Message fileSubject(const std::filesystem::path &path);       ///< the path alone
Message quotedFileSubject(const std::filesystem::path &path); ///< "file 'A.csv'"
Message quotedName(MessageArgument name);                     ///< "'Left'", in a list
Message robotInTrialSubject(std::string robot, std::string trial);
Message viewInTrialSubject(std::string camera, std::string trial);

} // namespace odo
