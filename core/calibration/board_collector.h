// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/calibration/board_placement.h"
#include "core/calibration/board_vote.h"

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
    /// A sound image of another board or another size than most, which voted.
    bool isOther = false;
    /// why it does not count; none while waiting for the board to be still
    std::optional<Error> refusal;
    std::optional<CollectedImage> image; ///< the board, where it was found, kept or not
};

/// Gathers images of one board until they are enough for a calibration. Refuses, with the reason: no board,
/// another board, blurred, cut off (findBoard); too oblique, too small, another image size, the same pose
/// again. What the board is (pattern, size) and how large the images are, most of the sound images decide
/// (votedBoard). Where a later image changes that, those kept before are dropped: offerAgain() searches them,
/// and those refused before, for the new board. One thread at a time.
class BoardCollector
{
public:
    explicit BoardCollector(BoardSpec spec) : m_asked(std::move(spec)) {}

    /// An image chosen by a person.
    ImageVerdict offer(const Frame &frame, const std::string &source);
    /// An image of a stream: kept by itself once the board was still for half a second by the frames' own
    /// time, is sharp, and differs in pose from all before. Frame times must grow.
    ImageVerdict watch(const Frame &frame, const std::string &source);
    /// An image that was offered or watched before, searched for the board that most show. It does not vote
    /// again.
    ImageVerdict offerAgain(const Frame &frame, const std::string &source);

    const std::vector<CollectedImage> &images() const { return m_images; }
    std::vector<BoardView> views() const;
    CollectedImage remove(std::size_t index);
    void insert(std::size_t index, CollectedImage image);

    /// The board as most images show it; 0 columns: not found out yet.
    BoardSpec spec() const { return m_kind.columns > 0 ? specOf(m_asked, m_kind) : m_asked; }
    /// Grows whenever another board, or another image size, is what most images show.
    int changes() const { return m_changes; }
    int widthPx() const { return m_widthPx; }
    int heightPx() const { return m_heightPx; }
    BoardCoverage coverage() const;

private:
    /// A sound image as it was seen before it was known what most show.
    struct Vote
    {
        CollectedImage image;
        int widthPx, heightPx;
    };

    ImageVerdict examine(const Frame &frame, const std::string &source, const BoardSpec &spec,
                         const std::optional<BoardKind> &likely) const;
    void keep(ImageVerdict &answer, const Frame &frame);
    void keepOfBoard(ImageVerdict &answer, const Frame &frame);
    void count();
    Error refusedForSize(const std::string &source, const Frame &frame) const;
    bool isOfSize(const Frame &frame) const;
    bool isStill(const CollectedImage &image, const Frame &frame);
    /// An image with the board in the same position: one that was kept, or of another board one that voted;
    /// null if there is none.
    const CollectedImage *sameAs(const CollectedImage &image, const Frame &frame) const;

    BoardSpec m_asked;
    BoardKind m_kind;
    std::optional<BoardKind> m_likely; ///< to be searched for first
    std::vector<CollectedImage> m_images;
    std::vector<Vote> m_votes;
    int m_widthPx = 0, m_heightPx = 0, m_changes = 0;
    std::vector<Eigen::Vector2d> m_stillCorners;
    Nanoseconds m_stillSince{0};
};

} // namespace odo
