// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/camera_source.h"

#include "tests/capture/played_camera.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

const Error notThere = test::saidError(
    ErrorCode::Unavailable, "camera play:", "it is connected but sends no frames", "check its cable");

} // namespace

class TestSettledFrame : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void isTheFirstAfterHalfASecond()
    {
        const auto script = std::make_shared<Script>();
        script->error(notThere); // it comes only now
        script->frames(30);
        PlayedCamera camera(script, {});
        const auto image = settledFrame(camera, {});
        QVERIFY(image);
        QCOMPARE(image->time, 16 * PlayedCamera::interval); // 15 are 0.495 s
    }

    void aCameraThatWillNotComeIsGivenUp()
    {
        const auto script = std::make_shared<Script>();
        for (int i = 0; i < 6; ++i)
            script->error(notThere);
        PlayedCamera camera(script, {});
        const auto image = settledFrame(camera, {});
        QVERIFY(!image);
        QCOMPARE(image.error().message(), notThere.message());
    }

    void isCancelled()
    {
        const auto script = std::make_shared<Script>();
        script->frames(1);
        PlayedCamera camera(script, {});
        JobControl control;
        control.cancel.cancel();
        const auto image = settledFrame(camera, control);
        QVERIFY(!image);
        QCOMPARE(image.error().code, ErrorCode::Cancelled);
    }
};

ODOGRAPH_TEST(TestSettledFrame, QCoreApplication)
#include "tst_settled_frame.moc"
