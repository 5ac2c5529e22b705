// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/calibration/board_placement.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// An accepted image of the board.
struct CollectedImage
{
    BoardView view;
    BoardPlacement placement;
};

/// The outcome for one image.
struct ImageVerdict
{
    bool kept = false;
    /// why it does not count; none while waiting for the board to be still
    std::optional<Error> refusal;
    std::optional<CollectedImage> image; ///< the board, where it was found, kept or not
};

/// Gathers images of one board until they are enough for a calibration. Refuses, with the reason: no board,
/// another size, blurred, cut off (findBoard); too oblique, too small, another image size, the same pose
/// again. What the first board turned out to be (pattern, size) holds for those after it. One thread at a
/// time.
class BoardCollector
{
public:
    explicit BoardCollector(BoardSpec spec) : m_spec(std::move(spec)) {}

    /// An image chosen by a person.
    ImageVerdict offer(const Frame &frame, const std::string &source);
    /// An image of a stream: kept by itself once the board was still for half a second by the frames' own
    /// time, is sharp, and differs in pose from all before. Frame times must grow.
    ImageVerdict watch(const Frame &frame, const std::string &source);

    const std::vector<CollectedImage> &images() const { return m_images; }
    std::vector<BoardView> views() const;
    CollectedImage remove(std::size_t index);
    void insert(std::size_t index, CollectedImage image);

    const BoardSpec &spec() const { return m_spec; } ///< 0 columns: not found out yet
    int widthPx() const { return m_widthPx; }
    int heightPx() const { return m_heightPx; }
    BoardCoverage coverage() const;

private:
    ImageVerdict examine(const Frame &frame, const std::string &source);
    void keep(const CollectedImage &image);
    bool isStill(const CollectedImage &image, Nanoseconds time);
    /// An image that was kept with the board in the same position; null if there is none.
    const CollectedImage *sameAs(const CollectedImage &image) const;

    BoardSpec m_spec;
    std::vector<CollectedImage> m_images;
    int m_widthPx = 0, m_heightPx = 0;
    std::vector<Eigen::Vector2d> m_stillCorners;
    Nanoseconds m_stillSince{0};
};

} // namespace odo
