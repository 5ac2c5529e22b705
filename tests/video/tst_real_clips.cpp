// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QFile>
#include <QSize>
#include <QTest>

using namespace odo;
using namespace odo::test;

class TestRealClips : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void realClips_data();
    void realClips();
};

namespace {

QString realFolder()
{
    const QString named = qEnvironmentVariable("ODOGRAPH_REAL_DATA");
    return named.isEmpty() ? qEnvironmentVariable("ODOGRAPH_SOURCE_DIR") + QStringLiteral("/../shared/data")
                           : named;
}

} // namespace

void TestRealClips::realClips_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("frames");
    QTest::addColumn<double>("rate");
    QTest::addColumn<QSize>("size");
    QTest::newRow("A") << QStringLiteral("cap-two-views/A.mp4") << 100 << 60.0 << QSize(1088, 1920);
    QTest::newRow("B") << QStringLiteral("cap-two-views/B.mp4") << 100 << 60.0 << QSize(1088, 1920);
    QTest::newRow("webcam") << QStringLiteral("charuco-four-webcams/cam_0.mp4") << 111 << 6.0
                            << QSize(1280, 720);
}

void TestRealClips::realClips()
{
    QFETCH(QString, name);
    QFETCH(int, frames);
    QFETCH(double, rate);
    QFETCH(QSize, size);
    const QString file = realFolder() + QLatin1Char('/') + name;
    if (!QFile::exists(file))
        QSKIP(qPrintable(QStringLiteral("ODOGRAPH-SKIPPED: no real material at ") + file));
    const auto reader = VideoReader::open(file.toStdString());
    QVERIFY(reader.has_value());
    const VideoInfo &info = (*reader)->info();
    QCOMPARE(int(info.frameTimes.size()), frames);
    QVERIFY(std::abs(info.framesPerSecond - rate) < 1e-3);
    QVERIFY(!info.variableRate);
    QCOMPARE(QSize(info.format.width, info.format.height), size);
    std::vector<std::uint64_t> sequential;
    while (const auto frame = (*reader)->next().value())
        sequential.push_back(fingerprint(*frame));
    QCOMPARE(int(sequential.size()), frames);
    for (const int index : {frames - 1, 1, frames / 2, frames / 2 - 1, 0})
        QCOMPARE(fingerprint((*reader)->frameAt(index).value()), sequential[static_cast<std::size_t>(index)]);
}

ODOGRAPH_TEST(TestRealClips, QCoreApplication)
#include "tst_real_clips.moc"
