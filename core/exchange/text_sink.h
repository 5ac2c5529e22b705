// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <functional>
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
template <class Write> std::string wholeText(const Write &write)
{
    std::string text;
    static_cast<void>(write([&text](std::string_view piece) -> Result<void> {
        text += piece;
        return {};
    }));
    return text;
}

} // namespace odo
