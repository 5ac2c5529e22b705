// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/output_guard.h"
#include "core/files/temporary.h"

#include <functional>
#include <memory>
#include <string_view>

namespace odo {

/// The one way by which a file is written for a person: checked against what must never be overwritten (checkOutput), written beside its place
/// under a name that nobody can foresee, and given its name only when all its bytes are on the disk. Under the name there is the
/// old file or the whole new one; what is not committed leaves nothing. One thread.
class OutputFile
{
public:
    /// kind: of what will be written. Errors: those of checkOutput and TemporaryFile.
    static Result<std::unique_ptr<OutputFile>> open(const OutputTarget &target, FileKind kind);

    /// Where to write to: a descriptor, or the file's name for libraries that open it themselves.
    int descriptor() const { return m_temporary->descriptor(); }
    std::filesystem::path temporary() const { return m_temporary->path(); }
    Result<void> write(std::string_view bytes);
    /// Once, when all is written. The target is checked again: meanwhile something may have got its name.
    Result<void> commit();
    /// For those who write themselves: that it failed, with the system's reason.
    tl::unexpected<Error> failure(const std::string &reason) const;

private:
    OutputFile(OutputTarget target, FileKind kind, std::unique_ptr<TemporaryFile> temporary);

    const OutputTarget m_target;
    const FileKind m_kind;
    std::unique_ptr<TemporaryFile> m_temporary;
};

/// Takes the next piece of what is written.
using OutputSink = std::function<Result<void>(std::string_view piece)>;

/// Writes all that `write` gives to the sink, piece by piece. The kind is that of the first piece. What `write` gives as an error is passed
/// on, and nothing is written.
Result<void> writeOutput(const OutputTarget &target, const std::function<Result<void>(const OutputSink &)> &write);
/// Writes all of it. The kind is that of the bytes.
Result<void> writeOutput(const OutputTarget &target, std::string_view bytes);

} // namespace odo
