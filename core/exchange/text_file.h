// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/exchange/text_sink.h"

#include <filesystem>
#include <memory>
#include <string>

namespace odo {

/// "dir/a.csv:12": how messages point at a line of an input.
std::string atLine(const std::filesystem::path &file, int line);

/// A UTF-8 text file that is read block by block, whatever its size; a byte order mark is dropped. One thread at a time.
class TextFile
{
public:
    /// Refuses, naming the file: what checkMayBeRead() refuses, and what is larger than the limit.
    static Result<TextFile> open(const std::filesystem::path &file, std::size_t maxBytes);
    ~TextFile();
    TextFile(TextFile &&) noexcept;
    /// The next block, empty at the end. Refuses what is larger than the limit after all, UTF-16 (with the advice how to save
    /// it) and bytes that are no text.
    Result<std::string> read();
    std::string lineName(int line) const; ///< atLine
    std::size_t size() const; ///< bytes, as far as known

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

} // namespace odo
