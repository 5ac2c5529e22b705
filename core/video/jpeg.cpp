// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/jpeg.h"

#include "core/video/frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <jerror.h>
#include <jpeglib.h>
#include <mutex>
#include <optional>
#include <turbojpeg.h>
#include <vector>

namespace odo {

namespace {

constexpr int mostBlockPixels =
    MAX_SAMP_FACTOR * DCTSIZE; ///< side of the largest unit that is coded together
constexpr double mostRegionShare =
    0.5;                           ///< of the image; more is decoded as a whole, without a detour over pixels
constexpr int mostExtraBytes = 64; ///< between the coded image and its end; cameras pad it

/// What libjpeg calls when something is wrong. It may not return from an error, and no exception may pass
/// through its C code, so errors jump.
struct Complaints
{
    jpeg_error_mgr base{}; ///< first, because libjpeg hands out its address
    std::jmp_buf escape{};
    bool damaged = false;

    static Complaints &of(j_common_ptr decoder) { return *reinterpret_cast<Complaints *>(decoder->err); }
    [[noreturn]] static void onError(j_common_ptr decoder) { std::longjmp(of(decoder).escape, 1); }
    static void onMessage(j_common_ptr decoder, int level)
    {
        if (level >= 0)
            return; // a trace
        const jpeg_error_mgr &error = *decoder->err;
        const bool lost = error.msg_code == JWRN_HIT_MARKER || error.msg_code == JWRN_HUFF_BAD_CODE ||
                          error.msg_code == JWRN_MUST_RESYNC;
        const bool leftOver = error.msg_code == JWRN_EXTRANEOUS_DATA && error.msg_parm.i[0] > mostExtraBytes;
        of(decoder).damaged |= lost || leftOver;
    }
    static void ignore(j_common_ptr) {}
};

int roundedUp(int value, int unit)
{
    return (value + unit - 1) / unit * unit;
}

/// Memory of one plane, with room for whole units of what is coded together.
struct PlaneMemory
{
    int width = 0, height = 0;
    std::ptrdiff_t stride = 0;
    std::size_t offset = 0;
};

} // namespace

struct JpegDecoder::Impl
{
    explicit Impl(const FrameFormat &imageFormat);
    ~Impl() { jpeg_destroy_decompress(&decoder); }

    bool isSuitable() const;
    void decodeWhole(std::uint8_t *memory);
    void decodeRegion(std::uint8_t *memory, const PixelRect &region);
    void takeApart(const std::uint8_t *pixels, int y, const PixelRect &region, std::uint8_t *memory) const;
    Outcome run(std::span<const std::uint8_t> coded, std::uint8_t *memory, std::optional<PixelRect> &region);
    std::optional<PixelRect> worthwhile(const PixelRect &region) const;

    const FrameFormat format;
    std::array<PlaneMemory, 3> planes;
    std::unique_ptr<PlanePool> pool;
    std::vector<std::uint8_t> line; ///< of pixels of three bytes
    std::mutex mutex;
    Complaints complaints;
    jpeg_decompress_struct decoder{};
};

JpegDecoder::Impl::Impl(const FrameFormat &imageFormat) : format(imageFormat)
{
    std::size_t bytes = 0;
    for (std::size_t p = 0; p < planes.size(); ++p) {
        const int shiftX = p == 0 ? 0 : format.chromaShiftX, shiftY = p == 0 ? 0 : format.chromaShiftY;
        planes[p].width = (format.width + (1 << shiftX) - 1) >> shiftX;
        planes[p].height = (format.height + (1 << shiftY) - 1) >> shiftY;
        planes[p].stride = roundedUp(format.width, mostBlockPixels) >> shiftX;
        planes[p].offset = bytes;
        bytes += static_cast<std::size_t>(planes[p].stride) *
                 static_cast<std::size_t>(roundedUp(format.height, mostBlockPixels) >> shiftY);
    }
    pool = std::make_unique<PlanePool>(bytes);
    line.resize(3 * static_cast<std::size_t>(roundedUp(format.width, mostBlockPixels)));

    decoder.err = jpeg_std_error(&complaints.base);
    complaints.base.error_exit = &Complaints::onError;
    complaints.base.emit_message = &Complaints::onMessage;
    complaints.base.output_message = &Complaints::ignore;
    jpeg_create_decompress(&decoder); // fails only when libjpeg is not the one it was built for
}

/// Whether the image whose header was read is of the stream's format, and coded in one pass of Huffman
/// codes.
bool JpegDecoder::Impl::isSuitable() const
{
    const jpeg_decompress_struct &d = decoder;
    if (static_cast<int>(d.image_width) != format.width ||
        static_cast<int>(d.image_height) != format.height || d.num_components != 3 || d.data_precision != 8 ||
        d.jpeg_color_space != JCS_YCbCr || d.arith_code || d.progressive_mode ||
        d.comps_in_scan != d.num_components)
        return false;
    const jpeg_component_info *c = d.comp_info;
    const auto isDivided = [](int luma, int chroma, int shift) { return luma == chroma << shift; };
    return isDivided(c[0].h_samp_factor, c[1].h_samp_factor, format.chromaShiftX) &&
           isDivided(c[0].v_samp_factor, c[1].v_samp_factor, format.chromaShiftY) &&
           c[1].h_samp_factor == c[2].h_samp_factor && c[1].v_samp_factor == c[2].v_samp_factor;
}

void JpegDecoder::Impl::decodeWhole(std::uint8_t *memory)
{
    decoder.raw_data_out = TRUE;
    jpeg_start_decompress(&decoder);
    std::array<std::array<JSAMPROW, mostBlockPixels>, 3> rows{};
    std::array<JSAMPARRAY, 3> image{rows[0].data(), rows[1].data(), rows[2].data()};
    const int unitRows = decoder.max_v_samp_factor * DCTSIZE;
    while (decoder.output_scanline < decoder.output_height) {
        for (std::size_t p = 0; p < rows.size(); ++p) {
            const int count = decoder.comp_info[p].v_samp_factor * DCTSIZE;
            const int first = static_cast<int>(decoder.output_scanline) / decoder.max_v_samp_factor *
                              decoder.comp_info[p].v_samp_factor;
            for (int row = 0; row < count; ++row)
                rows[p][static_cast<std::size_t>(row)] =
                    memory + planes[p].offset + (first + row) * planes[p].stride;
        }
        jpeg_read_raw_data(&decoder, image.data(), static_cast<JDIMENSION>(unitRows));
    }
    jpeg_finish_decompress(&decoder);
}

/// The region grown to whole coding units (those at the right and at the bottom may be
/// cut); none when it costs less to decode the whole image, or when it is empty.
std::optional<PixelRect> JpegDecoder::Impl::worthwhile(const PixelRect &region) const
{
    const int unitX = decoder.max_h_samp_factor * DCTSIZE, unitY = decoder.max_v_samp_factor * DCTSIZE;
    const PixelRect bounds{0, 0, format.width, format.height};
    const PixelRect inside = region.clipped(bounds);
    if (inside.isEmpty())
        return std::nullopt;
    const PixelRect grown = PixelRect{inside.x0 / unitX * unitX, inside.y0 / unitY * unitY,
                                      roundedUp(inside.x1, unitX), roundedUp(inside.y1, unitY)}
                                .clipped(bounds);
    const double share = static_cast<double>(grown.width()) * grown.height() /
                         (static_cast<double>(bounds.width()) * bounds.height());
    return share > mostRegionShare ? std::nullopt : std::optional(grown);
}

void JpegDecoder::Impl::decodeRegion(std::uint8_t *memory, const PixelRect &region)
{
    // Chroma is repeated for every pixel here (not interpolated), so that taking one of the pixels gives the
    // sample.
    decoder.raw_data_out = FALSE;
    jpeg_start_decompress(&decoder);
    auto left = static_cast<JDIMENSION>(region.x0), width = static_cast<JDIMENSION>(region.width());
    jpeg_crop_scanline(&decoder, &left, &width);
    jpeg_skip_scanlines(&decoder, static_cast<JDIMENSION>(region.y0));
    JSAMPROW row = line.data();
    for (int y = region.y0; y < region.y1; ++y) {
        jpeg_read_scanlines(&decoder, &row, 1);
        takeApart(line.data(), y, region, memory);
    }
    jpeg_abort_decompress(&decoder);
}

void JpegDecoder::Impl::takeApart(const std::uint8_t *pixels, int y, const PixelRect &region,
                                  std::uint8_t *memory) const
{
    const auto rowOf = [&](std::size_t p, int plainRow) {
        return memory + planes[p].offset + plainRow * planes[p].stride;
    };
    std::uint8_t *luma = rowOf(0, y) + region.x0;
    for (int x = 0; x < region.width(); ++x)
        luma[x] = pixels[3 * x];
    if ((y & ((1 << format.chromaShiftY) - 1)) != 0)
        return;
    std::uint8_t *u = rowOf(1, y >> format.chromaShiftY) + (region.x0 >> format.chromaShiftX);
    std::uint8_t *v = rowOf(2, y >> format.chromaShiftY) + (region.x0 >> format.chromaShiftX);
    const int step = 1 << format.chromaShiftX;
    for (int x = 0; x < region.width(); x += step, pixels += 3 * step) {
        *u++ = pixels[1];
        *v++ = pixels[2];
    }
}

/// No object that would have to be destroyed may be made in here: an error leaves by a jump.
JpegDecoder::Outcome JpegDecoder::Impl::run(std::span<const std::uint8_t> coded, std::uint8_t *memory,
                                            std::optional<PixelRect> &region)
{
    complaints.damaged = false;
    if (setjmp(complaints.escape) != 0) {
        jpeg_abort_decompress(&decoder);
        return Outcome::Damaged;
    }
    jpeg_mem_src(&decoder, coded.data(), coded.size());
    jpeg_read_header(&decoder, TRUE);
    if (!isSuitable()) {
        jpeg_abort_decompress(&decoder);
        return Outcome::NotSuitable;
    }
    decoder.out_color_space = JCS_YCbCr;
    decoder.dct_method = JDCT_ISLOW;
    decoder.do_fancy_upsampling = FALSE;
    if (region)
        region = worthwhile(*region);
    if (region)
        decodeRegion(memory, *region);
    else
        decodeWhole(memory);
    return complaints.damaged ? Outcome::Damaged : Outcome::Decoded;
}

JpegDecoder::JpegDecoder(const FrameFormat &format) : m_impl(std::make_unique<Impl>(format)) {}
JpegDecoder::~JpegDecoder() = default;

JpegDecoder::Outcome JpegDecoder::decode(std::span<const std::uint8_t> coded,
                                         const std::optional<PixelRect> &region, Frame &frame)
{
    Impl &d = *m_impl;
    const std::lock_guard lock(d.mutex);
    const std::shared_ptr<std::uint8_t[]> memory = d.pool->take();
    std::optional<PixelRect> decoded = region;
    const Outcome outcome = d.run(coded, memory.get(), decoded);
    if (outcome != Outcome::Decoded)
        return outcome;
    const auto view = [&](const PlaneMemory &plane) {
        return PlaneView{memory.get() + plane.offset, plane.width, plane.height, plane.stride};
    };
    frame.format = d.format;
    frame.y = view(d.planes[0]);
    frame.u = view(d.planes[1]);
    frame.v = view(d.planes[2]);
    frame.owner = memory;
    frame.validRegion = decoded;
    return outcome;
}

namespace {

using Stretch = std::array<std::uint8_t, 256>;

/// From a limited range (H.273: luma 16 to 235, chroma 16 to 240) to the full one.
Stretch stretchOf(double zero, double span, double zeroAfter, double spanAfter)
{
    Stretch stretch{};
    for (int value = 0; value < 256; ++value) {
        const double full = zeroAfter + (value - zero) * spanAfter / span;
        stretch[static_cast<std::size_t>(value)] =
            static_cast<std::uint8_t>(std::clamp(std::lround(full), 0L, 255L));
    }
    return stretch;
}

const Stretch lumaStretch = stretchOf(16, 219, 0, 255), chromaStretch = stretchOf(128, 224, 128, 255);

std::optional<TJSAMP> samplingOf(const FrameFormat &format)
{
    switch (format.chromaShiftX * 2 + format.chromaShiftY) {
    case 0:
        return TJSAMP_444;
    case 1:
        return TJSAMP_440;
    case 2:
        return TJSAMP_422;
    case 3:
        return TJSAMP_420;
    default:
        return std::nullopt;
    }
}

} // namespace

struct JpegEncoder::Impl
{
    int quality = 0;
    tjhandle handle = tjInitCompress();
    std::array<std::vector<std::uint8_t>, 3> stretched;
    std::vector<std::uint8_t> coded;

    PlaneView fullRange(const PlaneView &plane, int index);
};

/// A copy of the plane, stretched.
PlaneView JpegEncoder::Impl::fullRange(const PlaneView &plane, int index)
{
    const Stretch &stretch = index == 0 ? lumaStretch : chromaStretch;
    std::vector<std::uint8_t> &copy = stretched[static_cast<std::size_t>(index)];
    copy.resize(static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height));
    for (int y = 0; y < plane.height; ++y)
        std::transform(plane.row(y), plane.row(y) + plane.width,
                       copy.begin() + static_cast<std::ptrdiff_t>(y) * plane.width,
                       [&](std::uint8_t value) { return stretch[value]; });
    return {copy.data(), plane.width, plane.height, plane.width};
}

JpegEncoder::JpegEncoder(int quality) : m_impl(std::make_unique<Impl>())
{
    m_impl->quality = quality;
}

JpegEncoder::~JpegEncoder()
{
    tjDestroy(m_impl->handle);
}

namespace {

tl::unexpected<Error> notCoded(ErrorCode code, Message why)
{
    return fail(code, ODO_TEXT("video.picture_not_coded", "a frame cannot be encoded"), std::move(why),
                ODO_TEXT("video.give_another_format", "set the camera to another format"));
}

} // namespace

Result<std::vector<std::uint8_t>> JpegEncoder::encode(const Frame &frame)
{
    const FrameFormat &format = frame.format;
    const auto sampling = samplingOf(format);
    if (!sampling)
        return notCoded(ErrorCode::InvalidInput,
                        ODO_TEXT("video.no_jpeg_layout", "JPEG does not support its colour layout"));
    std::array<PlaneView, 3> planes{frame.y, frame.u, frame.v};
    if (!format.fullRange) {
        for (int i = 0; i < 3; ++i)
            planes[static_cast<std::size_t>(i)] = m_impl->fullRange(planes[static_cast<std::size_t>(i)], i);
    }
    const unsigned char *rows[3] = {planes[0].data, planes[1].data, planes[2].data};
    const int strides[3] = {static_cast<int>(planes[0].stride), static_cast<int>(planes[1].stride),
                            static_cast<int>(planes[2].stride)};
    std::vector<std::uint8_t> &coded = m_impl->coded;
    coded.resize(tjBufSize(format.width, format.height, *sampling));
    unsigned char *buffer = coded.data();
    unsigned long size = coded.size();
    if (tjCompressFromYUVPlanes(m_impl->handle, rows, format.width, strides, format.height, *sampling,
                                &buffer, &size, m_impl->quality, TJFLAG_NOREALLOC) != 0)
        return notCoded(ErrorCode::Internal, foreignWords(tjGetErrorStr2(m_impl->handle)));
    return std::vector<std::uint8_t>(coded.begin(), coded.begin() + static_cast<std::ptrdiff_t>(size));
}

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint8_t startOfImage = 0xd8, startOfScan = 0xda, huffmanTables = 0xc4, arithmeticTables = 0xcc,
                       jpegExtension = 0xc8;

struct Segment
{
    std::uint8_t marker = 0;
    std::size_t begin = 0; ///< of its marker in the file
    Bytes content;         ///< without marker and length
};

/// The segments before the coded image, the start of the scan being the last; nothing where they do not
/// lead there.
std::vector<Segment> segmentsOf(Bytes jpeg)
{
    std::vector<Segment> segments;
    if (jpeg.size() < 4 || jpeg[0] != 0xff || jpeg[1] != startOfImage)
        return {};
    for (std::size_t at = 2; at + 4 <= jpeg.size();) {
        if (jpeg[at] != 0xff)
            return {};
        if (jpeg[at + 1] == 0xff) { // a byte that fills
            ++at;
            continue;
        }
        const std::size_t length = static_cast<std::size_t>(jpeg[at + 2] << 8 | jpeg[at + 3]);
        if (length < 2 || at + 2 + length > jpeg.size())
            return {};
        segments.push_back({jpeg[at + 1], at, jpeg.subspan(at + 4, length - 2)});
        if (segments.back().marker == startOfScan)
            return segments;
        at += 2 + length;
    }
    return {};
}

bool isFrameHeader(std::uint8_t marker)
{
    return marker >= 0xc0 && marker <= 0xcf && marker != huffmanTables && marker != jpegExtension &&
           marker != arithmeticTables;
}

/// Of luma's samples to chroma's; nullopt unless it is a power of two.
std::optional<int> shiftBetween(int luma, int chroma)
{
    if (chroma == 0 || luma % chroma != 0 || !std::has_single_bit(static_cast<unsigned>(luma / chroma)))
        return std::nullopt;
    return std::countr_zero(static_cast<unsigned>(luma / chroma));
}

std::optional<FrameFormat> formatOf(Bytes header)
{
    if (header.size() < 15 || header[5] != 3 || header[10] != header[13])
        return std::nullopt;
    FrameFormat format;
    format.height = header[1] << 8 | header[2];
    format.width = header[3] << 8 | header[4];
    const auto shiftX = shiftBetween(header[7] >> 4, header[10] >> 4),
               shiftY = shiftBetween(header[7] & 15, header[10] & 15);
    if (format.width == 0 || format.height == 0 || !shiftX || !shiftY)
        return std::nullopt;
    format.chromaShiftX = *shiftX;
    format.chromaShiftY = *shiftY;
    format.siting = ChromaSiting::Center;
    format.fullRange = true;
    return format;
}

void append(std::vector<std::uint8_t> &segment, int frameNumber, const JHUFF_TBL &table)
{
    segment.push_back(static_cast<std::uint8_t>(frameNumber));
    std::size_t values = 0;
    for (std::size_t length = 1; length <= 16; ++length) {
        segment.push_back(table.bits[length]);
        values += table.bits[length];
    }
    segment.insert(segment.end(), table.huffval, table.huffval + values);
}

/// What libjpeg sets by itself for an encoder are the tables of Annex K.3.
std::vector<std::uint8_t> standardTables()
{
    jpeg_error_mgr errors{};
    jpeg_compress_struct encoder{};
    encoder.err = jpeg_std_error(&errors);
    jpeg_create_compress(&encoder);
    encoder.in_color_space = JCS_YCbCr;
    encoder.input_components = 3;
    jpeg_set_defaults(&encoder);
    std::vector<std::uint8_t> segment{0xff, huffmanTables, 0, 0};
    for (int i = 0; i < 2; ++i) {
        append(segment, i, *encoder.dc_huff_tbl_ptrs[i]);
        append(segment, 0x10 | i, *encoder.ac_huff_tbl_ptrs[i]);
    }
    jpeg_destroy_compress(&encoder);
    const std::size_t length = segment.size() - 2;
    segment[2] = static_cast<std::uint8_t>(length >> 8);
    segment[3] = static_cast<std::uint8_t>(length & 0xff);
    return segment;
}

} // namespace

std::optional<FrameFormat> jpegFormat(Bytes jpeg)
{
    for (const Segment &segment : segmentsOf(jpeg)) {
        if (isFrameHeader(segment.marker))
            return formatOf(segment.content);
    }
    return std::nullopt;
}

std::vector<std::uint8_t> withHuffmanTables(Bytes jpeg)
{
    const std::vector<Segment> segments = segmentsOf(jpeg);
    bool missing = !segments.empty();
    for (const Segment &segment : segments)
        missing = missing && segment.marker != huffmanTables;
    if (!missing)
        return {jpeg.begin(), jpeg.end()};
    static const std::vector<std::uint8_t> tables = standardTables();
    const auto scan = jpeg.begin() + static_cast<std::ptrdiff_t>(segments.back().begin);
    std::vector<std::uint8_t> whole;
    whole.reserve(jpeg.size() + tables.size());
    whole.insert(whole.end(), jpeg.begin(), scan);
    whole.insert(whole.end(), tables.begin(), tables.end());
    whole.insert(whole.end(), scan, jpeg.end());
    return whole;
}

} // namespace odo
