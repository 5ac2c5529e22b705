// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/output_file.h"

#include "core/files/descriptor.h"

#include <cerrno>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>

namespace odo {

OutputFile::OutputFile(OutputTarget target, FileKind kind, std::unique_ptr<TemporaryFile> temporary)
    : m_target(std::move(target)), m_kind(kind), m_temporary(std::move(temporary))
{
}

Result<std::unique_ptr<OutputFile>> OutputFile::open(const OutputTarget &target, FileKind kind)
{
    const auto place = checkOutput(target, kind);
    if (!place)
        return tl::unexpected(place.error());
    auto temporary = TemporaryFile::make(place->real.parent_path(), "file '" + target.file.string() + "'");
    if (!temporary)
        return tl::unexpected(temporary.error());
    if (place->exists) // its readers stay the same; not every file system can
        static_cast<void>(::fchmod((*temporary)->descriptor(), place->permissions));
    return std::unique_ptr<OutputFile>(new OutputFile(target, kind, std::move(*temporary)));
}

tl::unexpected<Error> OutputFile::failure(const std::string &reason) const
{
    return fail(ErrorCode::Io, "file '" + m_target.file.string() + "'", "it cannot be written (" + reason + ")",
                "choose a folder that you may write to and that has room");
}

Result<void> OutputFile::write(std::string_view bytes)
{
    const int failed = writeAll(descriptor(), bytes);
    return failed == 0 ? Result<void>() : failure(std::strerror(failed));
}

Result<void> OutputFile::commit()
{
    for (;;) {
        const auto place = checkOutput(m_target, m_kind);
        if (!place)
            return tl::unexpected(place.error());
        if (place->exists)
            return m_temporary->replace(place->real);
        auto published = m_temporary->publish(place->real);
        if (published || published.error().code != ErrorCode::AlreadyExists)
            return published; // else somebody was quicker: is that file one that may be replaced?
    }
}

Result<void> writeOutput(const OutputTarget &target, const std::function<Result<void>(const OutputSink &)> &write)
{
    std::unique_ptr<OutputFile> output;
    const OutputSink sink = [&](std::string_view piece) -> Result<void> {
        if (!output) {
            auto opened = OutputFile::open(target, kindOf(piece));
            if (!opened)
                return tl::unexpected(opened.error());
            output = std::move(*opened);
        }
        return output->write(piece);
    };
    if (auto written = write(sink); !written)
        return written;
    if (auto ended = sink({}); !ended) // so that there is a file where there was no piece
        return ended;
    return output->commit();
}

Result<void> writeOutput(const OutputTarget &target, std::string_view bytes)
{
    return writeOutput(target, [bytes](const OutputSink &sink) { return sink(bytes); });
}

} // namespace odo
