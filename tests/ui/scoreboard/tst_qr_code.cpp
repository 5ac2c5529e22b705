// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/scoreboard/internal/qr_code.h"

#include <QApplication>
#include <QTest>

using namespace odo;

class TestQrCode : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// ISO/IEC 18004: three finder patterns of 7 × 7, and a line of alternating modules between them.
    void hasThePatternsOfAQrCode()
    {
        const QrCode code = QrCode::of(QStringLiteral("http://192.168.100.200:8080/"));
        QVERIFY(code.side >= 21 && code.side % 4 == 1);
        QCOMPARE(code.isDark.size(), std::size_t(code.side * code.side));
        const auto isDark = [&code](int x, int y) { return code.isDark[std::size_t(y * code.side + x)]; };
        for (const QPoint corner : {QPoint(0, 0), QPoint(code.side - 7, 0), QPoint(0, code.side - 7)})
            for (int y = 0; y < 7; ++y)
                for (int x = 0; x < 7; ++x) {
                    const int ring = std::max(std::abs(x - 3), std::abs(y - 3));
                    QCOMPARE(isDark(corner.x() + x, corner.y() + y), ring != 2);
                }
        for (int x = 8; x < code.side - 8; ++x)
            QCOMPARE(isDark(x, 6), x % 2 == 0);
    }
    void whatIsTooLongIsNone() { QCOMPARE(QrCode::of(QString(10'000, u'a')).side, 0); }
    void isBlackOnWhiteInWholePixels()
    {
        QrWidget widget;
        widget.setText(QStringLiteral("http://127.0.0.1:8080/"));
        QCOMPARE(widget.accessibleName(), QStringLiteral("http://127.0.0.1:8080/"));
        const QImage image = widget.grab().toImage();
        int black = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QRgb pixel = image.pixel(x, y) & 0xffffff;
                QVERIFY(pixel == 0 || pixel == 0xffffff);
                black += pixel == 0;
            }
        QVERIFY(black > image.width() * image.height() / 5);
        for (int x = 0; x < image.width(); ++x)
            QCOMPARE(image.pixel(x, 3) & 0xffffff, QRgb(0xffffff)); // quiet zone
    }
};

ODOGRAPH_TEST(TestQrCode, QApplication)
#include "tst_qr_code.moc"
