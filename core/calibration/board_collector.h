// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/calibration/board_placement.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// A picture of the board that counts.
struct CollectedPicture
{
    BoardView view;
    BoardPlacement placement;
};

/// What became of a picture.
struct PictureAnswer
{
    bool kept = false;
    /// why it does not count; none while waiting for the board to be still
    std::optional<Error> refusal;
    std::optional<CollectedPicture> picture; ///< the board, where it was found, kept or not
};

/// Gathers pictures of one board until they are enough for a calibration. Refuses, with the reason: no board,
/// another size, blurred, cut off (findBoard); too oblique, too small, another picture size, the same pose
/// again. What the first board turned out to be (pattern, size) holds for those after it. One thread at a
/// time.
class BoardCollector
{
public:
    explicit BoardCollector(BoardSpec spec) : m_spec(std::move(spec)) {}

    /// A picture that a person chose.
    PictureAnswer offer(const Frame &frame, const std::string &source);
    /// A picture of a stream: kept by itself once the board was still for half a second by the frames' own
    /// time, is sharp, and stands as none before. Frame times must grow.
    PictureAnswer watch(const Frame &frame, const std::string &source);

    const std::vector<CollectedPicture> &pictures() const { return m_pictures; }
    std::vector<BoardView> views() const;
    CollectedPicture remove(std::size_t index);
    void insert(std::size_t index, CollectedPicture picture);

    const BoardSpec &spec() const { return m_spec; } ///< 0 columns: not found out yet
    int widthPx() const { return m_widthPx; }
    int heightPx() const { return m_heightPx; }
    BoardCoverage coverage() const;

private:
    PictureAnswer look(const Frame &frame, const std::string &source);
    void keep(const CollectedPicture &picture);
    bool isStill(const CollectedPicture &picture, Nanoseconds time);

    BoardSpec m_spec;
    std::vector<CollectedPicture> m_pictures;
    int m_widthPx = 0, m_heightPx = 0;
    std::vector<Eigen::Vector2d> m_stillCorners;
    Nanoseconds m_stillSince{0};
};

} // namespace odo
