// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/text_file.h"

#include "core/base/error.h"
#include "core/files/file_words.h"
#include "core/files/protected_files.h"

#include <QFile>
#include <QStringDecoder>
#include <charconv>
#include <cstdlib>

namespace odo {

struct TextFile::Impl
{
    Message what; ///< for messages
    std::size_t maxBytes = 0, count = 0;
    QFile input;
    QStringDecoder decoder{QStringDecoder::Utf8};

    tl::unexpected<Error> tooLarge() const
    {
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("exchange.file_too_large", "it is larger than %1")(
                        quantity(static_cast<double>(maxBytes / 1024), 0, "KiB")),
                    checkRightFile());
    }

    /// A character may begin in one block and end in the next.
    Result<void> checkEncoding(const QByteArray &block, bool isLast)
    {
        if (count == 0 && (block.startsWith("\xff\xfe") || block.startsWith("\xfe\xff")))
            return fail(
                ErrorCode::InvalidInput, what, ODO_TEXT("exchange.is_utf16", "it is written in UTF-16"),
                ODO_TEXT("exchange.save_as_csv_utf8", "save it again as \"CSV UTF-8\" or as a UTF-8 text"));
        // the sequence before must be complete
        static_cast<void>(QString(decoder(isLast ? QByteArrayLiteral("\n") : block)));
        if (decoder.hasError() || block.contains('\0'))
            return fail(ErrorCode::InvalidInput, what,
                        ODO_TEXT("exchange.is_no_utf8", "it is not a UTF-8 text file"),
                        ODO_TEXT("exchange.save_as_utf8", "save it again as UTF-8 text"));
        return {};
    }
};

TextFile::TextFile(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
TextFile::~TextFile() = default;
TextFile::TextFile(TextFile &&) noexcept = default;

Message atLine(const std::filesystem::path &file, int line)
{
    return ODO_TEXT("exchange.at_line", "%1:%2")(Named::file(file), line);
}

Result<TextFile> TextFile::open(const std::filesystem::path &file, std::size_t maxBytes)
{
    auto impl = std::make_unique<Impl>();
    impl->what = quotedFileSubject(file);
    impl->maxBytes = maxBytes;
    ODO_TRY(checkMayBeRead(file, impl->what));
    impl->input.setFileName(QString::fromStdString(file.string()));
    if (!impl->input.open(QIODevice::ReadOnly))
        return fail(ErrorCode::Io, impl->what, cannotBeRead(impl->input.errorString().toStdString()),
                    checkFileMayBeRead());
    if (static_cast<std::size_t>(impl->input.size()) > maxBytes)
        return impl->tooLarge();
    return TextFile(std::move(impl));
}

Result<std::string> TextFile::read()
{
    constexpr qint64 blockBytes = 1 << 16;
    QByteArray block = m_impl->input.read(blockBytes);
    ODO_TRY(m_impl->checkEncoding(block, block.isEmpty()));
    const bool isFirst = m_impl->count == 0;
    m_impl->count += static_cast<std::size_t>(block.size());
    if (m_impl->count > m_impl->maxBytes) // it has grown, or its size is not known (/proc)
        return m_impl->tooLarge();
    if (isFirst && block.startsWith("\xef\xbb\xbf"))
        block.remove(0, 3);
    return block.toStdString();
}

Message TextFile::lineName(int line) const
{
    return atLine(m_impl->input.fileName().toStdString(), line);
}

std::size_t TextFile::size() const
{
    return static_cast<std::size_t>(m_impl->input.size());
}

Result<std::string> readTextFile(const std::filesystem::path &file, std::size_t maxBytes)
{
    auto input = ODO_TRY(TextFile::open(file, maxBytes));
    std::string text;
    for (;;) {
        const auto block = ODO_TRY(input.read());
        if (block.empty())
            return text;
        text += block;
    }
}

std::string numberText(double value)
{
    char text[400]; // the longest double without exponent has 309 digits before the point
    const auto [end, problem] = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
    if (problem != std::errc())
        return "0"; // below 1e-307: nothing that anybody measures
    return std::string(text, end);
}

Message separatedBySemicolons()
{
    return ODO_TEXT("exchange.separated_by_semicolons", "its columns are separated by semicolons");
}

Message notAFiniteNumber(std::string what)
{
    return ODO_TEXT("exchange.not_a_finite_number", "'%1' is not a finite number")(std::move(what));
}

Message entryIsMissing(std::string key)
{
    return ODO_TEXT("exchange.entry_is_missing", "the entry '%1' is missing")(std::move(key));
}

Message checkRightFile()
{
    return ODO_TEXT("exchange.check_right_file", "check that it is the right file");
}

Message beginWithLine(const std::string &line)
{
    return ODO_TEXT("exchange.begin_with_line", "begin the file with the line %1")(line);
}

} // namespace odo
