// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/text_file.h"

#include <QFile>
#include <QStringDecoder>
#include <charconv>
#include <cstdlib>

namespace odo {

namespace {

Result<void> checkEncoding(const std::string &what, const QByteArray &bytes)
{
    if (bytes.startsWith("\xff\xfe") || bytes.startsWith("\xfe\xff"))
        return fail(ErrorCode::InvalidInput, what, "it is written in UTF-16",
                    "save it again as \"CSV UTF-8\" or as a UTF-8 text");
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    static_cast<void>(QString(decoder(bytes)));
    if (decoder.hasError() || bytes.contains('\0'))
        return fail(ErrorCode::InvalidInput, what, "it is not a UTF-8 text file",
                    "save it again as UTF-8 text");
    return {};
}

} // namespace

std::string atLine(const std::filesystem::path &file, int line)
{
    return file.string() + ":" + std::to_string(line);
}

Result<std::string> readTextFile(const std::filesystem::path &file, std::size_t maxBytes)
{
    const std::string what = "file '" + file.string() + "'";
    std::error_code problem;
    if (std::filesystem::is_directory(file, problem))
        return fail(ErrorCode::InvalidInput, what, "it is a folder", "name a file");
    QFile input(QString::fromStdString(file.string()));
    if (!input.open(QIODevice::ReadOnly)) {
        if (!input.exists())
            return fail(ErrorCode::NotFound, what, "there is no such file", "check the name");
        return fail(ErrorCode::Io, what, "it cannot be read", "check that you may read the file");
    }
    // In blocks, because reading all that is allowed at once would take memory for it. One block more than allowed tells a
    // file that is too large from one that just fits, also where no size is known.
    constexpr qint64 blockBytes = 1 << 16;
    QByteArray bytes = input.read(blockBytes);
    for (QByteArray block = bytes; !block.isEmpty() && static_cast<std::size_t>(bytes.size()) <= maxBytes; bytes += block)
        block = input.read(blockBytes);
    if (static_cast<std::size_t>(bytes.size()) > maxBytes)
        return fail(ErrorCode::InvalidInput, what,
                    "it is larger than " + std::to_string(maxBytes / 1024) + " KiB",
                    "check that it is the right file");
    if (auto text = checkEncoding(what, bytes); !text)
        return tl::unexpected(text.error());
    if (bytes.startsWith("\xef\xbb\xbf"))
        bytes.remove(0, 3);
    return bytes.toStdString();
}

std::string numberText(double value)
{
    char text[400]; // the longest double without exponent has 309 digits before the point
    const auto [end, problem] = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
    if (problem != std::errc())
        return "0"; // below 1e-307: nothing that anybody measures
    return std::string(text, end);
}

} // namespace odo
