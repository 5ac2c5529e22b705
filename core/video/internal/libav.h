// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"
#include "core/video/frame.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
extern "C" {
#include <libavcodec/avcodec.h>
#include <libavcodec/bsf.h>
#include <libavformat/avformat.h>
#include <libavutil/common.h>
#include <libavutil/opt.h>
}

/// Owners for the things of libav. Private to core/video: no public header includes this one.

namespace odo::libav {

/// Of a frame that is read. libapriltag ends the program at a side of 32,768 pixels, OpenCV remaps none of
/// 32,767.
constexpr std::int64_t mostPixels = 100'000'000, longestSide = 32'000;

constexpr bool isTooLarge(std::int64_t width, std::int64_t height)
{
    return width > longestSide || height > longestSide || width * height > mostPixels;
}

struct Delete
{
    void operator()(AVFrame *frame) const { av_frame_free(&frame); }
    void operator()(AVPacket *packet) const { av_packet_free(&packet); }
    void operator()(AVCodecContext *codec) const { avcodec_free_context(&codec); }
    void operator()(AVBSFContext *filter) const { av_bsf_free(&filter); }
    void operator()(AVCodecParameters *parameters) const { avcodec_parameters_free(&parameters); }
};

using FramePtr = std::unique_ptr<AVFrame, Delete>;
using PacketPtr = std::unique_ptr<AVPacket, Delete>;
using CodecPtr = std::unique_ptr<AVCodecContext, Delete>;
using FilterPtr = std::unique_ptr<AVBSFContext, Delete>;
using ParametersPtr = std::unique_ptr<AVCodecParameters, Delete>;

/// What libav has allocated; std::bad_alloc where it could not.
template <class Allocated>
Allocated *allocated(Allocated *memory)
{
    if (!memory)
        throw std::bad_alloc();
    return memory;
}

/// An answer of libav as it is; std::bad_alloc where memory, std::system_error where open files ran out.
int checked(int answer);

/// An options dictionary that frees what libav left in it.
class Options
{
public:
    ~Options() { av_dict_free(&m_options); }
    Options() = default;
    Options(const Options &) = delete;
    Options &operator=(const Options &) = delete;
    void set(const char *name, const char *value) { av_dict_set(&m_options, name, value, 0); }
    void set(const char *name, int value) { av_dict_set_int(&m_options, name, value, 0); }
    AVDictionary **get() { return &m_options; }

private:
    AVDictionary *m_options = nullptr;
};

/// What a file states of its colours as one of the numbers that libav has names for; any other, which to read
/// as an enumeration would be undefined, becomes "not stated".
void forgetUnknownColours(AVCodecParameters &parameters);

/// What libav calls the matrix of frames.
AVColorSpace colourSpaceOf(YuvMatrix matrix);

/// libav's words for one of its error numbers.
std::string errorText(int error);

/// Sends libav's own log to nowhere; what matters to the user comes as an Error. Done once, from any thread.
void quieten();

} // namespace odo::libav

namespace odo {

/// Messages used in several files of this folder.
Message cannotOpenVideo(const std::filesystem::path &file);
Message dataAreDamaged();
Message writingFailedBefore();
Message copyFromCamera();
Message convertToH264();

} // namespace odo
