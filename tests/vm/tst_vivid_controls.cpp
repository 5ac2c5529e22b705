// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in the emulated machine: the emulated camera has controls of every type.
#include "tests/vm/vivid_cameras.h"

#include <QTest>
#include <algorithm>

using namespace odo;
using namespace odo::test;

class TestVividControls : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_source = opened("v4l2:/dev/video0?size=320x180&rate=25&format=YUYV");
        QVERIFY(m_source);
    }
    void cleanup() { m_source.reset(); }

    void allTypesAreDescribed()
    {
        using Kind = CameraControl::Kind;
        const CameraControl brightness = control("brightness");
        QCOMPARE(brightness.kind, Kind::Integer);
        QCOMPARE(brightness.minimum, 0.0);
        QCOMPARE(brightness.maximum, 255.0);
        QCOMPARE(brightness.standard, 128.0);
        QCOMPARE(control("integer_64_bits").kind, Kind::Integer);
        QCOMPARE(control("bitmask").maximum, double(0x80402010U));
        QCOMPARE(control("boolean").kind, Kind::Boolean);
        QCOMPARE(control("button").kind, Kind::Boolean);
        // The driver's menu has a hole: choices are counted as they are shown.
        const CameraControl menu = control("menu");
        QCOMPARE(menu.kind, Kind::Choice);
        QCOMPARE(menu.choices, (std::vector<std::string>{"Menu Item 1", "Menu Item 3", "Menu Item 4"}));
        QCOMPARE(menu.choices.at(std::size_t(menu.standard)), std::string("Menu Item 3"));
        QCOMPARE(control("integer_menu").kind, Kind::Choice);
        QVERIFY(control("read_only_integer_32_bits").readOnly);
        const auto all = m_source->controls();
        QVERIFY(std::ranges::none_of(*all, [](const CameraControl &one) {
            return one.id == "string" || one.id == "u32_1_element_array";
        }));
    }

    void whatIsSetIsKept()
    {
        for (const auto &[id, value] : {std::pair<const char *, double>{"brightness", 77},
                                        {"integer_64_bits", -5e9},
                                        {"boolean", 0},
                                        {"menu", 1},
                                        {"integer_menu", 0},
                                        {"bitmask", 0x2000},
                                        {"brightness", 128}}) {
            const auto set = m_source->set(id, value);
            QVERIFY2(set, set ? "" : set.error().message().c_str());
            QCOMPARE(control(id).value, value);
        }
        QVERIFY(m_source->set("button", 1));
    }

    void whatCannotBeSetSaysWhy()
    {
        const auto message = [&](const char *id, double value) {
            return m_source->set(id, value).error().message();
        };
        QCOMPARE(message("brightness", 300),
                 std::string("camera v4l2:/dev/video0?size=320x180&rate=25&format=YUYV: Brightness ranges "
                             "from 0 to 255; choose a value between"));
        QVERIFY(message("brightness", std::nan("")).find("ranges from") != std::string::npos);
        QVERIFY(message("read_only_integer_32_bits", 1)
                    .find("cannot be set in the camera's current mode; first turn off the automatic") !=
                std::string::npos);
        QCOMPARE(m_source->set("warp", 1).error().code, ErrorCode::NotFound);
        QCOMPARE(m_source->set("menu", 3).error().code, ErrorCode::InvalidInput);
    }

    /// vivid's gain moves by itself while its automatic is on.
    void automaticsAreHeldWhereTheyAre()
    {
        QVERIFY(m_source->set("gain_automatic", 1));
        QCOMPARE(control("gain_automatic").value, 1.0);
        QVERIFY(m_source->holdAutomatics().empty());
        QCOMPARE(control("gain_automatic").value, 0.0);
        const double held = control("gain").value;
        QVERIFY(!take(*m_source, 10).frames.empty());
        QCOMPARE(control("gain").value, held);
        m_source->releaseAutomatics();
        QCOMPARE(control("gain_automatic").value, 1.0);
    }

private:
    CameraControl control(const std::string &id)
    {
        const auto all = m_source->controls();
        if (!all)
            return {};
        const auto found = std::ranges::find(*all, id, &CameraControl::id);
        if (found == all->end())
            QTest::qFail(("no control " + id).c_str(), __FILE__, __LINE__);
        return found == all->end() ? CameraControl{} : *found;
    }
    std::unique_ptr<CameraSource> m_source;
};

QTEST_GUILESS_MAIN(TestVividControls)
#include "tst_vivid_controls.moc"
