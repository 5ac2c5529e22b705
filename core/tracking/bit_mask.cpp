// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/bit_mask.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace odo {

namespace {

/// A row's word moved by one pixel; what enters comes from the word beside it.
std::uint64_t toTheRight(std::uint64_t word, std::uint64_t before)
{
    return (word << 1) | (before >> 63);
}

std::uint64_t toTheLeft(std::uint64_t word, std::uint64_t after)
{
    return (word >> 1) | (after << 63);
}

} // namespace

void BitMask::reset(int width, int height)
{
    m_width = width;
    m_height = height;
    m_words = (width + wordBits - 1) / wordBits;
    m_bits.assign(std::size_t(m_words) * std::size_t(height), 0);
}

void BitMask::setRow(int y, const std::uint8_t *values, int x0, int x1)
{
    constexpr int atOnce = 8;
    Word *words = row(y);
    int x = x0;
    for (; x + atOnce <= x1; x += atOnce) {
        Word bytes = 0;
        std::memcpy(&bytes, values + (x - x0), atOnce);
        const Word bits = (bytes * 0x0102040810204080U) >> 56; // each byte's bit is shifted to a place of its own in the top byte
        const int shift = x % wordBits;
        words[x / wordBits] |= bits << shift;
        if (shift > wordBits - atOnce)
            words[x / wordBits + 1] |= bits >> (wordBits - shift);
    }
    for (; x < x1; ++x)
        words[x / wordBits] |= Word(values[x - x0]) << (x % wordBits);
}

void BitMask::setRun(int y, int x0, int x1)
{
    Word *words = row(y);
    for (int x = x0, end = 0; x < x1; x = end) {
        end = std::min(x1, (x / wordBits + 1) * wordBits);
        words[x / wordBits] |= bitsOf(x, end);
    }
}

int BitMask::next(int x, int y, Word inverted) const
{
    if (x >= m_width)
        return m_width;
    const Word *words = row(y);
    int w = x / wordBits;
    Word rest = (words[w] ^ inverted) & (~Word(0) << (x % wordBits));
    while (rest == 0 && ++w < m_words)
        rest = words[w] ^ inverted;
    return rest == 0 ? m_width : std::min(m_width, w * wordBits + std::countr_zero(rest));
}

int BitMask::lastSet(int x, int y) const
{
    const Word *words = row(y);
    for (int end = x; end > 0; end = (end - 1) / wordBits * wordBits) {
        const int w = (end - 1) / wordBits;
        if (const Word rest = words[w] & bitsOf(w * wordBits, end); rest != 0)
            return (w + 1) * wordBits - 1 - std::countl_zero(rest);
    }
    return -1;
}

void BitMask::copyRow(int y, int x0, int x1, std::uint8_t *values) const
{
    constexpr int atOnce = 8;
    const Word *words = row(y);
    int x = x0;
    for (; x + atOnce <= x1; x += atOnce) {
        const int shift = x % wordBits, w = x / wordBits;
        const Word after = shift > wordBits - atOnce ? words[w + 1] << (wordBits - shift) : 0;
        // In each byte one of the bits, which adding 127 carries to the byte's top.
        const Word apart = (((words[w] >> shift) | after) & 0xFF) * 0x0101010101010101U & 0x8040201008040201U;
        const Word bytes = ((apart + 0x7F7F7F7F7F7F7F7FU) >> 7) & 0x0101010101010101U;
        std::memcpy(values + (x - x0), &bytes, atOnce);
    }
    for (; x < x1; ++x)
        values[x - x0] = at(x, y) ? 1 : 0;
}

BitMask BitMask::cropped(const PixelRect &part) const
{
    BitMask result(part.width(), part.height());
    const int first = part.x0 / wordBits, shift = part.x0 % wordBits;
    for (int y = 0; y < result.m_height; ++y) {
        const Word *from = row(part.y0 + y) + first;
        Word *words = result.row(y);
        for (int w = 0; w < result.m_words; ++w) {
            const Word after = shift > 0 && first + w + 1 < m_words ? from[w + 1] << (wordBits - shift) : 0;
            words[w] = (from[w] >> shift) | after;
        }
        if (result.m_words > 0)
            words[result.m_words - 1] &= result.lastWord();
    }
    return result;
}

BitMask BitMask::padded(int margin) const
{
    BitMask result(m_width + 2 * margin, m_height + 2 * margin);
    result.add(*this, margin, margin);
    return result;
}

void BitMask::add(const BitMask &part, int x0, int y0)
{
    const int first = x0 / wordBits, shift = x0 % wordBits;
    for (int y = 0; y < part.m_height; ++y) {
        const Word *from = part.row(y);
        Word *words = row(y0 + y) + first;
        for (int w = 0; w < part.m_words; ++w) {
            words[w] |= from[w] << shift;
            if (shift > 0 && first + w + 1 < m_words)
                words[w + 1] |= from[w] >> (wordBits - shift);
        }
    }
}

int BitMask::count() const
{
    int pixels = 0;
    for (const Word word : m_bits)
        pixels += std::popcount(word);
    return pixels;
}

bool BitMask::isEmpty() const
{
    return std::ranges::all_of(m_bits, [](Word word) { return word == 0; });
}

PixelRect BitMask::bounds() const
{
    PixelRect box{m_width, m_height, 0, 0};
    for (int y = 0; y < m_height; ++y) {
        const Word *words = row(y);
        int first = 0, last = m_words - 1;
        while (first < m_words && words[first] == 0)
            ++first;
        if (first == m_words)
            continue;
        while (words[last] == 0)
            --last;
        box.x0 = std::min(box.x0, first * wordBits + std::countr_zero(words[first]));
        box.x1 = std::max(box.x1, (last + 1) * wordBits - std::countl_zero(words[last]));
        box.y0 = std::min(box.y0, y);
        box.y1 = y + 1;
    }
    return box.isEmpty() ? PixelRect() : box;
}

BitMask &BitMask::operator|=(const BitMask &other)
{
    for (std::size_t i = 0; i < m_bits.size(); ++i)
        m_bits[i] |= other.m_bits[i];
    return *this;
}

BitMask &BitMask::operator&=(const BitMask &other)
{
    for (std::size_t i = 0; i < m_bits.size(); ++i)
        m_bits[i] &= other.m_bits[i];
    return *this;
}

BitMask &BitMask::operator-=(const BitMask &other)
{
    for (std::size_t i = 0; i < m_bits.size(); ++i)
        m_bits[i] &= ~other.m_bits[i];
    return *this;
}

BitMask BitMask::complement() const
{
    BitMask result = *this;
    for (int y = 0; y < m_height; ++y) {
        Word *words = result.row(y);
        for (int w = 0; w < m_words; ++w)
            words[w] = ~words[w];
        words[m_words - 1] &= lastWord();
    }
    return result;
}

/// Dilates by one pixel to the left and right.
void BitMask::widen(bool isOutsideSet)
{
    const Word outside = isOutsideSet ? ~Word(0) : 0;
    for (int y = 0; y < m_height; ++y) {
        Word *words = row(y);
        words[m_words - 1] |= outside & ~lastWord();
        Word before = outside;
        for (int w = 0; w < m_words; ++w) {
            const Word here = words[w], after = w + 1 < m_words ? words[w + 1] : outside;
            words[w] = here | toTheRight(here, before) | toTheLeft(here, after);
            before = here;
        }
        words[m_words - 1] &= lastWord();
    }
}

/// Adds the rows of another set, `down` rows lower.
void BitMask::addMoved(const BitMask &other, int down)
{
    const auto skipped = std::min(std::ptrdiff_t(m_bits.size()), std::ptrdiff_t(std::abs(down)) * m_words);
    const std::ptrdiff_t count = std::ptrdiff_t(m_bits.size()) - skipped;
    Word *__restrict into = m_bits.data() + (down > 0 ? skipped : 0);
    const Word *from = other.m_bits.data() + (down > 0 ? 0 : skipped);
    for (std::ptrdiff_t i = 0; i < count; ++i)
        into[i] |= from[i];
}

BitMask BitMask::dilated(int radius, bool isOutsideSet) const
{
    BitMask result(m_width, m_height);
    if (m_bits.empty())
        return result;
    BitMask wide = *this;
    int halfWidth = 0;
    for (int dy = radius; dy >= 0; --dy) { // the disc's rows from the narrowest
        for (const auto wanted = int(std::lround(std::sqrt(double(radius * radius - dy * dy)))); halfWidth < wanted; ++halfWidth)
            wide.widen(isOutsideSet);
        result.addMoved(wide, dy);
        result.addMoved(wide, -dy);
    }
    for (int y = 0; isOutsideSet && y < m_height; ++y) {
        if (y >= radius && y < m_height - radius)
            continue;
        std::fill_n(result.row(y), m_words, ~Word(0));
        result.row(y)[m_words - 1] = lastWord();
    }
    return result;
}

BitMask BitMask::grown() const
{
    BitMask wide = *this;
    wide.widen(false);
    BitMask result = wide;
    result.addMoved(wide, 1);
    result.addMoved(wide, -1);
    return result;
}

BitMask BitMask::eroded(int radius, bool isOutsideSet) const
{
    return complement().dilated(radius, !isOutsideSet).complement();
}

BitMask BitMask::crowded() const
{
    // Of each pixel and its neighbours in the row, their number in two bits.
    BitMask ones(m_width, m_height), twos(m_width, m_height), result(m_width, m_height);
    for (int y = 0; y < m_height; ++y) {
        const Word *words = row(y);
        for (int w = 0; w < m_words; ++w) {
            const Word here = words[w], left = toTheRight(here, w > 0 ? words[w - 1] : 0), right = toTheLeft(here, w + 1 < m_words ? words[w + 1] : 0);
            ones.row(y)[w] = left ^ here ^ right;
            twos.row(y)[w] = (left & here) | (here & right) | (left & right);
        }
    }
    const std::vector<Word> none(std::size_t(m_words), 0);
    const auto rowOf = [&](const BitMask &of, int y) { return y < 0 || y >= m_height ? none.data() : of.row(y); };
    for (int y = 0; y < m_height; ++y) {
        const Word *a1 = rowOf(ones, y - 1), *b1 = rowOf(ones, y), *c1 = rowOf(ones, y + 1);
        const Word *a2 = rowOf(twos, y - 1), *b2 = rowOf(twos, y), *c2 = rowOf(twos, y + 1);
        for (int w = 0; w < m_words; ++w) {
            const Word twoTwos = (a2[w] & b2[w]) | (b2[w] & c2[w]) | (a2[w] & c2[w]);
            result.row(y)[w] = twoTwos | ((a2[w] | b2[w] | c2[w]) & (a1[w] | b1[w] | c1[w])) | (a1[w] & b1[w] & c1[w]);
        }
        result.row(y)[m_words - 1] &= lastWord();
    }
    return result;
}

} // namespace odo
