// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_vote.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

/// So many images of one board, and the next is searched for it first.
constexpr int enoughOfOneBoard = 3;

struct Votes
{
    BoardKind kind;
    int views = 0, atBorder = 0;

    int corners() const { return kind.columns * kind.rows; }
};

/// Whether another line of corners beyond the outermost ones would be outside the image.
bool reachesBorder(const BoardView &view, int widthPx, int heightPx)
{
    return std::ranges::any_of(view.pixels, [&](const Eigen::Vector2d &corner) {
        double spacing = HUGE_VAL;
        for (const Eigen::Vector2d &other : view.pixels) {
            if (&other != &corner)
                spacing = std::min(spacing, (other - corner).norm());
        }
        const double left = corner.x() + 0.5, right = widthPx - left, top = corner.y() + 0.5,
                     bottom = heightPx - top;
        return std::min({left, right, top, bottom}) < spacing;
    });
}

bool fitsInto(const BoardKind &small, const BoardKind &large)
{
    const bool fits = (small.columns <= large.columns && small.rows <= large.rows) ||
                      (small.rows <= large.columns && small.columns <= large.rows);
    return small.pattern == large.pattern && fits && !(small == large);
}

} // namespace

BoardKind votedBoard(const std::vector<BoardView> &views, int widthPx, int heightPx)
{
    std::vector<Votes> all;
    for (const BoardView &view : views) {
        auto votes = std::ranges::find(all, kindOf(view), &Votes::kind);
        if (votes == all.end())
            votes = all.insert(all.end(), {kindOf(view)});
        ++votes->views;
        votes->atBorder += reachesBorder(view, widthPx, heightPx) ? 1 : 0;
    }
    if (all.empty())
        return {};
    Votes best = *std::ranges::max_element(all, [](const Votes &a, const Votes &b) {
        return a.views != b.views ? a.views < b.views : a.corners() < b.corners();
    });
    std::ranges::stable_sort(all, {}, &Votes::corners);
    for (const Votes &larger : all) {
        const bool isCut = 2 * best.atBorder >= best.views;
        if (larger.views >= 2 && isCut && fitsInto(best.kind, larger.kind))
            best = larger;
    }
    return best.kind;
}

std::optional<BoardKind> likelyBoard(const std::vector<BoardView> &views, int widthPx, int heightPx)
{
    const BoardKind voted = votedBoard(views, widthPx, heightPx);
    const auto shown =
        std::ranges::count_if(views, [&](const BoardView &view) { return kindOf(view) == voted; });
    return shown >= enoughOfOneBoard ? std::optional(voted) : std::nullopt;
}

BoardSpec specOf(const BoardSpec &asked, const BoardKind &kind)
{
    BoardSpec spec = asked;
    spec.pattern = kind.pattern;
    spec.columns = kind.columns;
    spec.rows = kind.rows;
    return spec;
}

Result<BoardView> findBoardForVote(const Frame &frame, const BoardSpec &asked,
                                   const std::optional<BoardKind> &likely, const std::string &source)
{
    if (asked.columns != 0 || !likely)
        return findBoard(frame, asked, source);
    auto view = findBoard(frame, specOf(asked, *likely), source);
    if (view)
        return view;
    auto other = findBoard(frame, asked, source);
    return other ? other : view;
}

} // namespace odo
