// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the seeds that are no text, by Odograph's own writers and libav's: fuzz_seeds tests/fuzz/corpus
#include "core/exchange/project_archive.h"
#include "core/project/internal/series_blobs.h"
#include "core/video/jpeg.h"
#include "core/video/video_writer.h"
#include "tests/project/sample_records.h"
#include "tests/video/foreign_files.h"
#include "tests/video/jpeg_images.h"
#include "tests/video/still_images.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sqlite3.h>

namespace {

using namespace odo;
using Path = std::filesystem::path;

void require(bool isSo, const char *what)
{
    if (isSo)
        return;
    std::fprintf(stderr, "fuzz_seeds: cannot write %s\n", what);
    std::exit(1);
}

void write(const Path &file, std::span<const char> bytes)
{
    std::ofstream stream(file, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    require(stream.flush().good(), file.c_str());
}

/// In pages of 512 bytes, so that a table takes less of the file.
void shrink(const Path &file)
{
    sqlite3 *database = nullptr;
    require(sqlite3_open(file.c_str(), &database) == SQLITE_OK, file.c_str());
    require(sqlite3_exec(database, "PRAGMA journal_mode=DELETE; PRAGMA page_size=512; VACUUM", nullptr,
                         nullptr, nullptr) == SQLITE_OK,
            file.c_str());
    sqlite3_close(database);
}

void writeProjects(const Path &folder)
{
    RecordSource source(7);
    for (const bool isFilled : {false, true}) {
        const Path file = folder / (isFilled ? "filled.odo" : "empty.odo");
        std::filesystem::remove(file);
        {
            const auto project = Project::create(file, "title");
            require(project.has_value(), file.c_str());
            require(!isFilled || fill(**project, source).has_value(), file.c_str());
        }
        shrink(file);
    }
}

void writeSeries(const Path &folder)
{
    RecordSource source(8);
    const auto keep = [&folder](const char *name, const QByteArray &bytes) { write(folder / name, bytes); };
    keep("times", packTimes(std::vector{Nanoseconds(0), Nanoseconds(33'000'000)}));
    keep("raw_times", packRawTimes(std::vector{RawTime{1, Nanoseconds(2), Nanoseconds(3)}}));
    keep("clock_readings",
         packClockReadings(std::vector{ClockReading{Nanoseconds(1), Nanoseconds(2), Nanoseconds(3)}}));
    keep("observations", packObservations(std::vector{source.observation(0), source.observation(1)}));
    const AnalysisRecord analysis = source.analysis(1, 1, 2);
    keep("samples", packSamples(analysis.profile.samples));
    keep("points", packPoints(analysis.profile.points));
    keep("truth", packTruth(source.truth(1, 1, 2)));
    keep("corners", packCorners(source.calibration(1).calibration.images.front()));
    keep("numbers", packNumbers(std::vector{1.0, 2.0}));
    keep("square", packSquare(Eigen::MatrixXd::Identity(2, 2)));
}

void writeArchives(const Path &folder)
{
    const Path content = folder / "content";
    write(content, std::string(300, 'x'));
    require(writeArchive(
                folder / "packed.zip",
                {{"p.odo", content}, {"p.media/run_A.mkv", content}, {"p.media/calibration/a.png", content}},
                {})
                .has_value(),
            "packed.zip");
    require(writeArchive(folder / "climbs.zip", {{"p.odo", content}, {"p.media/../../x", content}}, {})
                .has_value(),
            "climbs.zip");
    require(writeArchive(folder / "absolute.zip", {{"p.odo", content}, {"/tmp/x", content}}, {}).has_value(),
            "absolute.zip");
    std::filesystem::remove(content);
}

void writeImages(const Path &folder)
{
    const struct
    {
        const char *name, *encoder, *format;
    } images[] = {{"plain.png", "png", "rgb24"},  {"plain.jpg", "mjpeg", "yuvj420p"},
                  {"plain.bmp", "bmp", "bgr24"},  {"plain.tiff", "tiff", "rgb24"},
                  {"plain.ppm", "ppm", "rgb24"},  {"plain.pgm", "pgm", "gray"},
                  {"deep.png", "png", "rgb48be"}, {"clear.png", "png", "rgba"},
                  {"palette.bmp", "bmp", "pal8"}, {"deep.tiff", "tiff", "rgb48le"}};
    for (const auto &image : images)
        require(test::writeRaw(folder / image.name, image.encoder, image.format, 1, 1, 32), image.name);
    const test::RgbImage quarters = test::fourQuarters(33, 25);
    const test::Bytes webp = test::codedByLibav(quarters, "libwebp", "yuv420p");
    const std::pair<const char *, test::Bytes> others[] = {
        {"plain.heic", test::heicOf(quarters)},
        {"turned.heic", test::heicOf(quarters, 6)},
        {"plain.webp", webp},
        {"clear.webp", test::codedByLibav(quarters, "libwebp", "yuva420p")},
        {"lossless.webp", test::codedByLibav(quarters, "libwebp", "bgra", "lossless=1")},
        {"turned.webp", test::webpWithOrientation(webp, quarters, 8)},
        {"turned.jpg", test::jpegWithOrientation(test::codedByLibav(quarters, "mjpeg", "yuvj420p"), 5, true)},
        {"turned.png", test::pngWithOrientation(test::codedByLibav(quarters, "png", "rgb24"), 3)},
        {"inks.jpg", test::cmykJpegOf(quarters, true, true)},
        {"tiles.tiff", test::tiledTiffOf(test::fourQuarters(70, 20))}};
    for (const auto &[name, bytes] : others) {
        require(!bytes.empty(), name);
        write(folder / name, {reinterpret_cast<const char *>(bytes.data()), bytes.size()});
    }
}

void writeJpegs(const Path &folder)
{
    const std::pair<const char *, test::JpegWay> ways[] = {{"baseline.jpg", {}},
                                                           {"progressive.jpg", {.progressive = true}},
                                                           {"restarts.jpg", {.restartRows = 1}}};
    FrameFormat format;
    format.width = 32;
    format.height = 24;
    for (const auto &[name, way] : ways) {
        const auto bytes = test::jpegOf(format, way);
        write(folder / name, {reinterpret_cast<const char *>(bytes.data()), bytes.size()});
    }
    auto buffer = std::make_shared<FrameBuffer>(format);
    const auto encoded = JpegEncoder().encode(FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0)));
    require(encoded.has_value(), "recorded.jpg");
    write(folder / "recorded.jpg", {reinterpret_cast<const char *>(encoded->data()), encoded->size()});
}

void writeVideos(const Path &folder)
{
    const struct
    {
        const char *name, *encoder, *format;
        std::int64_t interval = 1;
    } videos[] = {
        {"mjpeg.mkv", "mjpeg", "yuvj420p"}, {"mjpeg.avi", "mjpeg", "yuvj422p"},
        {"ffv1.mkv", "ffv1", "yuv420p"},    {"h264.mp4", "libx264", "yuv420p"},
        {"mpeg4.avi", "mpeg4", "yuv420p"},  {"mpeg2.ts", "mpeg2video", "yuv420p"},
        {"vp8.webm", "libvpx", "yuv420p"},  {"grey.nut", "rawvideo", "gray"},
        {"nv12.mov", "rawvideo", "nv12"},   {"far.mkv", "mjpeg", "yuvj420p", 50'000'000'000'000'000}};
    for (const auto &video : videos) {
        if (!test::writeRaw(folder / video.name, video.encoder, video.format, 3, video.interval)) {
            std::fprintf(stderr, "fuzz_seeds: libav does not write %s\n", video.name);
            std::filesystem::remove(folder / video.name);
        }
    }
    for (const char *name : {"h264.mkv", "h264.mov", "h264.ts", "h264.flv", "h264.h264"})
        static_cast<void>(test::remux(folder / "h264.mp4", folder / name));
}

} // namespace

int main(int count, char **arguments)
{
    require(count == 2, "anything: name the folder of the corpora");
    const Path corpus = arguments[1];
    const std::pair<const char *, void (*)(const Path &)> parts[] = {
        {"project", writeProjects}, {"series", writeSeries}, {"archive", writeArchives},
        {"picture", writeImages},   {"jpeg", writeJpegs},    {"video", writeVideos}};
    for (const auto &[name, writePart] : parts) {
        std::filesystem::create_directories(corpus / name);
        writePart(corpus / name);
    }
}
