// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/table/internal/number_style.h"
#include "core/exchange/table/internal/raw_track.h"
#include "core/exchange/table/track_reading.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace odo {

/// Puts the cells of rows into tracks. One thread; the path must outlive it.
class TableRows
{
public:
    TableRows(RawTable table, NumberStyle style, char delimiter, const TrackReading &reading,
              const std::filesystem::path &file);
    Result<void> add(const std::vector<std::string_view> &cells, int line);
    /// Whether a row has fewer cells than the header, as where a program was stopped while it wrote.
    bool isCut(const std::vector<std::string_view> &cells) const;
    /// Refuses more rows without a time than a few.
    Result<RawTable> finish(int lastLine);

private:
    Result<void> checkCount(const std::vector<std::string_view> &cells) const;
    Result<std::optional<Stamp>> stampOfRow(const std::vector<std::string_view> &cells);
    Result<void> addTo(RawTrack &track, const Stamp &stamp, const std::vector<std::string_view> &cells);
    RawTrack &trackNamed(std::string_view id);
    void mergeTracks();
    Result<double> numberAt(const std::vector<std::string_view> &cells, std::size_t column) const;
    Result<std::array<double, 2>> pairAt(const std::vector<std::string_view> &cells, std::size_t x,
                                         std::size_t y, const MessageText &oneIsBlank) const;
    Result<void> addSigmas(RawTrack &track, const std::vector<std::string_view> &cells) const;
    double headingAt(const TrackColumns &columns, const std::vector<std::string_view> &cells) const;
    bool isMarkedLost(const std::vector<std::string_view> &cells) const;
    tl::unexpected<Error> wrong(Message why, Message advice) const;

    RawTable m_table;
    NumberStyle m_style;
    bool m_endsWithDelimiter; ///< rows may, whatever the header does
    const TrackReading &m_reading;
    const std::filesystem::path &m_file;
    std::map<std::string, std::size_t, std::less<>> m_byId;
    std::optional<Error> m_firstUnreadable;
    std::size_t m_rows = 0, m_places = 0;
    int m_line = 0;
};

} // namespace odo
