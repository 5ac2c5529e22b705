// SPDX-License-Identifier: GPL-3.0-or-later
// What can be set at a GigE camera, and how its automatics are held.
#include "tests/capture/aravis/frame_taker.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

using namespace odo;
using namespace odo::test;

namespace {

std::optional<CameraControl> controlOf(CameraSource &source, const std::string &id)
{
    const auto controls = source.controls();
    if (!controls)
        return std::nullopt;
    const auto found = std::ranges::find(*controls, id, &CameraControl::id);
    return found == controls->end() ? std::nullopt : std::optional(*found);
}

} // namespace

class TestAravisControls : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void controlsAreReadAndSet()
    {
        SimulatedGigeCamera camera({.address = "127.31.4.2"}, codedPainter());
        const auto source = opened("aravis:127.31.4.2");
        QVERIFY(source);
        const auto exposure = controlOf(*source, "ExposureTime");
        QVERIFY(exposure);
        QCOMPARE(exposure->name, std::string("Exposure"));
        QCOMPARE(exposure->kind, CameraControl::Kind::Real);
        QCOMPARE(exposure->unit, std::string("µs"));
        QCOMPARE(exposure->value, 5000.0);
        QCOMPARE(exposure->minimum, 10.0);
        QCOMPARE(exposure->maximum, 1e6);
        QVERIFY(!exposure->readOnly);
        QVERIFY(!controlOf(*source, "ExposureAuto")); // it has none
        QVERIFY(source->set("ExposureTime", 2500));
        QCOMPARE(camera.readFloat(reg::ExposureTime), 2500.f);
        QCOMPARE(controlOf(*source, "ExposureTime")->value, 2500.0);
        QVERIFY(source->holdAutomatics().empty()); // there is nothing to hold
    }

    void badSettingsAreRefused()
    {
        SimulatedGigeCamera camera({.address = "127.31.4.3"}, codedPainter());
        const auto source = opened("aravis:127.31.4.3");
        QVERIFY(source);
        const auto none = source->set("Sharpness", 1);
        QCOMPARE(none.error().code, ErrorCode::NotFound);
        QVERIFY(none.error().message().find("no setting 'Sharpness'") != std::string::npos);
        for (const double value : {-1.0, 25.0, std::nan("")}) {
            const auto outside = source->set("Gain", value);
            QCOMPARE(outside.error().code, ErrorCode::InvalidInput);
            QVERIFY2(outside.error().message().find("Gain ranges from 0.00 to 24.00; ") != std::string::npos,
                     outside.error().message().c_str());
        }
        QCOMPARE(camera.readFloat(reg::Gain), 0.f);
    }

    /// Exposure and gain wander until they are held; a camera that has forgotten everything gets them back.
    void automaticsAreHeldWhereTheyAre()
    {
        const SimulatedGigeCamera::Settings settings{.address = "127.31.4.4", .automatics = true};
        auto camera = std::make_unique<SimulatedGigeCamera>(settings, codedPainter());
        const auto source = opened("aravis:127.31.4.4");
        QVERIFY(source);
        FrameTaker taker(*source);
        QTRY_VERIFY(taker.count() > 5);
        QVERIFY(controlOf(*source, "ExposureTime")->readOnly);
        const auto refused = source->set("ExposureTime", 1000);
        QVERIFY2(!refused && refused.error().message().find("cannot be set while it is automatic; ") !=
                                 std::string::npos,
                 refused ? "" : refused.error().message().c_str());
        const auto automatic = controlOf(*source, "ExposureAuto");
        QCOMPARE(automatic->kind, CameraControl::Kind::Choice);
        QCOMPARE(automatic->choices, (std::vector<std::string>{"Off", "Once", "Continuous"}));
        QCOMPARE(automatic->value, 2.0);

        QVERIFY(source->holdAutomatics().empty());
        QCOMPARE(camera->read(reg::ExposureAuto), 0u);
        QCOMPARE(camera->read(reg::GainAuto), 0u);
        const float exposure = camera->readFloat(reg::ExposureTime), gain = camera->readFloat(reg::Gain);
        const std::size_t before = taker.count();
        QTRY_VERIFY(taker.count() > before + 10);
        QCOMPARE(camera->readFloat(reg::ExposureTime), exposure);

        camera.reset();
        QTRY_VERIFY(taker.said("it does not answer"));
        camera = std::make_unique<SimulatedGigeCamera>(settings, codedPainter());
        const Nanoseconds back = steadyNow();
        QTRY_VERIFY_WITH_TIMEOUT(taker.countSince(back) > 3, 15000);
        QCOMPARE(camera->read(reg::ExposureAuto), 0u);
        QCOMPARE(camera->readFloat(reg::ExposureTime), exposure);
        QCOMPARE(camera->readFloat(reg::Gain), gain);
    }

    /// After the recording the camera sees to its exposure again; one that is away then, as soon as it is
    /// back.
    void automaticsAreGivenBack()
    {
        const SimulatedGigeCamera::Settings settings{.address = "127.31.4.6", .automatics = true};
        auto camera = std::make_unique<SimulatedGigeCamera>(settings, codedPainter());
        const auto source = opened("aravis:127.31.4.6");
        QVERIFY(source);
        FrameTaker taker(*source);
        QTRY_VERIFY(taker.count() > 5);
        source->releaseAutomatics(); // nothing is held
        QCOMPARE(camera->read(reg::ExposureAuto), 2u);
        QVERIFY(source->holdAutomatics().empty());
        QCOMPARE(camera->read(reg::ExposureAuto), 0u);
        source->releaseAutomatics();
        QCOMPARE(camera->read(reg::ExposureAuto), 2u);
        QCOMPARE(camera->read(reg::GainAuto), 2u);

        QVERIFY(source->holdAutomatics().empty());
        camera.reset();
        QTRY_VERIFY(taker.said("it does not answer"));
        source->releaseAutomatics();
        camera = std::make_unique<SimulatedGigeCamera>(settings, codedPainter());
        const Nanoseconds back = steadyNow();
        QTRY_VERIFY_WITH_TIMEOUT(taker.countSince(back) > 3, 15000);
        QCOMPARE(camera->read(reg::ExposureAuto), 2u); // it is not told to hold still any more
        QCOMPARE(camera->read(reg::GainAuto), 2u);
    }

    /// They are to be held while the camera is away: it is done when it comes back.
    void automaticsOfACameraThatIsAwayAreHeldLater()
    {
        const SimulatedGigeCamera::Settings settings{.address = "127.31.4.5", .automatics = true};
        auto camera = std::make_unique<SimulatedGigeCamera>(settings, codedPainter());
        const auto source = opened("aravis:127.31.4.5");
        QVERIFY(source);
        FrameTaker taker(*source);
        QTRY_VERIFY(taker.count() > 5);
        camera.reset();
        QTRY_VERIFY(taker.said("it does not answer"));
        QCOMPARE(test::english(source->holdAutomatics()), std::vector<std::string>{"Exposure and gain"});
        camera = std::make_unique<SimulatedGigeCamera>(settings, codedPainter());
        QTRY_VERIFY_WITH_TIMEOUT(camera->read(reg::ExposureAuto) == 0u && camera->read(reg::GainAuto) == 0u,
                                 15000);
    }
};

ODOGRAPH_TEST(TestAravisControls, QCoreApplication)
#include "tst_aravis_controls.moc"
