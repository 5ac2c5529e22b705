// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/certificate_report.h"

#include "core/analysis/quantity_curve.h"
#include "core/project/project.h"
#include "core/workflow/known_truth.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/report/internal/report_painting.h"
#include "ui/report/internal/truth_map.h"
#include "ui/views/charts/chart_image.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

namespace {

class CertificateWords
{
    Q_DECLARE_TR_FUNCTIONS(Certificate)
};

QString decimalText(double value, int count)
{
    return QLocale().toString(value, 'f', count);
}

/// "98 %"
QString shareText(double share)
{
    return decimalText(100 * share, 0) + QStringLiteral(" %");
}

/// A quantity whose errors are shown, in millimetres or inches and seconds.
struct ShownQuantity
{
    QString name;
    CertificateErrors figure;
    QString perTime; ///< "/s" behind the unit of lengths

    QString unit() const { return shownUnits().length.name + perTime; }
    double perSi() const { return shownUnits().length.perSi; }
    QString text(double value) const { return numberText(perSi() * value, std::nullopt, unit()).text(); }
};

QList<ShownQuantity> shownQuantities(const CertificateOutcome &outcome)
{
    const QString perS = QStringLiteral("/s"), perS2 = QStringLiteral("/s²");
    return {{CertificateWords::tr("Position"), outcome.position, {}},
            {CertificateWords::tr("Velocity"), outcome.velocity, perS},
            {CertificateWords::tr("Speed"), outcome.speed, perS},
            {CertificateWords::tr("Acceleration"), outcome.acceleration, perS2},
            {CertificateWords::tr("Amount of acceleration"), outcome.accelerationAmount, perS2}};
}

/// What is painted on both pages.
class CertificatePainter
{
public:
    CertificatePainter(QPainter &painter, const CertificateContent &content, const ReportOptions &options)
        : m_painter(painter), m_content(content), m_options(options)
    {
    }
    void paintResults(const QRectF &sheet);
    void paintErrors(const QRectF &sheet);

private:
    QRectF paintFrame(const QRectF &sheet, const QString &title);
    double paintText(const QRectF &rect, const QString &title, const QStringList &paragraphs);
    void paintMap(const QRectF &rect);
    void paintTable(const QRectF &rect);
    QString simulatedWords() const;
    QStringList limitWords() const;
    QStringList remarkWords() const;
    ReportTable camerasTable() const;
    void paintErrorChart(const QRectF &rect, int quantity);

    QPainter &m_painter;
    const CertificateContent &m_content;
    const ReportOptions &m_options;
};

QRectF CertificatePainter::paintFrame(const QRectF &sheet, const QString &title)
{
    const CertificateSetUp &setUp = m_content.setUp;
    QStringList cameras;
    for (const CertificateCamera &camera : setUp.cameras)
        cameras << literalName(camera.name);
    QStringList facts{literalName(setUp.title),
                      CertificateWords::tr("Cameras: %1").arg(cameras.join(QStringLiteral(", "))),
                      CertificateWords::tr("Robot: %1").arg(literalName(setUp.robot.name))};
    if (setUp.task)
        facts << CertificateWords::tr("Task: %1").arg(literalName(setUp.task->name));
    const QString foot =
        CertificateWords::tr("Simulated %1, Odograph %2. All errors are against the known truth of the "
                             "simulation.")
            .arg(shortDate(m_content.made), QString::fromStdString(m_content.outcome.softwareVersion));
    return drawFoot(m_painter, drawHead(m_painter, sheet, m_options.letterhead, title, facts),
                    m_options.letterhead, {foot});
}

/// A part of paragraphs; gives the height used.
double CertificatePainter::paintText(const QRectF &rect, const QString &title, const QStringList &paragraphs)
{
    QRectF area = drawPartTitle(m_painter, rect, title);
    for (const QString &paragraph : paragraphs)
        area.setTop(area.top() + 2 +
                    drawParagraph(m_painter, area, paragraph, reportFont(smallSize + 1),
                                  ThemeColours::of(reportPalette()).text));
    return area.top() - rect.top();
}

QString CertificatePainter::simulatedWords() const
{
    const CertificateOutcome &outcome = m_content.outcome;
    const QString course =
        m_content.setUp.task
            ? CertificateWords::tr("along the course of the task")
            : CertificateWords::tr("over the floor that the cameras see: straight, a curve, stop and go");
    QString words = CertificateWords::tr("%n simulated run(s) of %1 s and %2 at up to %3, %4.", "",
                                         int(outcome.runs.size()))
                        .arg(decimalText(outcome.durationS, 1), distanceText(outcome.lengthM),
                             speedText(outcome.topSpeedMps, std::nullopt), course);
    words += u' ' + CertificateWords::tr(
                        "The views of each camera were rendered with its lens, position, image size and "
                        "frame rate, written "
                        "as videos, and imported, synchronised, tracked and analysed as any others.");
    if (std::ranges::any_of(m_content.setUp.cameras, &CertificateCamera::isUncertaintyKnown))
        words += u' ' + CertificateWords::tr(
                            "In each run the cameras are a little off from where the project has them, drawn "
                            "from the stated uncertainty of their registration and lens calibration; so the "
                            "errors include it.");
    return words;
}

QStringList CertificatePainter::limitWords() const
{
    return {
        CertificateWords::tr(
            "A simulation shows what this geometry and this program can do, not what a certain recording "
            "did. It has even light, a still camera, a clean floor with the markers, sensor noise of 2 of "
            "255 and an exposure of 8 ms at most, and a robot of simple solids in its colour and size."),
        CertificateWords::tr(
            "It does not cover flicker, reflections, deep shadows and people in the view; the look of the "
            "real robot, cables and hands; a camera that was moved; markers that were measured wrongly; "
            "rolling shutters; and errors of lens calibration and registration beyond the stated ones."),
        CertificateWords::tr("The verdict on a trial says which of these were noticed in its recording.")};
}

void CertificatePainter::paintMap(const QRectF &rect)
{
    const CertificateOutcome &outcome = m_content.outcome;
    const double enlarged = drawTruthMap(
        m_painter, rect.adjusted(0, 21, 0, 0), outcome.bounds, m_content.setUp.cameras.front().layout,
        m_content.setUp.task ? &m_content.setUp.task->task : nullptr, outcome.runs);
    drawPartTitle(m_painter, rect, CertificateWords::tr("The known run from above"),
                  CertificateWords::tr("dashed: truth; strokes: errors of all runs, enlarged %1 times")
                      .arg(decimalText(enlarged, 0)));
}

void CertificatePainter::paintTable(const QRectF &rect)
{
    ReportTable table;
    table.header = {QString(), CertificateWords::tr("root mean square"), CertificateWords::tr("95 % below"),
                    CertificateWords::tr("stated ± (σ)"),
                    CertificateWords::tr("truth inside the stated 95 %")};
    table.weights = {0.28, 0.18, 0.18, 0.16, 0.2};
    table.alignments = QList<Qt::Alignment>{Qt::AlignLeft} + QList<Qt::Alignment>(4, Qt::AlignRight);
    for (const ShownQuantity &each : shownQuantities(m_content.outcome)) {
        const CertificateErrors &figure = each.figure;
        table.rows << ReportTable::Row{{each.name, each.text(figure.rms), each.text(figure.p95),
                                        figure.sigma ? each.text(*figure.sigma) : QStringLiteral("–"),
                                        figure.covered ? shareText(*figure.covered) : QStringLiteral("–")},
                                       false,
                                       false};
    }
    const QRectF area = drawPartTitle(m_painter, rect, CertificateWords::tr("Errors against the truth"),
                                      CertificateWords::tr("%1 of %2 frames have a result")
                                          .arg(m_content.outcome.compared)
                                          .arg(m_content.outcome.frames));
    drawTable(m_painter, area, table);
}

void CertificatePainter::paintResults(const QRectF &sheet)
{
    constexpr double metricsHeight = 62, tableHeight = 118, gap = 10, textHeight = 104, limitsHeight = 128;
    QRectF area = paintFrame(sheet, CertificateWords::tr("Certificate of this set-up"));
    const QList<ShownQuantity> all = shownQuantities(m_content.outcome);
    const auto metric = [](const QString &name, const ShownQuantity &of) {
        return ReportMetric{name, numberText(of.perSi() * of.figure.rms, std::nullopt, of.unit()),
                            CertificateWords::tr("root mean square")};
    };
    drawMetrics(
        m_painter, QRectF(area.left(), area.top(), area.width(), metricsHeight),
        {metric(CertificateWords::tr("Position error"), all[0]),
         metric(CertificateWords::tr("Velocity error"), all[1]),
         metric(CertificateWords::tr("Acceleration error"), all[3]),
         {CertificateWords::tr("Coverage"),
          {decimalText(100 * m_content.outcome.position.covered.value_or(0), 0), {}, QStringLiteral("%")},
          CertificateWords::tr("true positions inside the stated 95 %")}});
    area.setTop(area.top() + metricsHeight + gap);
    area.setTop(area.top() + gap +
                paintText(QRectF(area.left(), area.top(), area.width(), textHeight),
                          CertificateWords::tr("What was simulated"), {simulatedWords()}));
    const QRectF limits(area.left(), area.bottom() - limitsHeight, area.width(), limitsHeight);
    paintText(limits, CertificateWords::tr("What a simulation does not cover"), limitWords());
    const QRectF table(area.left(), limits.top() - gap - tableHeight, area.width(), tableHeight);
    paintTable(table);
    area.setBottom(table.top() - gap);
    paintMap(area);
}

/// One of the errors of a run at its samples, in the unit that is shown, with what is stated for 95 %.
struct ErrorAt
{
    double error = 0, stated = 0;
};

std::optional<ErrorAt> errorAt(const CertificateRun &run, std::size_t i, int quantity)
{
    constexpr double radius95 = 2.447747; // of two coordinates of one σ
    const ProfilePoint &point = run.profile.points[i];
    const auto truth = truthAt(run.truth, run.profile.samples[i].time);
    if (!point.valid || !truth)
        return std::nullopt;
    if (quantity == 0)
        return ErrorAt{(point.position - run.truth.positions[*truth]).norm(),
                       radius95 * std::hypot(point.sigmaXM, point.sigmaYM) / std::sqrt(2.0)};
    if (quantity == 1)
        return ErrorAt{std::abs(point.speedMps - run.truth.velocities[*truth].norm()),
                       coverage95 * point.sigmaSpeedMps};
    return ErrorAt{std::abs(point.accelMps2 - run.truth.accelerations[*truth].norm()),
                   coverage95 * point.sigmaAccelMps2};
}

/// The errors of all runs, and dashed what the first states.
std::vector<ChartCurve> errorCurves(const CertificateOutcome &outcome, int quantity, double perSi)
{
    std::vector<ChartCurve> curves;
    for (std::size_t number = 0; number < outcome.runs.size(); ++number) {
        const CertificateRun &run = outcome.runs[number];
        ChartCurve errors, stated;
        errors.position = int(number);
        errors.widthPx = 1;
        stated.ink = ChartInk::Text;
        stated.dash = Qt::DashLine;
        stated.widthPx = 1.2;
        bool isOpen = false;
        for (std::size_t i = 0; i < run.profile.points.size(); ++i) {
            const auto at = errorAt(run, i, quantity);
            if (at && !isOpen)
                for (ChartCurve *curve : {&errors, &stated})
                    curve->runs.emplace_back();
            isOpen = at.has_value();
            if (!at)
                continue;
            const double timeS = toSeconds(run.profile.samples[i].time);
            errors.runs.back().points.emplace_back(timeS, CurveValue{perSi * at->error, 0});
            stated.runs.back().points.emplace_back(timeS, CurveValue{perSi * at->stated, 0});
        }
        for (ChartCurve *curve : {&errors, &stated})
            std::erase_if(curve->runs, [](const CurveRun &one) { return !one.isLine(); });
        curves.push_back(std::move(errors));
        if (number == 0)
            curves.push_back(std::move(stated));
    }
    return curves;
}

void CertificatePainter::paintErrorChart(const QRectF &rect, int quantity)
{
    const QList<ShownQuantity> all = shownQuantities(m_content.outcome);
    const ShownQuantity &shown = all[quantity == 0 ? 0 : quantity == 1 ? 2 : 4];
    const QRectF area =
        drawPartTitle(m_painter, rect, CertificateWords::tr("%1, error in %2").arg(shown.name, shown.unit()),
                      CertificateWords::tr("a line for each run; dashed: what the first states for 95 %"));
    auto content = std::make_shared<ChartContent>();
    content->curves = errorCurves(m_content.outcome, quantity, shown.perSi());
    content->range = {0, 1e-3};
    for (const ChartCurve &curve : content->curves)
        for (const CurveRun &run : curve.runs)
            for (const BandPoint &point : run.points)
                content->range.high = std::max(content->range.high, double(point.value));
    ChartDrawing drawing;
    drawing.content = std::move(content);
    drawing.axes.left = shown.unit();
    drawing.high = m_content.outcome.durationS;
    drawChart(m_painter, area, drawing, reportPalette(), reportFont(smallSize));
}

ReportTable CertificatePainter::camerasTable() const
{
    ReportTable table;
    table.header = {CertificateWords::tr("Camera"), CertificateWords::tr("Frames"),
                    CertificateWords::tr("Lens calibration"), CertificateWords::tr("Registration"),
                    CertificateWords::tr("σ on the floor")};
    table.weights = {0.18, 0.26, 0.2, 0.22, 0.14};
    table.alignments = {Qt::AlignLeft, Qt::AlignLeft, Qt::AlignLeft, Qt::AlignRight, Qt::AlignRight};
    for (const CertificateCamera &camera : m_content.setUp.cameras) {
        const FloorRegistration &registration = camera.registration.registration;
        QString lens;
        switch (intrinsicsSourceOf(camera.intrinsics, camera.calibration.has_value())) {
        case IntrinsicsSource::Calibration:
            lens = CertificateWords::tr("calibrated");
            break;
        case IntrinsicsSource::Floor:
            lens = CertificateWords::tr("estimated from the floor");
            break;
        case IntrinsicsSource::Assumed:
            lens = CertificateWords::tr("assumed");
            break;
        }
        table.rows << ReportTable::Row{
            {literalName(camera.name),
             QStringLiteral("%1×%2, %3/s")
                 .arg(QString::number(camera.widthPx), QString::number(camera.heightPx),
                      decimalText(camera.framesPerSecond, 2)),
             lens,
             QStringLiteral("%1 px, %2")
                 .arg(decimalText(registration.rmsPx, 2), lengthText(registration.rmsM)),
             registration.floorSigmaM > 0 ? lengthText(registration.floorSigmaM) : QStringLiteral("–")},
            false,
            false};
    }
    return table;
}

QStringList CertificatePainter::remarkWords() const
{
    QStringList words;
    if (m_content.setUp.cameras.size() > 1)
        words << CertificateWords::tr("The views were synchronised by the motion, to %1 ms at worst.")
                     .arg(decimalText(1000 * m_content.outcome.largestSyncErrorS, 2));
    for (const Message &remark : m_content.outcome.remarks)
        words << literalName(fullSentence(shownWords(remark)));
    return words;
}

void CertificatePainter::paintErrors(const QRectF &sheet)
{
    constexpr double gap = 10, rowHeight = 15, titleHeight = 21, leastChart = 120, remarksHeight = 120;
    QRectF area = paintFrame(sheet, CertificateWords::tr("Certificate of this set-up: errors over time"));
    const ReportTable cameras = camerasTable();
    const double camerasHeight =
        std::min(titleHeight + rowHeight * double(cameras.rows.size() + 1), area.height() / 4);
    const QRectF remarks(area.left(), area.bottom() - remarksHeight, area.width(), remarksHeight);
    paintText(remarks, CertificateWords::tr("Remarks"), remarkWords());
    const QRectF table(area.left(), remarks.top() - gap - camerasHeight, area.width(), camerasHeight);
    drawTable(m_painter, drawPartTitle(m_painter, table, CertificateWords::tr("The cameras")), cameras);
    area.setBottom(table.top() - gap);
    constexpr int charts = 3;
    const double height = std::max(leastChart, area.height() / charts);
    for (int quantity = 0; quantity < charts; ++quantity)
        paintErrorChart(QRectF(area.left(), area.top() + quantity * height, area.width(), height - gap),
                        quantity);
}

} // namespace

ReportMaker certificateReport(CertificateSettings settings, const ReportOptions &options,
                              std::function<void(const CertificateContentPtr &)> taken)
{
    return [settings = std::move(settings), options, taken = std::move(taken)](
               Project &project, const JobControl &control, const PageSink &sink) -> Result<void> {
        auto setUp = ODO_TRY(readCertificateSetUp(project, settings));
        auto outcome = ODO_TRY(makeCertificate(setUp, control));
        const auto content = std::make_shared<const CertificateContent>(
            CertificateContent{std::move(setUp), std::move(outcome), instantNow()});
        if (taken)
            taken(content);
        for (const ReportPage &page : certificatePages(content, options)) {
            if (control.isCancelled())
                return cancelled(certificateSubject());
            ODO_TRY(sink(page));
        }
        return {};
    };
}

ReportPages certificatePages(const CertificateContentPtr &content, const ReportOptions &options)
{
    const PageFormat format{options.paper, false};
    return {{format,
             [content, options, format](QPainter &painter) {
                 CertificatePainter(painter, *content, options).paintResults(format.content());
             }},
            {format, [content, options, format](QPainter &painter) {
                 CertificatePainter(painter, *content, options).paintErrors(format.content());
             }}};
}

} // namespace odo
