// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace odo {

/// A set of pixels of a rectangular image, one bit each, so that 64 pixels are combined at once. Pixels
/// outside the image belong to no set unless an argument says so. One thread at a time.
class BitMask
{
    using Word = std::uint64_t;
    static constexpr int wordBits = 64;

public:
    BitMask() = default;
    BitMask(int width, int height) { reset(width, height); }
    /// An empty set.
    void reset(int width, int height);

    int width() const { return m_width; }
    int height() const { return m_height; }
    bool at(int x, int y) const { return (row(y)[x / wordBits] >> (x % wordBits)) & 1; }
    void clear(int x, int y) { row(y)[x / wordBits] &= ~(Word(1) << (x % wordBits)); }
    void set(int x, int y) { row(y)[x / wordBits] |= Word(1) << (x % wordBits); }
    void put(int x, int y, bool belongs)
    {
        clear(x, y);
        row(y)[x / wordBits] |= Word(belongs) << (x % wordBits);
    }

    /// Adds the pixels of a row from x0 up to, not including, x1.
    void setRun(int y, int x0, int x1);
    /// The first pixel of a row from x on that belongs to the set, or does not; the width where there is
    /// none.
    int nextSet(int x, int y) const { return next(x, y, 0); }
    int nextClear(int x, int y) const { return next(x, y, ~Word(0)); }
    /// The last pixel of a row before x that belongs to the set; −1 where there is none.
    int lastSet(int x, int y) const;
    /// Of each column the first row, or the last one, whose pixel belongs to the set; −1 where there is none.
    std::vector<int> topOfColumns() const;
    std::vector<int> bottomOfColumns() const;

    /// Adds the pixels of a row from x0 up to, not including, x1 whose byte is 1, not 0.
    void setRow(int y, const std::uint8_t *values, int x0, int x1);

    /// A part of the image, which lies in it.
    BitMask cropped(const PixelRect &part) const;
    /// The image with so many pixels more on each side, which do not belong to the set.
    BitMask padded(int margin) const;
    /// Adds the set of a smaller image, whose first pixel is this one's (x0, y0).
    void add(const BitMask &part, int x0, int y0);
    /// The pixels that do not belong to the set.
    BitMask complement() const;

    int count() const;
    bool isEmpty() const;
    /// The smallest rectangle that holds the set; empty for an empty one.
    PixelRect bounds() const;

    /// Of sets of one size.
    BitMask &operator|=(const BitMask &other);
    BitMask &operator&=(const BitMask &other);
    /// Removes the pixels of another set.
    BitMask &operator-=(const BitMask &other);

    /// Dilated and eroded by a disc, which holds the pixels within `radius` of its centre (to half a pixel
    /// along the rows), as OpenCV's ellipse does. isOutsideSet: whether pixels outside the image count as
    /// being in the set.
    BitMask dilated(int radius) const;
    BitMask eroded(int radius, bool isOutsideSet = true) const;
    BitMask opened(int radius) const { return eroded(radius).dilated(radius); }
    BitMask closed(int radius) const { return dilated(radius).eroded(radius); }
    /// Dilated by a square that reaches so many pixels to each side.
    BitMask grown(int reach = 1) const;
    /// Where at least three of the 3 x 3 pixels around belong to the set.
    BitMask crowded() const;

    /// Calls visit(x, y) for each pixel, row by row.
    template <class Visit>
    void forEach(const Visit &visit) const
    {
        for (int y = 0; y < m_height; ++y)
            forEachInRow(y, [&](int x) { visit(x, y); });
    }
    /// Calls visit(x) for each pixel of a row.
    template <class Visit>
    void forEachInRow(int y, const Visit &visit) const
    {
        const Word *words = row(y);
        for (int w = 0; w < m_words; ++w)
            for (Word rest = words[w]; rest != 0; rest &= rest - 1)
                visit(w * wordBits + std::countr_zero(rest));
    }
    /// Calls visit(x0, x1) for each run of pixels of a row, from x0 up to, not including, x1; for a long run
    /// several times in parts.
    template <class Visit>
    void forEachRunInRow(int y, const Visit &visit) const
    {
        const Word *words = row(y);
        for (int w = 0; w < m_words; ++w)
            for (Word rest = words[w]; rest != 0;) {
                const int first = std::countr_zero(rest);
                const Word beyond = rest + (Word(1) << first); // carries through the run
                const int end = beyond == 0 ? wordBits : std::countr_zero(beyond & ~rest);
                visit(w * wordBits + first, w * wordBits + end);
                rest &= beyond;
            }
    }

private:
    Word *row(int y) { return m_bits.data() + std::ptrdiff_t(y) * m_words; }
    const Word *row(int y) const { return m_bits.data() + std::ptrdiff_t(y) * m_words; }
    /// the bits of a row's last word that are pixels
    Word lastWord() const { return (Word(1) << (m_width % wordBits)) - 1; }
    int next(int x, int y, Word inverted) const;
    /// of one word
    static Word bitsOf(int x0, int x1) { return (~Word(0) >> (wordBits - (x1 - x0))) << (x0 % wordBits); }
    std::vector<int> endOfColumns(int begin, int end, int step) const;
    void setSpare(Word *rows, Word outside) const;
    BitMask spread(std::span<const int> halfWidths, Word inverted, Word outside) const;

    int m_width = 0, m_height = 0, m_words = 0;
    /// rows of m_words, each with at least one spare bit beyond the width; those are 0
    std::vector<Word> m_bits;
};

inline BitMask operator|(BitMask a, const BitMask &b)
{
    return a |= b;
}
inline BitMask operator&(BitMask a, const BitMask &b)
{
    return a &= b;
}
inline BitMask operator-(BitMask a, const BitMask &b)
{
    return a -= b;
}

/// Pixels of a row from x0 up to, not including, x1.
struct PixelRun
{
    int y = 0, x0 = 0, x1 = 0;
};

/// Connected pixels: their runs from top to bottom, each row's from left to right.
using ConnectedPart = std::span<const PixelRun>;

/// The parts of a set, the one with the topmost pixel first. Holds their runs.
class ConnectedParts
{
public:
    ConnectedParts() = default;
    /// Runs part by part; ends: of each part, how many runs there are up to its last.
    ConnectedParts(std::vector<PixelRun> runs, const std::vector<std::size_t> &ends);
    ConnectedParts(const ConnectedParts &) = delete;
    ConnectedParts &operator=(const ConnectedParts &) = delete;
    ConnectedParts(ConnectedParts &&) noexcept = default;
    ConnectedParts &operator=(ConnectedParts &&) noexcept = default;

    std::size_t size() const { return m_parts.size(); }
    bool empty() const { return m_parts.empty(); }
    const ConnectedPart &operator[](std::size_t i) const { return m_parts[i]; }
    auto begin() const { return m_parts.begin(); }
    auto end() const { return m_parts.end(); }

private:
    std::vector<PixelRun> m_runs;
    std::vector<ConnectedPart> m_parts; ///< of the runs
};

/// Pixels that only touch at a corner are connected. Pure.
ConnectedParts connectedParts(const BitMask &set);
PixelRect boundsOf(const ConnectedPart &part);
bool contains(const ConnectedPart &part, int x, int y);

/// Whether a part encloses pixels that do not belong to it. Pure.
bool enclosesAny(const ConnectedPart &part);
/// The set and all of the image that it encloses. Pure.
BitMask withoutHoles(const BitMask &set);

} // namespace odo
