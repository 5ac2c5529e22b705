// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/video/internal/libav.h"
#include "core/video/video_writer.h"

namespace odo {

/// Time base of everything that is encoded: microseconds.
constexpr AVRational encodingTimeBase{1, 1'000'000};

/// An encoder for frames of this format, opened, its colour description set. Errors: a format that the codec
/// cannot take; an encoder that is missing from the installed libav.
Result<libav::CodecPtr> openEncoder(const FrameFormat &format, const VideoWriterOptions &options,
                                    bool globalHeader);

/// The parameters that go into the container, with a filter that writes the chroma siting into an H.264
/// stream where x264 leaves it out (it never writes "left", so a reader could not distinguish it from "not
/// known"). The filter may be null.
struct EncodedStream
{
    libav::ParametersPtr parameters;
    libav::FilterPtr filter;
};
Result<EncodedStream> describeStream(const AVCodecContext &encoder, const FrameFormat &format);

/// A frame as libav's, its planes copied.
Result<libav::FramePtr> avFrameOf(const Frame &frame, const AVCodecContext &encoder, std::int64_t timeUs);

} // namespace odo
