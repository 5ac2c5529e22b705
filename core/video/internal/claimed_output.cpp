// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/claimed_output.h"

namespace odo {

std::error_code ClaimedOutput::open(const std::filesystem::path &file)
{
    auto opened =
        FileHandle::openOrCreate(file, FileHandle::Use::Write, FileHandle::Permissions::UserDefault);
    if (!opened)
        return opened.error();
    m_handle = std::move(*opened);
    const auto there = m_handle.status();
    if (!there)
        return there.error();
    if (there->bytes > 0 || there->kind != files::Kind::File)
        return std::make_error_code(std::errc::file_exists);
    constexpr int bufferBytes = 1 << 16;
    auto *buffer = static_cast<unsigned char *>(libav::allocated(av_malloc(bufferBytes)));
    m_io = avio_alloc_context(buffer, bufferBytes, 1, this, nullptr, write, seek);
    if (m_io)
        return {};
    av_free(buffer);
    return std::make_error_code(std::errc::not_enough_memory);
}

int ClaimedOutput::write(void *output, std::uint8_t *bytes, int count)
{
    const auto *begin = reinterpret_cast<const char *>(bytes);
    const std::error_code problem =
        static_cast<ClaimedOutput *>(output)->m_handle.write({begin, static_cast<std::size_t>(count)});
    return problem ? AVERROR(problem.value()) : count;
}

std::int64_t ClaimedOutput::seek(void *output, std::int64_t offset, int whence)
{
    if ((whence & AVSEEK_SIZE) != 0)
        return AVERROR(ENOSYS);
    const auto at = static_cast<ClaimedOutput *>(output)->m_handle.seek(offset, whence & ~AVSEEK_FORCE);
    return at ? *at : AVERROR(at.error().value());
}

std::error_code ClaimedOutput::close()
{
    std::error_code failed;
    if (m_io) {
        avio_flush(m_io);
        if (m_io->error < 0)
            failed.assign(AVUNERROR(m_io->error), std::generic_category());
        av_freep(static_cast<void *>(&m_io->buffer));
        avio_context_free(&m_io);
    }
    if (m_handle.isOpen())
        if (const std::error_code unsafe = m_handle.sync())
            failed = unsafe;
    m_handle = {};
    return failed;
}

} // namespace odo
