// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/message.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace odo {

/// Takes a text piece by piece, so that a long one need not be in memory; an error ends the writing.
using TextSink = std::function<Result<void>(std::string_view)>;

/// Gathers small pieces before it passes them on. Once something failed, it passes on nothing more.
class TextPieces
{
public:
    explicit TextPieces(const TextSink &sink) : m_sink(sink) {}
    void add(std::string_view piece)
    {
        constexpr std::size_t enough = 1 << 16;
        m_text += piece;
        if (m_text.size() >= enough)
            flush();
    }
    /// All that is left; what failed, if anything did.
    Result<void> finish()
    {
        flush();
        return m_outcome;
    }

private:
    void flush()
    {
        if (m_outcome && !m_text.empty())
            m_outcome = m_sink(m_text);
        m_text.clear();
    }

    const TextSink &m_sink;
    std::string m_text;
    Result<void> m_outcome;
};

/// The whole text that a function writes to a sink.
template <class Write>
std::string wholeText(const Write &write)
{
    std::string text;
    static_cast<void>(write([&text](std::string_view piece) -> Result<void> {
        text += piece;
        return {};
    }));
    return text;
}

/// "dir/a.csv:12": how messages point at a line of an input.
Message atLine(const std::filesystem::path &file, int line);

/// A UTF-8 text file that is read block by block, whatever its size; a byte order mark is dropped. One thread
/// at a time.
class TextFile
{
public:
    /// Refuses, naming the file: what checkMayBeRead() refuses, and what is larger than the limit.
    static Result<TextFile> open(const std::filesystem::path &file, std::size_t maxBytes);
    ~TextFile();
    TextFile(TextFile &&) noexcept;
    /// The next block, empty at the end. Refuses what is larger than the limit after all, UTF-16 (with the
    /// advice how to save it) and bytes that are no text.
    Result<std::string> read();
    Message lineName(int line) const; ///< atLine
    std::size_t size() const;         ///< bytes, as far as known

private:
    struct Impl;
    explicit TextFile(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// Reads a whole text file as UTF-8; a byte order mark is dropped. Any thread. Refuses, naming the file:
/// no file, larger than the limit, UTF-16 (with the advice how to save it), bytes that are no text.
Result<std::string> readTextFile(const std::filesystem::path &file, std::size_t maxBytes = 1 << 20);

/// The shortest decimal text that reads back as the same number, with '.', without exponent, whatever the
/// locale.
std::string numberText(double value);

/// Messages about files from elsewhere, the same whatever they contain.
Message separatedBySemicolons();
Message notAFiniteNumber(std::string what); ///< the name of an entry, or its content
Message entryIsMissing(std::string key);

Message checkRightFile();                       ///< advice
Message beginWithLine(const std::string &line); ///< advice

} // namespace odo
