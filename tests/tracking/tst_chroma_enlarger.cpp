// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/compared_window.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

class TestChromaEnlarger : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// A ramp is what it was between its outermost samples, whatever the siting.
    void aRampStaysARamp_data()
    {
        QTest::addColumn<int>("shiftX");
        QTest::addColumn<int>("shiftY");
        QTest::addColumn<int>("siting");
        for (const ChromaSiting siting : {ChromaSiting::Left, ChromaSiting::Center, ChromaSiting::TopLeft})
            for (const auto &[x, y] :
                 {std::pair{1, 1}, std::pair{1, 0}, std::pair{0, 0}, std::pair{2, 0}, std::pair{2, 2}})
                QTest::addRow("4:2:0 and others %d %d, siting %d", x, y, int(siting))
                    << x << y << int(siting);
    }
    void aRampStaysARamp()
    {
        QFETCH(int, shiftX);
        QFETCH(int, shiftY);
        QFETCH(int, siting);
        FrameFormat format;
        format.width = 61;
        format.height = 37;
        format.chromaShiftX = shiftX;
        format.chromaShiftY = shiftY;
        format.siting = ChromaSiting(siting);
        const int width = (format.width + (1 << shiftX) - 1) >> shiftX,
                  height = (format.height + (1 << shiftY) - 1) >> shiftY;
        const auto sampleX = [&](int cx) { return (cx << shiftX) + format.chromaOffsetX(); };
        const auto sampleY = [&](int cy) { return (cy << shiftY) + format.chromaOffsetY(); };
        for (const PixelRect &part :
             {PixelRect{0, 0, 61, 37}, PixelRect{8, 3, 41, 30}, PixelRect{56, 36, 61, 37}}) {
            ChromaEnlarger enlarger(format, part);
            cv::Mat1s samples;
            enlarger.takeSamples(
                width, height,
                [&](int cy, int first, int last, std::int16_t *into) {
                    for (int cx = first; cx < last; ++cx)
                        into[cx - first] =
                            std::int16_t(ChromaEnlarger::unit * (3 * sampleX(cx) - 2 * sampleY(cy)));
                },
                samples);
            // rows need not be made whole
            const int skipped = part.width() > 8 ? ChromaEnlarger::columnUnit : 0;
            std::vector<std::int16_t> row(std::size_t(ChromaEnlarger::paddedColumns(part.width() - skipped)));
            for (int y = 0; y < part.height(); ++y) {
                enlarger.enlargeRow(samples, y, skipped, part.width(), row.data());
                for (int x = skipped; x < part.width(); ++x) {
                    const double atX = std::clamp(double(part.x0 + x), sampleX(0), sampleX(width - 1)),
                                 atY = std::clamp(double(part.y0 + y), sampleY(0), sampleY(height - 1));
                    QCOMPARE(double(row[std::size_t(x - skipped)]),
                             ChromaEnlarger::unit * (3 * atX - 2 * atY));
                }
            }
        }
    }
};

ODOGRAPH_TEST(TestChromaEnlarger, QCoreApplication)
#include "tst_chroma_enlarger.moc"
