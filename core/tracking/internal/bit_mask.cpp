// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/bit_mask.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numeric>
#include <utility>

namespace odo {

namespace {

/// A word of a row moved by one pixel; what enters comes from the word beside it in memory. The end of a row
/// is followed by spare bits, so that all rows can be moved at once.
std::uint64_t toTheRight(const std::uint64_t *word)
{
    return (word[0] << 1) | (word[-1] >> 63);
}

std::uint64_t toTheLeft(const std::uint64_t *word)
{
    return (word[0] >> 1) | (word[1] << 63);
}

/// Dilates by one pixel to the left and right.
void widen(const std::uint64_t *from, std::uint64_t *__restrict into, std::ptrdiff_t count)
{
    for (std::ptrdiff_t i = 0; i < count; ++i)
        into[i] = from[i] | toTheRight(from + i) | toTheLeft(from + i);
}

/// Memory for so many words, which is kept: until the thread asks for it again.
std::uint64_t *workingSpace(std::ptrdiff_t words)
{
    thread_local std::vector<std::uint64_t> space;
    space.resize(std::max(space.size(), std::size_t(words)));
    return space.data();
}

/// Half the widths of a disc's rows, from its middle outwards.
std::vector<int> discRows(int radius)
{
    std::vector<int> halfWidths(std::size_t(radius) + 1);
    for (int dy = 0; dy <= radius; ++dy)
        halfWidths[std::size_t(dy)] = int(std::lround(std::sqrt(double(radius * radius - dy * dy))));
    return halfWidths;
}

} // namespace

void BitMask::reset(int width, int height)
{
    m_width = width;
    m_height = height;
    m_words = width / wordBits + 1;
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
        if (bytes == 0) // nearly always
            continue;
        // each byte's bit is shifted to its own position in the top byte
        const Word bits = (bytes * 0x0102040810204080U) >> 56;
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

/// Of each column the first row with a pixel of the set, in the order from `begin` to before `end`.
std::vector<int> BitMask::endOfColumns(int begin, int end, int step) const
{
    std::vector<int> ends(std::size_t(m_width), -1);
    for (int w = 0; w < m_words; ++w) {
        Word found = 0;
        for (int y = begin; y != end; y += step) {
            const Word here = row(y)[w];
            for (Word fresh = here & ~found; fresh != 0; fresh &= fresh - 1)
                ends[std::size_t(w * wordBits + std::countr_zero(fresh))] = y;
            found |= here;
        }
    }
    return ends;
}

std::vector<int> BitMask::topOfColumns() const
{
    return endOfColumns(0, m_height, 1);
}

std::vector<int> BitMask::bottomOfColumns() const
{
    return endOfColumns(m_height - 1, -1, -1);
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
    constexpr std::size_t atOnce = 31; // words of which each byte's bits add up to what a byte holds
    constexpr Word everyOther = 0x5555555555555555U, pairs = 0x3333333333333333U,
                   halfBytes = 0x0F0F0F0F0F0F0F0FU, bytes = 0x00FF00FF00FF00FFU;
    Word pixels = 0;
    for (std::size_t first = 0; first < m_bits.size(); first += atOnce) {
        Word sums = 0; // one in each byte
        for (std::size_t i = first, end = std::min(first + atOnce, m_bits.size()); i < end; ++i) {
            const Word ofTwo = m_bits[i] - ((m_bits[i] >> 1) & everyOther),
                       ofFour = (ofTwo & pairs) + ((ofTwo >> 2) & pairs);
            sums += (ofFour + (ofFour >> 4)) & halfBytes;
        }
        // all added up in the upper 16 bits
        pixels += (((sums & bytes) + ((sums >> 8) & bytes)) * 0x0001000100010001U) >> 48;
    }
    return int(pixels);
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
    for (Word &word : result.m_bits)
        word = ~word;
    setSpare(result.m_bits.data(), 0);
    return result;
}

/// Sets the spare bits of each of the image's rows to what lies outside.
void BitMask::setSpare(Word *rows, Word outside) const
{
    const Word pixels = lastWord(), spare = outside & ~pixels;
    for (int y = 0; y < m_height; ++y) {
        Word &last = rows[std::ptrdiff_t(y + 1) * m_words - 1];
        last = (last & pixels) | spare;
    }
}

/// Dilates by a shape of so many rows above and below its middle, none wider than one nearer to it;
/// halfWidths: from the middle outwards. inverted: all ones where the complement is dilated instead. outside:
/// all ones where pixels outside the image are in the set.
BitMask BitMask::spread(std::span<const int> halfWidths, Word inverted, Word outside) const
{
    BitMask result(m_width, m_height);
    const auto count = std::ptrdiff_t(m_bits.size()),
               margin = (std::ptrdiff_t(halfWidths.size()) - 1) * m_words, stride = count + 2 * margin;
    // three images with rows of what lies outside above and below
    thread_local std::vector<Word> work; // of that size once for all
    work.resize(std::max(work.size(), std::size_t(3 * stride)));
    Word *source = work.data() + margin, *wide = source + stride, *wider = wide + stride;
    for (Word *image : {source, wide, wider}) {
        std::fill_n(image - margin, margin, outside);
        std::fill_n(image + count, margin, outside);
    }
    for (std::ptrdiff_t i = 0; i < count; ++i)
        source[i] = m_bits[std::size_t(i)] ^ inverted;
    setSpare(source, outside);
    std::copy_n(source, count, wide);
    int half = halfWidths.front();
    const auto widenTo = [&](int wanted) {
        for (; half > wanted; --half) { // what is taken in from now on is widened less
            if (half < halfWidths.front())
                setSpare(wide, outside);
            widen(wide, wider, count);
            std::swap(wide, wider);
        }
    };
    for (std::ptrdiff_t dy = 1; dy < std::ptrdiff_t(halfWidths.size()); ++dy) {
        widenTo(halfWidths[std::size_t(dy)]);
        const Word *above = source - dy * m_words, *below = source + dy * m_words;
        for (std::ptrdiff_t i = 0; i < count; ++i)
            wide[i] |= above[i] | below[i];
    }
    widenTo(0);
    for (std::ptrdiff_t i = 0; i < count; ++i)
        result.m_bits[std::size_t(i)] = wide[i] ^ inverted;
    setSpare(result.m_bits.data(), 0);
    return result;
}

BitMask BitMask::dilated(int radius) const
{
    return spread(discRows(radius), 0, 0);
}

BitMask BitMask::eroded(int radius, bool isOutsideSet) const
{
    return spread(discRows(radius), ~Word(0), isOutsideSet ? 0 : ~Word(0));
}

BitMask BitMask::grown(int reach) const
{
    return spread(std::vector<int>(std::size_t(reach) + 1, reach), 0, 0);
}

BitMask BitMask::crowded() const
{
    BitMask result(m_width, m_height);
    const auto count = std::ptrdiff_t(m_bits.size()), stride = count + 2 * m_words;
    // three images with an empty row above and below
    Word *source = workingSpace(3 * stride) + m_words, *ones = source + stride, *twos = ones + stride;
    for (Word *image : {source, ones, twos}) {
        std::fill_n(image - m_words, m_words, 0);
        std::fill_n(image + count, m_words, 0);
    }
    std::ranges::copy(m_bits, source);
    // of each pixel and its neighbours in the row, their number in two bits
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const Word here = source[i], left = toTheRight(source + i), right = toTheLeft(source + i);
        ones[i] = left ^ here ^ right;
        twos[i] = (left & here) | (here & right) | (left & right);
    }
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const Word a1 = ones[i - m_words], b1 = ones[i], c1 = ones[i + m_words], a2 = twos[i - m_words],
                   b2 = twos[i], c2 = twos[i + m_words];
        const Word twoTwos = (a2 & b2) | (b2 & c2) | (a2 & c2);
        result.m_bits[std::size_t(i)] = twoTwos | ((a2 | b2 | c2) & (a1 | b1 | c1)) | (a1 & b1 & c1);
    }
    setSpare(result.m_bits.data(), 0);
    return result;
}

namespace {

/// The runs of a set, and for each another one of its part, which leads on to the part's first.
class LinkedRuns
{
public:
    /// touch: by how much runs of two rows may be apart in x; 1: at a corner.
    LinkedRuns(const BitMask &set, int touch)
    {
        m_runs.reserve(std::size_t(set.height()) * 4);
        m_leads.reserve(std::size_t(set.height()) * 4);
        std::size_t above = 0, here = 0; // first runs of the two rows
        for (int y = 0; y < set.height(); ++y) {
            above = here;
            here = m_runs.size();
            for (int x = set.nextSet(0, y); x < set.width(); x = set.nextSet(m_runs.back().x1, y)) {
                m_runs.push_back({y, x, set.nextClear(x, y)});
                m_leads.push_back(m_runs.size() - 1);
            }
            for (std::size_t a = above, b = here; a < here && b < m_runs.size();) {
                if (m_runs[a].x0 < m_runs[b].x1 + touch && m_runs[b].x0 < m_runs[a].x1 + touch)
                    join(a, b);
                (m_runs[a].x1 < m_runs[b].x1 ? a : b) += 1;
            }
        }
    }

    ConnectedParts parts()
    {
        // of each run its part's; of each part where its next run belongs
        std::vector<std::size_t> numbers(m_runs.size()), positions;
        for (std::size_t i = 0; i < m_runs.size(); ++i) {
            const std::size_t first = firstOf(i);
            numbers[i] = first == i ? positions.size() : numbers[first];
            if (first == i)
                positions.push_back(0);
            ++positions[numbers[i]];
        }
        std::exclusive_scan(positions.begin(), positions.end(), positions.begin(), std::size_t(0));
        std::vector<PixelRun> runs(m_runs.size());
        for (std::size_t i = 0; i < m_runs.size(); ++i)
            runs[positions[numbers[i]]++] = m_runs[i];
        return ConnectedParts(std::move(runs), positions);
    }

private:
    std::size_t firstOf(std::size_t run)
    {
        while (m_leads[run] != run)
            run = m_leads[run] = m_leads[m_leads[run]];
        return run;
    }
    void join(std::size_t a, std::size_t b)
    {
        const std::size_t firstOfA = firstOf(a), firstOfB = firstOf(b);
        m_leads[std::max(firstOfA, firstOfB)] = std::min(firstOfA, firstOfB);
    }

    std::vector<PixelRun> m_runs;
    std::vector<std::size_t> m_leads;
};

} // namespace

ConnectedParts::ConnectedParts(std::vector<PixelRun> runs, const std::vector<std::size_t> &ends)
    : m_runs(std::move(runs))
{
    m_parts.reserve(ends.size());
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
        m_parts.emplace_back(m_runs.data() + begin, end - begin);
        begin = end;
    }
}

ConnectedParts connectedParts(const BitMask &set)
{
    return LinkedRuns(set, 1).parts();
}

PixelRect boundsOf(const ConnectedPart &part)
{
    PixelRect box;
    for (const PixelRun &run : part)
        box = box.united({run.x0, run.y, run.x1, run.y + 1});
    return box;
}

bool contains(const ConnectedPart &part, int x, int y)
{
    return std::ranges::any_of(part,
                               [&](const PixelRun &run) { return run.y == y && run.x0 <= x && x < run.x1; });
}

bool enclosesAny(const ConnectedPart &part)
{
    // Where nothing is enclosed, the runs that touch those of the next row form a tree: there is one such
    // link less than runs.
    std::size_t links = 0, above = 0;
    for (const PixelRun &run : part) {
        const auto isPassed = [&](const PixelRun &one) {
            return one.y < run.y - 1 || (one.y == run.y - 1 && one.x1 < run.x0);
        };
        while (isPassed(part[above]))
            ++above;
        for (std::size_t i = above; part[i].y == run.y - 1 && part[i].x0 <= run.x1; ++i)
            ++links;
    }
    return links >= part.size();
}

BitMask withoutHoles(const BitMask &set)
{
    // What encloses pixels even where it only touches at a corner: around it the rest is connected by sides.
    const ConnectedParts rest = LinkedRuns(set.padded(1).complement(), 0).parts();
    if (rest.size() == 1)
        return set;
    BitMask filled = set;
    for (std::size_t i = 1; i < rest.size(); ++i) // the first is what lies outside
        for (const PixelRun &run : rest[i])
            filled.setRun(run.y - 1, run.x0 - 1, run.x1 - 1);
    return filled;
}

} // namespace odo
