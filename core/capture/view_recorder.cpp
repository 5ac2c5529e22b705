// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/view_recorder.h"

#include "core/video/jpeg_encoder.h"
#include "core/video/recording_writer.h"

#include <chrono>

namespace odo {

namespace {

constexpr std::size_t mostPending = 64; // two seconds at 30 frames/s; at 1280×720 some 90 MB

} // namespace

struct ViewRecorder::Output
{
    JpegEncoder encoder;
    std::unique_ptr<RecordingWriter> writer;
    Nanoseconds first{0};             ///< device time of the first picture
    std::vector<Nanoseconds> devices; ///< of each picture written
};

ViewRecorder::ViewRecorder(std::unique_ptr<CameraSource> camera, std::filesystem::path file, OnFrame onFrame)
    : m_camera(std::move(camera)), m_onFrame(std::move(onFrame)), m_queue(mostPending), m_output(std::make_unique<Output>())
{
    m_recording.file = std::move(file);
}

ViewRecorder::~ViewRecorder()
{
    if (m_taker.joinable())
        finish();
}

void ViewRecorder::start()
{
    m_taker = std::thread([this] { takePictures(); });
    m_writer = std::thread([this] { writePictures(); });
}

std::uint64_t ViewRecorder::frames() const
{
    const std::lock_guard lock(m_mutex);
    return m_recording.frames;
}

bool ViewRecorder::hasEnded() const
{
    const std::lock_guard lock(m_mutex);
    return m_recording.problem.has_value();
}

void ViewRecorder::fail(const Error &error)
{
    const std::lock_guard lock(m_mutex);
    if (!m_recording.problem)
        m_recording.problem = error;
}

Nanoseconds ViewRecorder::hostTime(Nanoseconds device) const
{
    const std::lock_guard lock(m_mutex);
    return m_clock.fit() ? m_clock.fit()->hostTime(device) : device;
}

void ViewRecorder::takePictures()
{
    for (;;) {
        auto captured = m_camera->next();
        if (!captured) {
            if (captured.error().code != ErrorCode::Cancelled)
                fail(captured.error());
            return;
        }
        if (!take(std::move(*captured)))
            return;
    }
}

/// False once writing has failed: there is nothing left to take pictures for.
bool ViewRecorder::take(CapturedFrame captured)
{
    TimedFrame timed{std::move(captured), {}};
    const CapturedFrame &picture = timed.captured;
    const bool room = m_queue.tryPush({picture.frame, picture.frame.time});
    {
        const std::lock_guard lock(m_mutex);
        if (m_recording.problem)
            return false;
        m_clock.addArrival(picture.frame.time, picture.hostTime);
        timed.taken = m_clock.fit()->hostTime(picture.frame.time);
        ++m_recording.frames;
        m_recording.lostByUs += !room;
        if (m_lastSequence && picture.sequence > *m_lastSequence + 1)
            m_recording.lostOnWire += picture.sequence - *m_lastSequence - 1;
        m_lastSequence = picture.sequence;
    }
    m_onFrame(std::move(timed));
    return true;
}

void ViewRecorder::writePictures()
{
    while (const auto pending = m_queue.pop()) {
        const auto written = write(*pending);
        if (!written) {
            fail(written.error());
            m_queue.close();
            m_camera->stop();
            return;
        }
        const Nanoseconds now = std::chrono::steady_clock::now().time_since_epoch();
        const double latencyS = toSeconds(now - hostTime(pending->device));
        const std::lock_guard lock(m_mutex);
        m_recording.latenciesS.push_back(latencyS);
    }
}

Result<void> ViewRecorder::write(const Pending &pending)
{
    Output &output = *m_output;
    const auto jpeg = output.encoder.encode(pending.frame);
    if (!jpeg)
        return tl::unexpected(jpeg.error());
    if (!output.writer) {
        auto writer = RecordingWriter::create(m_recording.file, pending.frame.format, m_camera->description().framesPerSecond);
        if (!writer)
            return tl::unexpected(writer.error());
        output.writer = std::move(*writer);
        output.first = pending.device;
        const std::lock_guard lock(m_mutex);
        m_recording.format = pending.frame.format;
    }
    if (auto written = output.writer->write(*jpeg, pending.device - output.first); !written)
        return written;
    output.devices.push_back(pending.device);
    return {};
}

ViewRecording ViewRecorder::finish()
{
    m_camera->stop();
    m_taker.join();
    m_queue.close();
    m_writer.join();
    if (m_output->writer) {
        if (const auto finished = m_output->writer->finish(); !finished)
            fail(finished.error());
    }
    if (m_clock.fit()) {
        for (const Nanoseconds device : m_output->devices)
            m_recording.taken.push_back(m_clock.fit()->hostTime(device));
        m_recording.clockSigmaS = m_clock.fit()->sigmaS;
    }
    return std::move(m_recording);
}

} // namespace odo
