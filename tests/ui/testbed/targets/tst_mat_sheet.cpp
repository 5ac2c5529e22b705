// SPDX-License-Identifier: GPL-3.0-or-later
// The printed mat itself: its sheets are painted, laid on one another as the plan says, and seen by a camera.
#include "core/calibration/floor_mat.h"
#include "core/calibration/floor_registration.h"
#include "core/calibration/marker_detection.h"
#include "core/simulation/demo_testbed.h"
#include "tests/calibration/images.h"
#include "tests/support/registered_test.h"
#include "ui/testbed/targets/mat_sheet.h"
#include "ui/testbed/targets/target_sheet.h"

#include <QGuiApplication>
#include <QPainter>
#include <QTest>
#include <opencv2/imgproc.hpp>

using namespace odo;

namespace {

constexpr double pixelsPerMm = 4;
constexpr double marginMm = 1000 * matMarginM;

TargetSpec specOf(QPageSize::PageSizeId paper, int columns, int rows)
{
    TargetSpec spec;
    spec.kind = TargetKind::Mat;
    spec.paper = paper;
    spec.columns = columns;
    spec.rows = rows;
    return spec;
}

/// The mat from above, its margins around it.
QImage tapedTogether(const TargetSpec &spec)
{
    const FloorMat mat = matOf(spec);
    const Eigen::Vector2d sheetMm = 1000 * matSheetM(mat.paper);
    const QSizeF wholeMm(mat.columns * sheetMm.x() + 2 * marginMm, mat.rows * sheetMm.y() + 2 * marginMm);
    QImage image((wholeMm * pixelsPerMm).toSize(), QImage::Format_Grayscale8);
    image.fill(150); // the floor
    const auto sheets = layOutTarget(spec);
    QPainter painter(&image);
    painter.scale(pixelsPerMm, pixelsPerMm);
    for (const TargetSheet &sheet : *sheets) {
        if (sheet.tag < 0)
            continue; // the plan
        // What is cut off at the left and below where it is laid on others.
        QRectF paper(QPointF(0, 0), sheet.paperMm);
        if (sheet.column > 0)
            paper.setLeft(marginMm);
        if (sheet.row > 0)
            paper.setBottom(sheet.paperMm.height() - marginMm);
        painter.save();
        painter.translate(sheet.column * sheetMm.x(),
                          wholeMm.height() - sheet.paperMm.height() - sheet.row * sheetMm.y());
        painter.setClipRect(paper);
        painter.fillRect(paper, Qt::white);
        paintTarget(painter, spec, sheet);
        painter.restore();
    }
    return image;
}

/// What a camera sees of it on the floor, its lower left corner at the origin.
Frame seenBy(const FloorView &view, const QImage &mat)
{
    constexpr int parts = 3;
    const Intrinsics &lens = view.camera().intrinsics();
    cv::Mat image(lens.heightPx, lens.widthPx, CV_8UC1);
    const auto grey = [&](const Eigen::Vector2d &pointM) {
        const int x = int(std::floor((1000 * pointM.x() + marginMm) * pixelsPerMm));
        const int y = mat.height() - 1 - int(std::floor((1000 * pointM.y() + marginMm) * pixelsPerMm));
        return mat.valid(x, y) ? int(mat.constScanLine(y)[x]) : 150;
    };
    for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            int sum = 0;
            for (int part = 0; part < parts * parts; ++part) {
                const Eigen::Vector2d pixel(x - 0.5 + (part % parts + 0.5) / parts,
                                            y - 0.5 + (part / parts + 0.5) / parts);
                const auto point = view.floorFromPixel(pixel, 0);
                sum += point ? grey(*point) : 150;
            }
            image.at<std::uint8_t>(y, x) = std::uint8_t(sum / (parts * parts));
        }
    }
    cv::GaussianBlur(image, image, {0, 0}, 0.6);
    return frameOf(image);
}

/// The share of pixels of a sheet that are dark, within a rectangle in mm.
double darkness(const TargetSpec &spec, const TargetSheet &sheet, const QRectF &partMm)
{
    QImage image((sheet.paperMm * pixelsPerMm).toSize(), QImage::Format_Grayscale8);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(pixelsPerMm, pixelsPerMm);
    paintTarget(painter, spec, sheet);
    painter.end();
    const QRect part = QRectF(partMm.topLeft() * pixelsPerMm, partMm.size() * pixelsPerMm).toRect();
    int dark = 0;
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(); x <= part.right(); ++x)
            dark += image.constScanLine(y)[x] < 200;
    return double(dark) / (double(part.width()) * part.height());
}

} // namespace

class TestMatSheet : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aPlanAndEachSheet();
    void thePrintIsTheLayout_data();
    void thePrintIsTheLayout();
    void sheetsAreCutWhereTheyMeet();
    void theLineIsAsLongAsItSays();
    void refusesWhatHasNoNumbers();
};

void TestMatSheet::aPlanAndEachSheet()
{
    const TargetSpec spec = specOf(QPageSize::A3, 3, 2);
    const auto sheets = layOutTarget(spec);
    QVERIFY(sheets);
    QCOMPARE(sheets->size(), std::size_t(1 + 6));
    QCOMPARE(sheets->front().tag, -1);
    QVERIFY(sheets->front().ink.isEmpty());
    for (const TargetSheet &sheet : *sheets)
        QCOMPARE(sheet.paperMm, QSizeF(420, 297));
    QCOMPARE(sheets->back().column, 2);
    QCOMPARE(sheets->back().row, 1);
    QVERIFY(darkness(spec, sheets->front(), {20, 20, 380, 250}) > 0.001); // the plan is not empty
}

void TestMatSheet::thePrintIsTheLayout_data()
{
    QTest::addColumn<int>("paper");
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("rows");
    QTest::newRow("A4") << int(QPageSize::A4) << 4 << 3;
    QTest::newRow("Letter") << int(QPageSize::Letter) << 4 << 3;
    QTest::newRow("A3") << int(QPageSize::A3) << 3 << 2;
}

/// A mat that was put together by the plan is the layout that registers the camera.
void TestMatSheet::thePrintIsTheLayout()
{
    QFETCH(const int, paper);
    QFETCH(const int, columns);
    QFETCH(const int, rows);
    const TargetSpec spec = specOf(QPageSize::PageSizeId(paper), columns, rows);
    const FloorView view = simulatedView({0.3, -1.1, 1.6}, {0.55, 0.3, 0}, 1280, 720, 900);
    const Frame frame = seenBy(view, tapedTogether(spec));
    const auto mat = findMat(frame);
    QVERIFY(mat);
    QCOMPARE(*mat, matOf(spec));
    const MarkerLayout layout = matLayout(*mat);
    const auto pixels = findMarkers(frame, layout, {view.camera(), true, {}});
    QVERIFY2(pixels, pixels ? "" : pixels.error().message().c_str());
    QCOMPARE(pixels->size(), layout.markers.size());
    const auto registration = registerFloor(layout, *pixels, view.camera(), true);
    QVERIFY(registration);
    // The raster is of 0.25 mm; a marker's middle lies within a part of it.
    QVERIFY2(registration->rmsM < 0.0002, std::to_string(registration->rmsM).c_str());
    const Eigen::Vector3d off = registration->worldFromCamera.translation - view.cameraInWorld();
    QVERIFY2(off.norm() < 0.003, std::to_string(off.norm()).c_str());
}

void TestMatSheet::sheetsAreCutWhereTheyMeet()
{
    const TargetSpec spec = specOf(QPageSize::A4, 2, 2);
    const auto sheets = layOutTarget(spec);
    const double width = 297, height = 210, edge = 0.6;
    const auto sides = [&](const TargetSheet &sheet) {
        const QRectF left(marginMm - edge / 2, 40, edge, 20),
            right = left.translated(width - 2 * marginMm, 0), top(100, marginMm - edge / 2, 20, edge),
            bottom = top.translated(0, height - 2 * marginMm);
        std::vector<bool> marked;
        for (const QRectF &side : {left, right, top, bottom})
            marked.push_back(darkness(spec, sheet, side) > 0.1);
        return marked;
    };
    using Sides = std::vector<bool>; // left, right, top, bottom
    QCOMPARE(sides((*sheets)[1]), (Sides{false, true, true, false}));
    QCOMPARE(sides((*sheets)[2]), (Sides{true, false, true, false}));
    QCOMPARE(sides((*sheets)[3]), (Sides{false, true, false, true}));
    QCOMPARE(sides((*sheets)[4]), (Sides{true, false, false, true}));
}

void TestMatSheet::theLineIsAsLongAsItSays()
{
    const TargetSpec spec = specOf(QPageSize::A4, 4, 3);
    const QImage mat = tapedTogether(spec);
    // Its two end marks are the only ink 2 mm above and below it near the mat's lower edge.
    const auto isDark = [&](double xMm, double yMm) {
        const int x = int((xMm + marginMm) * pixelsPerMm),
                  y = mat.height() - 1 - int((yMm + marginMm) * pixelsPerMm);
        return mat.constScanLine(y)[x] < 200; // a hairline may share two rows
    };
    std::vector<double> marks;
    for (double x = 0; x < 1100; x += 0.25)
        if (isDark(x, 1000 * matLineStartM.y() + 2) && isDark(x, 1000 * matLineStartM.y() - 2))
            marks.push_back(x);
    QVERIFY(!marks.empty());
    QVERIFY2(std::abs(marks.back() - marks.front() - 1000) <= 0.5,
             std::to_string(marks.back() - marks.front()).c_str());
    int along = 0;
    for (double x = marks.front(); x < marks.back(); x += 0.25)
        along += isDark(x, 1000 * matLineStartM.y());
    QVERIFY(along > 0.99 * 4000); // without a gap over the joints
}

void TestMatSheet::refusesWhatHasNoNumbers()
{
    QVERIFY(layOutTarget(specOf(QPageSize::A4, 10, 8)));
    for (const auto &[columns, rows] :
         {std::pair(11, 3), std::pair(4, 9), std::pair(0, 3), std::pair(4, 0)}) {
        const auto refused = layOutTarget(specOf(QPageSize::A4, columns, rows));
        QVERIFY(!refused);
        QCOMPARE(refused.error().message(),
                 std::string("floor mat: a mat has 1 to 10 sheets in a row and 1 to 8 rows; give a size such "
                             "as 4x3"));
    }
}

ODOGRAPH_TEST(TestMatSheet, QGuiApplication)
#include "tst_mat_sheet.moc"
