// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/aravis_source.h"

#include "core/capture/aravis/internal/aravis_controls.h"
#include "core/capture/aravis/internal/aravis_library.h"
#include "core/capture/aravis/internal/aravis_worker.h"
#include "core/capture/aravis/internal/gvcp.h"

#include <thread>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds frameWithin = 500ms, answerWithin = 2s, openWithin = 8s, endWithin = 300ms;
constexpr auto listingPatience = 100ms;

class AravisSource : public CameraSource
{
public:
    AravisSource(AravisAddress address, std::promise<Result<CameraDescription>> opened)
        : m_session(std::make_shared<AravisSession>(address.uri)),
          m_worker(std::make_shared<AravisWorker>(std::move(address), m_session, std::move(opened))),
          m_thread([worker = m_worker] { worker->run(); })
    {
    }
    ~AravisSource() override
    {
        m_session->stop();
        if (m_session->waitForEnd(endWithin))
            m_thread.join();
        else
            AravisLibrary::instance().finishLater(std::move(m_thread),
                                                  [session = m_session] { return session->waitForEnd(0ns); });
    }

    void describe(CameraDescription description) { m_description = std::move(description); }

    const CameraDescription &description() const override { return m_description; }
    Result<CapturedFrame> next() override { return m_session->next(frameWithin); }
    void stop() override { m_session->stop(); }
    CameraCounts counts() const override { return m_session->counts(); }

    Result<std::vector<CameraControl>> controls() override
    {
        const auto read = [otherwise = noAnswer(m_description.uri)](
                              AravisDevice *device, AravisWorker &) -> Result<std::vector<CameraControl>> {
            return device ? Result<std::vector<CameraControl>>(readAravisControls(device->camera()))
                          : otherwise;
        };
        return onCamera<Result<std::vector<CameraControl>>>(read, noAnswer(m_description.uri));
    }
    Result<void> set(const std::string &id, double value) override
    {
        const auto setIt = [id, value, uri = m_description.uri](AravisDevice *device,
                                                                AravisWorker &worker) -> Result<void> {
            return device ? worker.set(*device, id, value) : noAnswer(uri);
        };
        return onCamera<Result<void>>(setIt, noAnswer(m_description.uri));
    }
    std::vector<Message> holdAutomatics() override
    {
        const auto hold = [](AravisDevice *device, AravisWorker &worker) {
            return worker.holdAutomatics(device);
        };
        return onCamera<std::vector<Message>>(hold, {exposureAndGain()});
    }
    void releaseAutomatics() override
    {
        const auto release = [](AravisDevice *device, AravisWorker &worker) {
            worker.releaseAutomatics(device);
            return true;
        };
        onCamera<bool>(release, false);
    }

private:
    /// Has the camera's thread do something, and waits for it; gives the other answer where it cannot be
    /// waited for.
    template <class Answer, class Work>
    Answer onCamera(Work work, Answer otherwise)
    {
        auto answer = std::make_shared<std::promise<Answer>>();
        std::future<Answer> future = answer->get_future();
        // The worker runs its tasks itself, and so outlives them.
        m_session->ask([answer, work, worker = m_worker.get()](AravisDevice *device) {
            answer->set_value(work(device, *worker));
        });
        return future.wait_for(answerWithin) == std::future_status::ready ? future.get() : otherwise;
    }

    CameraDescription m_description; ///< set before anybody else has the source
    const std::shared_ptr<AravisSession> m_session;
    const std::shared_ptr<AravisWorker> m_worker;
    std::thread m_thread;
};

CameraDescription describeFound(const std::string &location, const std::string &vendor,
                                const std::string &model, const std::string &serial, bool busy)
{
    CameraDescription camera;
    camera.uri = "aravis:" + (serial.empty() ? location : serial);
    camera.kind = "aravis";
    camera.name = foreignWords(vendor + " " + model);
    camera.serial = serial;
    camera.busy = busy;
    return camera;
}

} // namespace

Result<std::unique_ptr<CameraSource>> openAravisSource(const std::string &uri)
{
    auto address = ODO_TRY(parseAravisAddress(uri));
    AravisLibrary::instance();
    std::promise<Result<CameraDescription>> promise;
    auto opened = promise.get_future();
    auto source = std::make_unique<AravisSource>(std::move(address), std::move(promise));
    if (opened.wait_for(openWithin) != std::future_status::ready)
        return noAnswer(uri);
    auto description = ODO_TRY(opened.get());
    source->describe(std::move(description));
    return source;
}

std::vector<CameraDescription> listAravisCameras()
{
    std::vector<CameraDescription> cameras;
    for (const GvcpCamera &camera : discoverGvcpCameras())
        cameras.push_back(describeFound(camera.address, camera.vendor, camera.model, camera.serial,
                                        isGvcpControlled(camera.address, listingPatience).value_or(false)));
    for (const UsbVisionCamera &camera : AravisLibrary::instance().usbCameras())
        cameras.push_back(describeFound(camera.id, camera.vendor, camera.model, camera.serial, false));
    return cameras;
}

} // namespace odo
