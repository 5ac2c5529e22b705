// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/video_encoder.h"

#include "core/base/shortage.h"

#include <cstring>

namespace odo {

namespace {

Message cannotEncode()
{
    return ODO_TEXT("video.cannot_encode", "cannot encode the video");
}

AVPixelFormat pixelFormatFor(const FrameFormat &format, bool jpegNames)
{
    const int shifts = format.chromaShiftX * 10 + format.chromaShiftY;
    switch (shifts) {
    case 11:
        return jpegNames ? AV_PIX_FMT_YUVJ420P : AV_PIX_FMT_YUV420P;
    case 10:
        return jpegNames ? AV_PIX_FMT_YUVJ422P : AV_PIX_FMT_YUV422P;
    case 0:
        return jpegNames ? AV_PIX_FMT_YUVJ444P : AV_PIX_FMT_YUV444P;
    default:
        return AV_PIX_FMT_NONE;
    }
}

const AVCodec *findEncoder(VideoCodec codec)
{
    switch (codec) {
    case VideoCodec::H264:
        return avcodec_find_encoder_by_name("libx264");
    case VideoCodec::Mjpeg:
        return avcodec_find_encoder(AV_CODEC_ID_MJPEG);
    case VideoCodec::Ffv1:
        return avcodec_find_encoder(AV_CODEC_ID_FFV1);
    }
    return nullptr;
}

AVChromaLocation locationOf(ChromaSiting siting)
{
    switch (siting) {
    case ChromaSiting::Left:
        return AVCHROMA_LOC_LEFT;
    case ChromaSiting::Center:
        return AVCHROMA_LOC_CENTER;
    case ChromaSiting::TopLeft:
        return AVCHROMA_LOC_TOPLEFT;
    case ChromaSiting::Top:
        return AVCHROMA_LOC_TOP;
    case ChromaSiting::BottomLeft:
        return AVCHROMA_LOC_BOTTOMLEFT;
    case ChromaSiting::Bottom:
        return AVCHROMA_LOC_BOTTOM;
    default: // no container has a word for it
        return AVCHROMA_LOC_UNSPECIFIED;
    }
}

Result<void> checkFormat(const FrameFormat &format, VideoCodec codec)
{
    if (format.width <= 0 || format.height <= 0 || pixelFormatFor(format, false) == AV_PIX_FMT_NONE)
        return fail(
            ErrorCode::InvalidInput, cannotEncode(),
            ODO_TEXT("video.frames_not_encodable", "frames of this size or chroma format cannot be encoded"),
            ODO_TEXT("video.use_other_chroma", "use 4:2:0, 4:2:2 or 4:4:4"));
    const bool odd = (format.chromaShiftX == 1 && format.width % 2 != 0) ||
                     (format.chromaShiftY == 1 && format.height % 2 != 0);
    if (codec == VideoCodec::H264 && odd)
        return fail(ErrorCode::InvalidInput, cannotEncode(),
                    ODO_TEXT("video.h264_needs_even", "H.264 needs an even width and height, not %1")(
                        std::to_string(format.width) + "x" + std::to_string(format.height)),
                    ODO_TEXT("video.use_mjpeg", "use MJPEG or FFV1, or another size"));
    return {};
}

void describeColour(const FrameFormat &format, AVCodecContext &encoder)
{
    encoder.color_range = format.fullRange ? AVCOL_RANGE_JPEG : AVCOL_RANGE_MPEG;
    encoder.colorspace = libav::colourSpaceOf(format.matrix);
    encoder.chroma_sample_location = locationOf(format.siting);
}

void setRate(const VideoWriterOptions &options, AVCodecContext &encoder, libav::Options &codecOptions)
{
    switch (options.codec) {
    case VideoCodec::H264:
        encoder.bit_rate = options.bitRate;
        encoder.max_b_frames = options.maxBFrames;
        // Coded as cameras do, by arithmetic and with softened edges of blocks, but searched as little as can
        // be: at these bit rates all that "veryfast" finds is half a decibel, in three times the time.
        codecOptions.set("preset", "ultrafast");
        codecOptions.set("coder", "ac");
        codecOptions.set("x264-params", "deblock=0,0");
        break;
    case VideoCodec::Mjpeg:
        encoder.flags |= AV_CODEC_FLAG_QSCALE;
        encoder.global_quality = FF_QP2LAMBDA * options.mjpegQuality;
        encoder.qmin = encoder.qmax = options.mjpegQuality;
        encoder.strict_std_compliance =
            FF_COMPLIANCE_UNOFFICIAL; // allows limited range, which is written down
        break;
    case VideoCodec::Ffv1:
        encoder.gop_size = 1;
        encoder.level = 3;
        codecOptions.set("slicecrc", 1);
        break;
    }
}

void copyPlane(const PlaneView &plane, std::uint8_t *to, int stride)
{
    for (int y = 0; y < plane.height; ++y)
        std::memcpy(to + static_cast<std::ptrdiff_t>(y) * stride, plane.row(y),
                    static_cast<std::size_t>(plane.width));
}

} // namespace

Result<libav::CodecPtr> openEncoder(const FrameFormat &format, const VideoWriterOptions &options,
                                    bool globalHeader)
{
    ODO_TRY(checkFormat(format, options.codec));
    const AVCodec *codec = findEncoder(options.codec);
    if (!codec)
        return fail(ErrorCode::Internal, cannotEncode(),
                    ODO_TEXT("video.no_encoder", "the installed libavcodec has no encoder for it"),
                    ODO_TEXT("video.install_libx264", "install Debian's libavcodec with libx264"));
    libav::CodecPtr encoder(libav::allocated(avcodec_alloc_context3(codec)));
    encoder->width = format.width;
    encoder->height = format.height;
    encoder->time_base = encodingTimeBase;
    encoder->framerate = av_d2q(options.nominalFramesPerSecond, 100'000);
    encoder->pix_fmt = pixelFormatFor(format, options.codec == VideoCodec::Mjpeg && format.fullRange);
    encoder->thread_count = options.threads;
    encoder->flags |= AV_CODEC_FLAG_BITEXACT | (globalHeader ? AV_CODEC_FLAG_GLOBAL_HEADER : 0);
    describeColour(format, *encoder);
    libav::Options codecOptions;
    setRate(options, *encoder, codecOptions);
    if (const int error = avcodec_open2(encoder.get(), codec, codecOptions.get()); error < 0)
        return fail(
            ErrorCode::InvalidInput, cannotEncode(),
            ODO_TEXT("video.encoder_not_started",
                     "the encoder did not start (%1)")(foreignWords(libav::errorText(error))),
            ODO_TEXT("video.check_what_was_asked", "check the requested size, frame rate and quality"));
    return encoder;
}

Result<EncodedStream> describeStream(const AVCodecContext &encoder, const FrameFormat &format)
{
    EncodedStream stream;
    stream.parameters.reset(libav::allocated(avcodec_parameters_alloc()));
    avcodec_parameters_from_context(stream.parameters.get(), &encoder);
    if (encoder.codec_id != AV_CODEC_ID_H264 || format.siting != ChromaSiting::Left ||
        format.chromaShiftY != 1)
        return stream;
    AVBSFContext *filter = nullptr;
    int error = av_bsf_alloc(av_bsf_get_by_name("h264_metadata"), &filter);
    if (error >= 0) {
        stream.filter.reset(filter);
        avcodec_parameters_copy(filter->par_in, stream.parameters.get());
        filter->time_base_in = encodingTimeBase;
        av_opt_set_int(filter->priv_data, "chroma_sample_loc_type", 0, 0);
        error = av_bsf_init(filter);
    }
    if (error < 0)
        return fail(ErrorCode::Internal, cannotEncode(),
                    ODO_TEXT("video.siting_not_set", "the chroma siting could not be set (%1)")(
                        foreignWords(libav::errorText(error))),
                    ODO_TEXT("video.install_libavcodec", "install Debian's libavcodec"));
    avcodec_parameters_copy(stream.parameters.get(), filter->par_out);
    return stream;
}

Result<libav::FramePtr> avFrameOf(const Frame &frame, const AVCodecContext &encoder, std::int64_t timeUs)
{
    libav::FramePtr avFrame(libav::allocated(av_frame_alloc()));
    avFrame->format = encoder.pix_fmt;
    avFrame->width = encoder.width;
    avFrame->height = encoder.height;
    avFrame->pts = timeUs;
    avFrame->color_range = encoder.color_range;
    avFrame->colorspace = encoder.colorspace;
    avFrame->chroma_location = encoder.chroma_sample_location;
    if (encoder.codec_id == AV_CODEC_ID_MJPEG)
        avFrame->quality = encoder.global_quality;
    if (const int error = av_frame_get_buffer(avFrame.get(), 0); error < 0)
        return fail(ErrorCode::Internal, cannotEncode(), foreignWords(libav::errorText(error)),
                    closeOtherPrograms());
    copyPlane(frame.y, avFrame->data[0], avFrame->linesize[0]);
    copyPlane(frame.u, avFrame->data[1], avFrame->linesize[1]);
    copyPlane(frame.v, avFrame->data[2], avFrame->linesize[2]);
    return avFrame;
}

} // namespace odo
