// SPDX-License-Identifier: GPL-3.0-or-later
// Printed targets: the painted sheets are read back by the program's own detectors, to scale.
#include "core/base/units.h"
#include "core/calibration/board_detection.h"
#include "core/calibration/marker_detection.h"
#include "core/video/frame.h"
#include "tests/support/registered_test.h"
#include "ui/testbed/targets/target_dialog.h"
#include "ui/testbed/targets/target_sheet.h"
#include "ui/views/widgets/form_fields.h"

#include <QApplication>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

constexpr double pixelsAMillimetre = 4;

QImage painted(const TargetSpec &spec, const TargetSheet &sheet)
{
    QImage image((sheet.paperMm * pixelsAMillimetre).toSize(), QImage::Format_Grayscale8);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(pixelsAMillimetre, pixelsAMillimetre);
    paintTarget(painter, spec, sheet);
    return image;
}

Frame frameOf(const QImage &image)
{
    Frame frame;
    frame.y = {image.constBits(), image.width(), image.height(), image.bytesPerLine()};
    return frame;
}

/// Millimetres on the paper; pixel (0,0) is the centre of the first pixel.
Eigen::Vector2d onPaperMm(const Eigen::Vector2d &pixel)
{
    return (pixel + Eigen::Vector2d(0.5, 0.5)) / pixelsAMillimetre;
}

} // namespace

class TestTargets : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void boardIsFoundToScale_data();
    void boardIsFoundToScale();
    void tagsAreFoundInTheirMiddle();
    void ringsAreToScale();
    void rulerMeasuresAHundredMillimetres();
    void refusesWithReason_data();
    void refusesWithReason();
    void writesAPageForEachMarker();
    void leavesNothingHalfWritten();
    void dialogTellsWhatDoesNotFit();
};

void TestTargets::boardIsFoundToScale_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("paper");
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("rows");
    QTest::addColumn<double>("squareMm");
    QTest::newRow("checkerboard on A4")
        << int(TargetKind::Checkerboard) << int(QPageSize::A4) << 9 << 6 << 25.0;
    QTest::newRow("checkerboard on Letter")
        << int(TargetKind::Checkerboard) << int(QPageSize::Letter) << 9 << 6 << 25.0;
    QTest::newRow("checkerboard on A3")
        << int(TargetKind::Checkerboard) << int(QPageSize::A3) << 9 << 6 << 36.0;
    QTest::newRow("upright checkerboard")
        << int(TargetKind::Checkerboard) << int(QPageSize::A4) << 5 << 8 << 28.0;
    QTest::newRow("ChArUco on A4") << int(TargetKind::Charuco) << int(QPageSize::A4) << 9 << 6 << 25.0;
    QTest::newRow("ChArUco on A3") << int(TargetKind::Charuco) << int(QPageSize::A3) << 7 << 4 << 45.0;
}

void TestTargets::boardIsFoundToScale()
{
    QFETCH(int, kind);
    QFETCH(int, paper);
    QFETCH(int, columns);
    QFETCH(int, rows);
    QFETCH(double, squareMm);
    TargetSpec spec;
    spec.kind = TargetKind(kind);
    spec.paper = QPageSize::PageSizeId(paper);
    spec.columns = columns;
    spec.rows = rows;
    spec.squareM = fromMillimetres(squareMm);
    const auto sheets = layOutTarget(spec);
    QVERIFY2(sheets, sheets ? "" : sheets.error().message().c_str());
    QCOMPARE(sheets->size(), std::size_t(1));
    const QImage image = painted(spec, sheets->front());
    BoardSpec wanted;
    wanted.pattern = kind == int(TargetKind::Charuco) ? BoardPattern::Charuco : BoardPattern::Checkerboard;
    wanted.squareM = spec.squareM;
    const auto view = findBoard(frameOf(image), wanted, "sheet");
    QVERIFY2(view, view ? "" : view.error().message().c_str());
    QCOMPARE(std::minmax(view->columns, view->rows), std::minmax(columns, rows));
    QCOMPARE(view->pixels.size(), std::size_t(columns * rows));
    // Every corner lies on the grid that begins in the figure's corner, whichever way round the board was
    // read.
    const QPointF start = sheets->front().drawingMm.topLeft();
    for (const Eigen::Vector2d &pixel : view->pixels) {
        const Eigen::Vector2d square = (onPaperMm(pixel) - Eigen::Vector2d(start.x(), start.y())) / squareMm;
        const double offMm = squareMm * (square - square.array().round().matrix()).norm();
        QVERIFY2(offMm < 0.05, qPrintable(QStringLiteral("%1 mm off").arg(offMm)));
    }
}

void TestTargets::tagsAreFoundInTheirMiddle()
{
    TargetSpec spec;
    spec.kind = TargetKind::Tags;
    const auto sheets = layOutTarget(spec);
    QVERIFY(sheets);
    QCOMPARE(sheets->size(), std::size_t(4));
    // The detector wants four markers, where the layout has them: the sheets are laid out two by two.
    QList<QImage> images;
    for (const TargetSheet &sheet : *sheets)
        images << painted(spec, sheet);
    const QSize one = images[0].size();
    const auto cornerOf = [&](int i) { return QPoint(i % 2 * one.width(), i < 2 ? one.height() : 0); };
    QImage all(one * 2, QImage::Format_Grayscale8);
    all.fill(Qt::white);
    QPainter painter(&all);
    for (int i = 0; i < 4; ++i)
        painter.drawImage(cornerOf(i), images[i]);
    painter.end();
    const double width = one.width() / pixelsAMillimetre / 1000,
                 height = one.height() / pixelsAMillimetre / 1000;
    MarkerLayout layout{"floor",
                        {{"O", {0, 0}}, {"U", {width, 0}}, {"V", {0, height}}, {"D", {width, height}}}};
    const auto found = findMarkers(frameOf(all), layout);
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QCOMPARE(found->size(), std::size_t(4));
    for (std::size_t i = 0; i < 4; ++i) {
        QCOMPARE((*found)[i].label, sheets->at(i).label.toStdString());
        const QPointF middle = sheets->at(i).drawingMm.center();
        const QPointF corner = QPointF(cornerOf(int(i))) / pixelsAMillimetre;
        const Eigen::Vector2d expected(middle.x() + corner.x(), middle.y() + corner.y());
        const double offMm = (onPaperMm((*found)[i].pixel) - expected).norm();
        QVERIFY2(offMm < 0.05, qPrintable(QStringLiteral("%1 mm off").arg(offMm)));
    }
}

void TestTargets::ringsAreToScale()
{
    TargetSpec spec;
    spec.kind = TargetKind::Rings;
    spec.labels = {QStringLiteral("O")};
    const auto sheets = layOutTarget(spec);
    QVERIFY(sheets);
    const QRectF ink = sheets->front().ink.boundingRect();
    QVERIFY(std::abs(ink.width() - 150) < 1e-6 && std::abs(ink.height() - 150) < 1e-6);
    const QPointF middle = sheets->front().drawingMm.center();
    QVERIFY(!sheets->front().ink.contains(middle));                 // the hole
    QVERIFY(sheets->front().ink.contains(middle + QPointF(56, 0))); // between 37.5 and 75 mm
}

void TestTargets::rulerMeasuresAHundredMillimetres()
{
    TargetSpec spec;
    const auto sheets = layOutTarget(spec);
    QVERIFY(sheets);
    const QImage image = painted(spec, sheets->front());
    const int row = int((sheets->front().paperMm.height() - targetMarginMm - 1) * pixelsAMillimetre);
    int first = image.width(), last = 0;
    for (int x = 0; x < int(115 * pixelsAMillimetre); ++x) {
        if (qGray(image.pixel(x, row)) < 160) {
            first = std::min(first, x);
            last = x;
        }
    }
    QVERIFY(std::abs((last + 1 - first) / pixelsAMillimetre - 100) < 0.6); // a pixel at each end
}

void TestTargets::refusesWithReason_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("rows");
    QTest::addColumn<double>("sizeMm");
    QTest::addColumn<QString>("message");
    const int board = int(TargetKind::Checkerboard), charuco = int(TargetKind::Charuco),
              tags = int(TargetKind::Tags);
    QTest::newRow("too large a board")
        << board << 9 << 6 << 40.0
        << QStringLiteral(
               "target: 400 by 280 mm do not fit on A4; make the squares at most 25 mm, or use larger paper");
    QTest::newRow("too large a tag")
        << tags << 9 << 6 << 200.0
        << QStringLiteral(
               "target: 250 by 250 mm do not fit on A4; make it at most 155 mm, or use larger paper");
    QTest::newRow("two corners")
        << board << 9 << 2 << 25.0
        << QStringLiteral("target: a board has 3 to 30 inner corners each way; give a size such as 9x6");
    QTest::newRow("even rows of ChArUco")
        << charuco << 8 << 5 << 25.0
        << QStringLiteral(
               "target: programs number a ChArUco board with 6 rows of squares in two different ways; "
               "use an even number of rows of inner corners, such as 9x6");
    QTest::newRow("no size")
        << board << 9 << 6 << 0.0
        << QStringLiteral("target: its size is not a length; give the side of a square, such as 25mm");
}

void TestTargets::refusesWithReason()
{
    QFETCH(int, kind);
    QFETCH(int, columns);
    QFETCH(int, rows);
    QFETCH(double, sizeMm);
    QFETCH(QString, message);
    TargetSpec spec;
    spec.kind = TargetKind(kind);
    spec.columns = columns;
    spec.rows = rows;
    spec.squareM = spec.markerM = fromMillimetres(sizeMm);
    const auto sheets = layOutTarget(spec);
    QVERIFY(!sheets);
    QCOMPARE(QString::fromStdString(sheets.error().message()), message);
}

void TestTargets::writesAPageForEachMarker()
{
    QTemporaryDir folder;
    TargetSpec spec;
    spec.kind = TargetKind::Tags;
    const QString file = folder.filePath(QStringLiteral("markers.pdf"));
    const auto written = writeTargetPdf(spec, file.toStdString());
    QVERIFY2(written, written ? "" : written.error().message().c_str());
    QFile pdf(file);
    QVERIFY(pdf.open(QIODevice::ReadOnly));
    const QByteArray bytes = pdf.readAll();
    QVERIFY(bytes.startsWith("%PDF-"));
    QVERIFY(bytes.contains("/Count 4"));
    QVERIFY(bytes.contains("/MediaBox [0 0 595.000000 842.000000]") || bytes.contains("/MediaBox [0 0 595"));
}

void TestTargets::leavesNothingHalfWritten()
{
    QTemporaryDir folder;
    const auto written =
        writeTargetPdf({}, folder.filePath(QStringLiteral("not there/board.pdf")).toStdString());
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::NotFound);
    QVERIFY(QDir(folder.path()).isEmpty());
}

void TestTargets::dialogTellsWhatDoesNotFit()
{
    TargetDialog dialog(TargetKind::Tags, {QStringLiteral("A"), QStringLiteral("B")});
    QCOMPARE(dialog.spec().labels, QStringList({QStringLiteral("A"), QStringLiteral("B")}));
    auto *size = dialog.findChildren<QDoubleSpinBox *>().at(1);
    size->setValue(300);
    bool told = false;
    for (const QLabel *label : dialog.findChildren<QLabel *>())
        told = told || label->text().contains(QStringLiteral("do not fit"));
    QVERIFY(told);
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("a.pdf"));
    QVERIFY(!dialog.savePdf({file.toStdString(), file}));
    size->setValue(100);
    QVERIFY(dialog.savePdf({file.toStdString(), file}));
}

ODOGRAPH_TEST(TestTargets, QApplication)
#include "tst_targets.moc"
