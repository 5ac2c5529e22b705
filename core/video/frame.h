// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace odo {

/// Whole luma pixels from (x0, y0) up to, not including, (x1, y1).
struct PixelRect
{
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    bool isEmpty() const { return x1 <= x0 || y1 <= y0; }
    bool meets(const PixelRect &other) const
    {
        return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
    }
    bool contains(const PixelRect &other) const
    {
        return x0 <= other.x0 && other.x1 <= x1 && y0 <= other.y0 && other.y1 <= y1;
    }
    /// The smallest rectangle that holds both; an empty one adds nothing.
    PixelRect united(const PixelRect &other) const
    {
        if (isEmpty())
            return other;
        if (other.isEmpty())
            return *this;
        return {std::min(x0, other.x0), std::min(y0, other.y0), std::max(x1, other.x1),
                std::max(y1, other.y1)};
    }
    PixelRect clipped(const PixelRect &other) const
    {
        return {std::max(x0, other.x0), std::max(y0, other.y0), std::min(x1, other.x1),
                std::min(y1, other.y1)};
    }
};

/// Where a chroma sample lies among the luma samples it covers (H.273 §8.7). Left: MPEG-2 and H.264's
/// default; Center: MPEG-1 and JPEG; TopLeft: HEVC and DV. Those after Bottom occur in turned frames only.
enum class ChromaSiting {
    Unknown,
    Left,
    Center,
    TopLeft,
    Top,
    BottomLeft,
    Bottom,
    TopRight,
    Right,
    BottomRight
};

/// How luma and chroma were made from RGB.
enum class YuvMatrix { Bt601, Bt709, Bt2020 };

/// How light became code values (ITU-R BT.2100 for the last two). All that measures takes code values as they
/// are; only what is shown is mapped to those of an ordinary screen.
enum class Transfer { Standard, HybridLogGamma, PerceptualQuantizer };

/// A read-only look at one plane of bytes.
struct PlaneView
{
    const std::uint8_t *data = nullptr;
    int width = 0, height = 0;
    std::ptrdiff_t stride = 0; ///< bytes from one row to the next

    const std::uint8_t *row(int y) const { return data + y * stride; }
    std::uint8_t at(int x, int y) const { return data[y * stride + x]; }
};

/// What is common to all frames of a stream.
struct FrameFormat
{
    int width = 0, height = 0;              ///< of luma
    int chromaShiftX = 1, chromaShiftY = 1; ///< 4:2:0 is 1,1; 4:2:2 is 1,0; 4:4:4 is 0,0
    ChromaSiting siting = ChromaSiting::Unknown;
    YuvMatrix matrix = YuvMatrix::Bt601;
    bool fullRange = false; ///< false: luma 16–235, chroma 16–240
    Transfer transfer = Transfer::Standard;

    int chromaWidth() const { return (width + (1 << chromaShiftX) - 1) >> chromaShiftX; }
    int chromaHeight() const { return (height + (1 << chromaShiftY) - 1) >> chromaShiftY; }
    /// Luma pixel coordinates of the chroma sample (cx, cy): x = (cx << shift) + chromaOffsetX(). Unknown
    /// siting is treated as Left where chroma is halved (the default of H.264 and MPEG-2).
    double chromaOffsetX() const;
    double chromaOffsetY() const;
};

/// Whether samples of both have the same positions and meaning, except for the chroma siting.
bool sameLayout(const FrameFormat &a, const FrameFormat &b);

struct Frame;

/// A frame as it was coded, kept so that more of it can be decoded later. Any thread.
class CodedImage
{
public:
    virtual ~CodedImage() = default;
    /// All of it. InvalidInput when its data are damaged.
    virtual Result<Frame> decodeWhole() const = 0;
};

/// One frame as planes of 8 bits, exactly as the decoder or camera gave it. A value that is cheap to copy:
/// copies share the immutable memory, which `owner` keeps alive. Safe to pass between threads.
struct Frame
{
    FrameFormat format;
    PlaneView y, u, v;
    std::int64_t index = 0; ///< 0-based index in its recording
    Nanoseconds time{0}; ///< since the recording's first frame, from the file's time stamps (or the device's)
    std::shared_ptr<const void> owner;
    /// Set when only a part was decoded: samples outside it are of no meaning, wholeFrame() gives the rest.
    std::optional<PixelRect> validRegion;
    std::shared_ptr<const CodedImage> coded; ///< set together with validRegion
    /// How its file said that it is to be turned (1 to 8, as EXIF numbers it), which has been done
    /// (frame_turn.h).
    int orientation = 1;
};

/// The same frame (index and time as here), fully decoded; itself when it already is.
Result<Frame> wholeFrame(const Frame &frame);

/// Owns the memory of a frame that is filled by us (simulator, converters).
class FrameBuffer
{
public:
    explicit FrameBuffer(const FrameFormat &format);
    std::uint8_t *yRow(int row) { return m_y.data() + static_cast<std::ptrdiff_t>(row) * m_format.width; }
    std::uint8_t *uRow(int row) { return m_u.data() + static_cast<std::ptrdiff_t>(row) * m_chromaWidth; }
    std::uint8_t *vRow(int row) { return m_v.data() + static_cast<std::ptrdiff_t>(row) * m_chromaWidth; }
    int chromaWidth() const { return m_chromaWidth; }
    int chromaHeight() const { return m_format.chromaHeight(); }

    /// Hands the memory over to an immutable Frame.
    static Frame toFrame(std::shared_ptr<FrameBuffer> buffer, std::int64_t index, Nanoseconds time);

private:
    FrameFormat m_format;
    int m_chromaWidth;
    std::vector<std::uint8_t> m_y, m_u, m_v;
};

/// Memory for the planes of frames, used again once the last share in it is gone: memory fresh from the
/// system costs a page fault every 4096 bytes, a tenth of what decoding a JPEG frame does. Any thread; what
/// was taken may outlive the pool.
class PlanePool
{
public:
    explicit PlanePool(std::size_t bytes);
    /// As many bytes as given to the constructor; their content is undefined.
    std::shared_ptr<std::uint8_t[]> take() const;

private:
    struct Shelf;
    std::shared_ptr<Shelf> m_shelf;
};

/// Frames of one format to be filled, from memory that is used again. Any thread.
class FramePool
{
public:
    explicit FramePool(const FrameFormat &format);
    const FrameFormat &format() const { return m_format; }

    struct Blank
    {
        Frame frame; ///< its planes are those below; index and time are 0
        std::uint8_t *y = nullptr, *u = nullptr, *v = nullptr; ///< rows without padding
    };
    /// A frame whose samples are undefined; to be filled before the frame is passed on.
    Blank take() const;

private:
    FrameFormat m_format;
    PlanePool m_pool;
};

} // namespace odo
