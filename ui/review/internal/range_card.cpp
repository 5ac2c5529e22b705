// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/internal/range_card.h"

#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/profile_chart.h"
#include "ui/views/charts/trial_curves.h"
#include "ui/views/widgets/fact_list.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

namespace odo {

RangeReport reportOf(const RangeRequest &request)
{
    const Profile &profile = request.scene->robots.at(request.robot).analysis->profile;
    const std::vector<const Profile *> others = otherProfiles(*request.scene, request.robot);
    RangeReport report{request, pathWithin(profile, request.span), {}, {}};
    for (const Quantity quantity : request.quantities)
        report.statistics.push_back(statisticsOf(profile, quantity, request.span, others));
    if (request.shape)
        report.fit = fitQuantity(profile, request.fitted, request.span, *request.shape, others);
    return report;
}

RangeReporter::RangeReporter(QObject *parent) : QObject(parent)
{
    connect(&m_task, &BackgroundTask::finished, this, &RangeReporter::finish);
}

void RangeReporter::request(RangeRequest request)
{
    m_isForgotten = false;
    m_wanted = std::move(request);
    if (!m_task.isRunning())
        begin();
}

void RangeReporter::forget()
{
    m_wanted.reset();
    m_isForgotten = true;
}

void RangeReporter::begin()
{
    m_result = std::make_shared<RangeReport>();
    m_task.start([request = *std::exchange(m_wanted, std::nullopt),
                  result = m_result](const JobControl &) -> Result<void> {
        *result = reportOf(request);
        return {};
    });
}

void RangeReporter::finish()
{
    // Shows what is known already although something newer was requested, to update during a drag.
    if (!m_isForgotten)
        Q_EMIT reported(*m_result);
    if (m_wanted)
        begin();
}

namespace {
constexpr int noFit = -1;
}

RangeCard::RangeCard(Timeline &timeline, QWidget *parent)
    : Card(tr("Selection"), parent), m_timeline(timeline), m_reporter(new RangeReporter(this)),
      m_robot(new QComboBox(this)), m_shape(new QComboBox), m_fitted(new QComboBox), m_facts(new FactList)
{
    makeChoices();
    auto *fit = new QHBoxLayout;
    fit->setContentsMargins(10, 8, 10, 4);
    fit->setSpacing(8);
    auto *name = new QLabel(tr("&Fit"));
    name->setBuddy(m_shape);
    fit->addWidget(name);
    fit->addWidget(m_shape, 1);
    fit->addWidget(m_fitted, 1);
    auto *content = new QWidget;
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(fit);
    QScrollArea *scroll = scrolled(m_facts, tr("Statistics of the selection"));
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout->addWidget(scroll, 1);
    setContent(content);
    addToHeader(m_robot);
    setVisible(false);
    connect(&m_timeline, &Timeline::selectionChanged, this, &RangeCard::request);
    connect(m_reporter, &RangeReporter::reported, this, &RangeCard::show);
    for (QComboBox *choice : {m_robot, m_shape, m_fitted})
        connect(choice, &QComboBox::currentIndexChanged, this, &RangeCard::request);
}

void RangeCard::makeChoices()
{
    m_robot->setAccessibleName(tr("Robot of the statistics"));
    m_robot->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_shape->setAccessibleName(tr("Function to fit to the curve"));
    m_shape->addItem(tr("none"), noFit);
    m_shape->addItem(tr("constant"), static_cast<int>(FitShape::Constant));
    m_shape->addItem(tr("straight line"), static_cast<int>(FitShape::Line));
    m_shape->addItem(tr("parabola"), static_cast<int>(FitShape::Parabola));
    m_fitted->setAccessibleName(tr("Fitted quantity"));
    for (QComboBox *choice : {m_shape, m_fitted})
        choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
}

void RangeCard::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    {
        const QSignalBlocker quiet(m_robot);
        m_robot->clear();
        for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot)
            if (m_scene->robots[robot].analysis)
                m_robot->addItem(QString::fromStdString(m_scene->robots[robot].robot.name), int(robot));
    }
    m_robot->setVisible(m_robot->count() > 1);
    request();
}

void RangeCard::setQuantities(const QList<Quantity> &quantities)
{
    m_quantities.clear();
    for (const Quantity quantity : quantities)
        if (!m_quantities.contains(quantity))
            m_quantities << quantity;
    {
        const QSignalBlocker quiet(m_fitted);
        const QVariant chosen = m_fitted->currentData();
        m_fitted->clear();
        for (const Quantity quantity : std::as_const(m_quantities))
            m_fitted->addItem(quantityName(quantity), static_cast<int>(quantity));
        m_fitted->setCurrentIndex(std::max(0, m_fitted->findData(chosen)));
    }
    request();
}

void RangeCard::request()
{
    if (!m_timeline.selection() || m_robot->count() == 0 || m_quantities.isEmpty()) {
        m_reporter->forget();
        setShown(false);
        Q_EMIT fitChanged(std::nullopt);
        return;
    }
    RangeRequest wanted{m_scene, static_cast<std::size_t>(m_robot->currentData().toInt()),
                        *m_timeline.selection(), m_quantities};
    wanted.fitted = static_cast<Quantity>(m_fitted->currentData().toInt());
    if (const int shape = m_shape->currentData().toInt(); shape != noFit)
        wanted.shape = static_cast<FitShape>(shape);
    m_fitted->setEnabled(wanted.shape.has_value());
    m_reporter->request(std::move(wanted));
    setShown(true);
}

void RangeCard::show(const RangeReport &report)
{
    if (report.request.scene != m_scene)
        return;
    m_facts->setFacts(fitFacts(report) + rangeFacts(report));
    std::optional<FitOverlay> overlay;
    if (report.fit && *report.fit)
        overlay = FitOverlay{report.request.robot, report.request.fitted, report.request.span, **report.fit};
    Q_EMIT fitChanged(overlay);
}

void RangeCard::setShown(bool isShown)
{
    if (isShown == isVisibleTo(parentWidget()))
        return;
    setVisible(isShown);
    Q_EMIT shownChanged(isShown);
}

namespace {

class RangeFactsWords
{
    Q_DECLARE_TR_FUNCTIONS(RangeFacts)
};

bool isPosition(Quantity quantity)
{
    return quantity == Quantity::PositionX || quantity == Quantity::PositionY;
}
bool isAngle(Quantity quantity)
{
    return quantity == Quantity::Heading || quantity == Quantity::TurnRate;
}

/// How many times its unit is over a second.
int timesDerived(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Speed:
    case Quantity::TurnRate:
    case Quantity::VelocityX:
    case Quantity::VelocityY:
        return 1;
    case Quantity::Acceleration:
    case Quantity::LateralAcceleration:
        return 2;
    case Quantity::Jerk:
        return 3;
    default:
        return 0;
    }
}

/// The unit of a quantity over seconds to a power of 0, 1 or 2.
QString unitOver(Quantity quantity, int power)
{
    static const QString powers[] = {{},
                                     QStringLiteral("/s"),
                                     QStringLiteral("/s²"),
                                     QStringLiteral("/s³"),
                                     QStringLiteral("/s⁴"),
                                     QStringLiteral("/s⁵")};
    // "cm/s" as a person wants it, without what it is over.
    const QString base = curveUnit(quantity).section(u'/', 0, 0);
    return base + powers[timesDerived(quantity) + power];
}

QString valueText(Quantity quantity, const CurveValue &value, int power = 0)
{
    const double factor = curveFactor(quantity);
    return numberText(factor * value.value, factor * value.sigma, unitOver(quantity, power)).text();
}

QStringList inputsOf(const RangeReport &report)
{
    const RangeRequest &request = report.request;
    QStringList inputs{RangeFactsWords::tr("from %1 to %2")
                           .arg(secondsText(request.span.begin), secondsText(request.span.end))};
    return inputs + analysisInputs(*request.scene, request.robot);
}

/// What is common to all points of a curve, in words.
QString calibrationPart(Quantity quantity)
{
    if (isAngle(quantity))
        return RangeFactsWords::tr("The calibration's contribution to an angle is unknown and not included.");
    return isPosition(quantity) ? RangeFactsWords::tr("Includes the position uncertainty of the calibration.")
                                : RangeFactsWords::tr("Includes the scale uncertainty of the calibration.");
}

QString smoothedPart()
{
    return RangeFactsWords::tr(
        "Neighbouring points of a smoothed curve have correlated errors. They average out over time, not "
        "over frames: with a spectrum of r/(1 + (ω/ω₀)⁶) for the position, ω₀ = √2 σv/σx.");
}

Explanation explainStatistics(const RangeReport &report, Quantity quantity, const QString &value)
{
    return {quantityName(quantity),
            value,
            RangeFactsWords::tr(
                "From the smoothed curve, each value weighted by half the time to both neighbours: mean; "
                "median (the curve is below it half of the time); least and most, chosen by value + 2σ and "
                "value − 2σ; spread √(mean of the squared distance from the mean)."),
            smoothedPart() + u' ' + calibrationPart(quantity),
            inputsOf(report),
            {}};
}

/// The quantity's name with how its metrics were computed, then a line a metric.
QList<Fact> statisticsFacts(const RangeReport &report, Quantity quantity,
                            const std::optional<RangeStatistics> &statistics)
{
    if (!statistics)
        return {{quantityName(quantity), RangeFactsWords::tr("no value here"), {}}};
    const auto timed = [&](const TimedValue &value) {
        return RangeFactsWords::tr("%1 at %2")
            .arg(valueText(quantity, value.value), secondsText(fromSeconds(value.timeS)));
    };
    const QList<Fact> lines{{RangeFactsWords::tr("mean"), valueText(quantity, statistics->mean), {}},
                            {RangeFactsWords::tr("median"), valueText(quantity, statistics->median), {}},
                            {RangeFactsWords::tr("least"), timed(statistics->least), {}},
                            {RangeFactsWords::tr("most"), timed(statistics->most), {}},
                            {RangeFactsWords::tr("spread"), valueText(quantity, statistics->spread), {}}};
    QStringList words;
    for (const Fact &line : lines)
        words << line.name + u' ' + line.value;
    Fact head{quantityName(quantity),
              RangeFactsWords::tr("%n points", nullptr, static_cast<int>(statistics->points)),
              {}};
    head.how = explainStatistics(report, quantity, words.join(QStringLiteral(", ")));
    return QList<Fact>{head} + lines;
}

QString verdictText(const CurveFit &fit, Quantity quantity)
{
    const QString ratio = QLocale().toString(fit.reducedChiSquared(), 'g', 2);
    const FitVerdict verdict = verdictOf(fit);
    if (verdict == FitVerdict::Departs)
        return RangeFactsWords::tr("does not fit: χ² is %1 times what the uncertainties explain").arg(ratio);
    // A smoothed curve always lies closer: the smoother allows for more motion than there is.
    if (verdict == FitVerdict::Closer && isPosition(quantity))
        return RangeFactsWords::tr(
                   "fits; the stated uncertainties are too large: χ² is %1 of its expected value")
            .arg(ratio);
    return RangeFactsWords::tr("fits: χ² is %1 of its expected value").arg(ratio);
}

Explanation explainFit(const RangeReport &report, const CurveFit &fit, const QString &value)
{
    const Quantity quantity = report.request.fitted;
    Explanation explanation{
        RangeFactsWords::tr("Fit of %1").arg(quantityName(quantity)),
        value,
        RangeFactsWords::tr(
            "The polynomial in t − t₀ that minimises Σ(residual/σ)² over %1, t₀ = %2. χ² is that sum divided "
            "by its expected value: the number of points minus the degrees of freedom of the coefficients.")
            .arg(isPosition(quantity) ? RangeFactsWords::tr("the measured positions used")
                                      : RangeFactsWords::tr("the smoothed curve"),
                 secondsText(fromSeconds(fit.originS))),
        {},
        inputsOf(report),
        QStringLiteral("Aitken 1935")};
    explanation.uncertainty =
        isPosition(quantity)
            ? RangeFactsWords::tr("The larger of two uncertainties: that of the measurements, widened by 1 + "
                                  "2Σρ for correlated residuals (here ×%1), and that of the smoothed curve, "
                                  "including the errors that persist.")
                  .arg(QLocale().toString(fit.neighbourFactor, 'g', 3))
            : smoothedPart();
    explanation.uncertainty +=
        u' ' + calibrationPart(quantity) + u' ' +
        RangeFactsWords::tr("Assumes that the shape is correct; χ² far above 1 shows that it is not. χ² "
                            "below 1 means that the smoother allows for more motion than the robot made.");
    explanation.inputs.prepend(RangeFactsWords::tr("%1 points").arg(fit.points));
    return explanation;
}

} // namespace

QList<Fact> rangeFacts(const RangeReport &report)
{
    const TimeSpan &span = report.request.span;
    QList<Fact> facts{
        {RangeFactsWords::tr("Time"),
         RangeFactsWords::tr("%1 to %2: %3")
             .arg(secondsText(span.begin), secondsText(span.end), secondsText(span.end - span.begin)),
         {}}};
    if (report.path) {
        const ShownUnit &unit = shownUnits().distance;
        const QString text =
            numberText(unit.perSi * report.path->value, unit.perSi * report.path->sigma, unit.name).text();
        Explanation how = explainMetric(*report.request.scene, report.request.robot,
                                        {"path_length", "m", report.path->value, report.path->sigma});
        how.inputs = inputsOf(report);
        facts.append({RangeFactsWords::tr("Path"), text, {}, how});
    }
    for (qsizetype i = 0; i < report.request.quantities.size(); ++i)
        facts += statisticsFacts(report, report.request.quantities[i],
                                 report.statistics[static_cast<std::size_t>(i)]);
    return facts;
}

QList<Fact> fitFacts(const RangeReport &report)
{
    if (!report.fit)
        return {};
    if (!*report.fit)
        return {{RangeFactsWords::tr("Fit"), errorLine((*report.fit).error()), {}}};
    const CurveFit &fit = **report.fit;
    const Quantity quantity = report.request.fitted;
    const auto coefficient = [&](int power) {
        return valueText(quantity, {fit.coefficients[power], fit.sigma(power)}, power);
    };
    const QString start = fit.shape == FitShape::Constant
                              ? RangeFactsWords::tr("value")
                              : RangeFactsWords::tr("at %1").arg(secondsText(fromSeconds(fit.originS)));
    QList<Fact> lines{{start, coefficient(0), {}}};
    if (fit.shape == FitShape::Line)
        lines.append({RangeFactsWords::tr("slope"), coefficient(1), {}});
    if (fit.shape == FitShape::Parabola) {
        lines.append({RangeFactsWords::tr("slope there"), coefficient(1), {}});
        lines.append({RangeFactsWords::tr("times t²"), coefficient(2), {}});
    }
    lines.append(
        {RangeFactsWords::tr("residual"),
         RangeFactsWords::tr("%1 (RMS)")
             .arg(numberText(curveFactor(quantity) * fit.rms, std::nullopt, curveUnit(quantity)).text()),
         {}});
    QStringList words;
    for (const Fact &line : std::as_const(lines))
        words << line.name + u' ' + line.value;
    Fact verdict{
        RangeFactsWords::tr("Fit of %1").arg(quantityName(quantity)), verdictText(fit, quantity), {}};
    verdict.how = explainFit(report, fit, words.join(QStringLiteral(", ")));
    return QList<Fact>{verdict} + lines;
}

} // namespace odo
