// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/image_video.h"

#include "core/base/shortage.h"
#include "core/base/units.h"
#include "core/files/protected_files.h"
#include "core/video/frame_times.h"
#include "core/video/image_reader.h"
#include "core/video/internal/orientation.h"
#include "core/video/jpeg.h"
#include "core/video/recording_writer.h"
#include "core/video/video_writer.h"

#include <fstream>
#include <memory>
#include <optional>
#include <span>

namespace odo {

namespace {

using Files = std::vector<std::filesystem::path>;

Message cannotTakeImage(const std::filesystem::path &file)
{
    return ODO_TEXT("video.cannot_take_image",
                    "cannot take '%1' as a frame of a video")(Named::file(file.filename()));
}

Message leaveOutImage()
{
    return ODO_TEXT("video.leave_out_image", "leave it out, or convert all of them in the same way");
}

Result<void> checkAlike(const std::filesystem::path &file, const FrameFormat &format,
                        const std::filesystem::path &firstFile, const FrameFormat &first)
{
    const MessageArgument firstName = Named::file(firstFile.filename());
    if (format.width != first.width || format.height != first.height)
        return fail(
            ErrorCode::InvalidInput, cannotTakeImage(file),
            ODO_TEXT("video.image_of_other_size", "its size is %1, that of the first, '%2', is %3")(
                sizeText(format.width, format.height), firstName, sizeText(first.width, first.height)),
            leaveOutImage());
    if (!sameLayout(format, first))
        return fail(
            ErrorCode::InvalidInput, cannotTakeImage(file),
            ODO_TEXT("video.image_of_other_layout",
                     "its colours are stored in another way than those of the first, '%1'")(firstName),
            leaveOutImage());
    return {};
}

/// All bytes of a file if it is a JPEG that need not be turned and can be a frame of a video as it is;
/// otherwise none.
struct PlainJpeg
{
    std::vector<std::uint8_t> bytes;
    FrameFormat format;
};
Result<std::optional<PlainJpeg>> plainJpeg(const std::filesystem::path &file)
{
    ODO_TRY(checkMayBeRead(file, cannotTakeImage(file)));
    PlainJpeg jpeg;
    std::ifstream stream(file, std::ios::binary);
    constexpr std::size_t startBytes = 32;
    jpeg.bytes.resize(startBytes);
    stream.read(reinterpret_cast<char *>(jpeg.bytes.data()), startBytes);
    if (!stream || jpeg.bytes[0] != 0xff || jpeg.bytes[1] != 0xd8)
        return std::optional<PlainJpeg>();
    jpeg.bytes.insert(jpeg.bytes.end(), std::istreambuf_iterator<char>(stream), {});
    const auto header = imageHeader(jpeg.bytes);
    const auto format = jpegFormat(jpeg.bytes);
    if (!header || header->format != ImageFormat::Jpeg || !format ||
        statedOrientation(ImageFormat::Jpeg, jpeg.bytes) != 1)
        return std::optional<PlainJpeg>();
    jpeg.format = *format;
    return std::optional(std::move(jpeg));
}

void reportImage(const JobControl &control, std::size_t done, const Files &images)
{
    control.report(static_cast<double>(done) / static_cast<double>(images.size()),
                   ODO_TEXT("video.taking_image", "taking image %1 of %2")(done + 1, images.size()));
}

double usualRate(const std::vector<Nanoseconds> &times)
{
    return 1 / toSeconds(spacingOf(times).usual);
}

Result<void> writeJpegs(const Files &images, const std::vector<Nanoseconds> &times,
                        const std::filesystem::path &claimed, const FrameFormat &format,
                        const JobControl &control)
{
    const auto writer = ODO_TRY(RecordingWriter::create(claimed, format, usualRate(times)));
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (control.isCancelled())
            return cancelled(cannotTakeImage(images[i]));
        reportImage(control, i, images);
        const auto jpeg = ODO_TRY(plainJpeg(images[i]));
        if (!jpeg)
            return fail(ErrorCode::InvalidInput, cannotTakeImage(images[i]),
                        ODO_TEXT("video.image_of_other_kind",
                                 "it is not an upright JPEG in colour as the first, '%1', is")(
                            Named::file(images.front().filename())),
                        leaveOutImage());
        ODO_TRY(checkAlike(images[i], jpeg->format, images.front(), format));
        ODO_TRY(writer->write(jpeg->bytes, times[i]));
    }
    return writer->finish();
}

Result<void> writeDecoded(const Files &images, const std::vector<Nanoseconds> &times,
                          const std::filesystem::path &claimed, const JobControl &control)
{
    std::unique_ptr<VideoWriter> writer;
    FrameFormat format;
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (control.isCancelled())
            return cancelled(cannotTakeImage(images[i]));
        reportImage(control, i, images);
        Frame frame = ODO_TRY(readImage(images[i]));
        if (!writer) {
            format = frame.format;
            VideoWriterOptions options;
            options.codec = VideoCodec::Ffv1;
            options.nominalFramesPerSecond = usualRate(times);
            options.threads = 0;
            writer = ODO_TRY(VideoWriter::createClaimed(claimed, format, options));
        }
        ODO_TRY(checkAlike(images[i], frame.format, images.front(), format));
        frame.format.siting = format.siting;
        frame.time = times[i];
        ODO_TRY(writer->write(frame));
    }
    return writer->finish();
}

} // namespace

Result<void> writeImageVideo(const std::vector<std::filesystem::path> &images,
                             const std::vector<Nanoseconds> &times, const std::filesystem::path &claimed,
                             const JobControl &control)
{
    return orShortage(cannotTakeImage(images.front()), [&]() -> Result<void> {
        const auto first = ODO_TRY(plainJpeg(images.front()));
        return first ? writeJpegs(images, times, claimed, first->format, control)
                     : writeDecoded(images, times, claimed, control);
    });
}

} // namespace odo
