// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"
#include "tests/support/real_material.h"

#include <QTest>
#include <fstream>
#include <sstream>

using namespace odo;

namespace {

std::vector<std::vector<std::string>> readCsv(const std::filesystem::path &file)
{
    std::ifstream stream(file);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(stream, line);) {
        std::stringstream fields(line);
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');)
            rows.back().push_back(field);
    }
    rows.erase(rows.begin()); // the header
    return rows;
}

/// The numbers of the brackets that follow the n-th "data:" of a ROS calibration.
std::vector<double> rosData(const std::filesystem::path &file, int which)
{
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    std::string rest = text.str();
    for (int i = 0; i <= which; ++i)
        rest = rest.substr(rest.find("data: [") + 7);
    std::stringstream numbers(rest.substr(0, rest.find(']')));
    std::vector<double> values;
    for (std::string number; std::getline(numbers, number, ',');)
        values.push_back(QString::fromStdString(number).toDouble());
    return values;
}

CameraModel rosCamera(const std::filesystem::path &file, int widthPx, int heightPx)
{
    const std::vector<double> k = rosData(file, 0);
    Intrinsics intrinsics{widthPx,          heightPx, k[0], k[4], k[2], k[5], LensModel::Standard,
                          rosData(file, 1), {}};
    return CameraModel::create(intrinsics).value();
}

} // namespace

class TestRealCalibration : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void registersTheRealTwoCameras_data()
    {
        QTest::addColumn<QString>("camera");
        QTest::newRow("A") << QStringLiteral("A");
        QTest::newRow("B") << QStringLiteral("B");
    }
    void registersTheRealTwoCameras()
    {
        ODOGRAPH_NEED_REAL("cap-two-views");
        QFETCH(QString, camera);
        const auto folder = realMaterial() / "cap-two-views";
        MarkerLayout layout{"treadmill", {}};
        const auto number = [](const std::string &text) { return QString::fromStdString(text).toDouble(); };
        for (const auto &row : readCsv(folder / "layout.csv"))
            layout.markers.push_back({row[0], {number(row[1]) / 1000, number(row[2]) / 1000}});
        std::vector<MarkerPixel> pixels;
        for (const auto &row : readCsv(folder / ("pixels_" + camera.toStdString() + ".csv")))
            pixels.push_back({row[0], {number(row[1]), number(row[2])}});
        const CameraModel lens = rosCamera(folder / (camera.toStdString() + ".yaml"), 1088, 1920);
        const auto registration = registerFloor(layout, pixels, lens, true);
        QVERIFY2(registration.has_value(), registration ? "" : registration.error().message().c_str());
        qInfo("%s: %.3f px, %.2f mm, camera %.3f m above the floor; %s", qPrintable(camera),
              registration->rmsPx, 1000 * registration->rmsM, registration->worldFromCamera.translation.z(),
              registration->verdict.c_str());
        QVERIFY(registration->rmsM < 0.005);
        const auto guessed = registerFloor(layout, pixels, CameraModel::assumed(1088, 1920), false);
        QVERIFY2(guessed.has_value(), guessed ? "" : guessed.error().message().c_str());
        qInfo("%s without intrinsics: %s", qPrintable(camera), guessed->verdict.c_str());
        QVERIFY(std::abs(guessed->intrinsics.fxPx - lens.intrinsics().fxPx) < 0.1 * lens.intrinsics().fxPx);
    }
};

QTEST_GUILESS_MAIN(TestRealCalibration)
#include "tst_real_calibration.moc"
