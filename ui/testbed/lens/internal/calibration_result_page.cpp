// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/internal/calibration_result_page.h"

#include "core/base/shortage.h"
#include "core/workflow/job.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/lens/internal/lens_drawings.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

Result<LensAnswer> answerTo(const LensQuestion &question, const JobControl &control)
{
    auto calibration =
        ODO_TRY(question.reference ? recalibrate(*question.reference, question.chosen, control)
                                   : calibrateIntrinsics(question.views, question.size.width(),
                                                         question.size.height(), question.model, control));
    QImage image = straightened(question.example, calibration.intrinsics);
    return LensAnswer{std::move(calibration), std::move(image)};
}

} // namespace

LensSolver::~LensSolver()
{
    cancel();
    if (m_thread.joinable())
        m_thread.join();
}

void LensSolver::solve(LensQuestion question)
{
    cancel();
    m_next = std::move(question);
    if (!m_thread.joinable())
        start();
}

void LensSolver::cancel()
{
    m_cancel.cancel();
    m_wanted = false;
    m_next.reset();
}

void LensSolver::start()
{
    m_cancel = CancelToken();
    m_wanted = true;
    JobControl control;
    control.cancel = m_cancel;
    control.progress = [this, cancel = m_cancel](double fraction, const Message &text) {
        callLater(this, [this, cancel, fraction, words = shownWords(text)] {
            if (!cancel.isCancelled())
                Q_EMIT progressed(fraction, words);
        });
    };
    const auto finishLater = [this](Result<LensAnswer> answer) {
        callLater(this, [this, answer = std::move(answer)] { finish(answer); });
    };
    auto thread = startThread(cannotDoThis(), [control, finishLater, question = std::move(*m_next)] {
        finishLater(orShortage(cannotDoThis(), [&] { return answerTo(question, control); }));
    });
    m_next.reset();
    if (thread)
        m_thread = std::move(*thread);
    else
        finishLater(tl::unexpected(thread.error()));
}

void LensSolver::finish(const Result<LensAnswer> &answer)
{
    if (m_thread.joinable())
        m_thread.join(); // it has nothing left to do
    if (m_next)
        return start();
    if (!m_wanted)
        return;
    if (answer)
        Q_EMIT solved(*answer);
    else
        Q_EMIT failed(answer.error());
}

QImage straightened(const QImage &image, const Intrinsics &lens)
{
    const auto camera = CameraModel::create(lens);
    if (image.isNull() || !camera)
        return {};
    const QImage from = image.convertToFormat(QImage::Format_RGB32);
    QImage to(from.size(), QImage::Format_RGB32);
    to.fill(Qt::black);
    const double scale = double(from.width()) / lens.widthPx;
    for (int y = 0; y < to.height(); ++y) {
        auto *row = reinterpret_cast<QRgb *>(to.scanLine(y));
        for (int x = 0; x < to.width(); ++x) {
            const Eigen::Vector3d ray(((x + 0.5) / scale - 0.5 - lens.cxPx) / lens.fxPx,
                                      ((y + 0.5) / scale - 0.5 - lens.cyPx) / lens.fyPx, 1);
            const auto pixel = camera->project(ray);
            if (!pixel)
                continue;
            const int u = int(std::floor((pixel->x() + 0.5) * scale)),
                      v = int(std::floor((pixel->y() + 0.5) * scale));
            if (from.rect().contains(u, v))
                row[x] = reinterpret_cast<const QRgb *>(from.constScanLine(v))[u];
        }
    }
    return to;
}

namespace {

constexpr int wholeResult = 1000, metricsWidth = 420;
constexpr int chosenByItself = -1;

QString modelName(LensModel model)
{
    switch (model) {
    case LensModel::Standard:
        return CalibrationResultPage::tr("ordinary");
    case LensModel::Rational:
        return CalibrationResultPage::tr("wide (rational)");
    case LensModel::Fisheye:
        break;
    }
    return CalibrationResultPage::tr("fisheye");
}

QString px(double value, int decimals)
{
    return CalibrationResultPage::tr("%1 px").arg(QLocale().toString(value, 'f', decimals));
}

/// Value ± σ of the parameter of this number.
QString withSigma(const Intrinsics &lens, double value, int parameter)
{
    if (lens.covariance.rows() <= parameter)
        return px(value, 1);
    return CalibrationResultPage::tr("%1 ± %2 px")
        .arg(QLocale().toString(value, 'f', 1),
             QLocale().toString(std::sqrt(lens.covariance(parameter, parameter)), 'f', 1));
}

} // namespace

CalibrationResultPage::CalibrationResultPage(QWidget *parent)
    : QWidget(parent), m_verdict(new QLabel), m_progress(new QProgressBar), m_bars(new ImageBars),
      m_canvas(new BoardCanvas), m_straight(new BoardCanvas), m_facts(new FactList), m_model(new QComboBox)
{
    m_verdict->setWordWrap(true);
    m_verdict->setTextFormat(Qt::PlainText);
    m_verdict->setAccessibleName(tr("Verdict"));
    m_verdict->setStyleSheet(QStringLiteral("font-size: 12pt"));
    m_progress->setRange(0, wholeResult);
    m_progress->setAccessibleName(tr("Solving"));
    m_model->addItem(tr("Automatic choice of the lens model"), chosenByItself);
    m_model->addItem(tr("Ordinary lens"), int(LensModel::Standard));
    m_model->addItem(tr("Wide lens (rational model)"), int(LensModel::Rational));
    m_model->addItem(tr("Fisheye"), int(LensModel::Fisheye));
    m_model->setAccessibleName(tr("Lens model"));
    m_canvas->setEmptyText(tr("Select a bar to see its image."));
    m_straight->setEmptyText(tr("Appears here after the calibration."));
    auto *images = new QTabWidget;
    images->addTab(m_canvas, tr("Image and &residuals"));
    images->addTab(m_straight, tr("&Straightened"));
    images->setDocumentMode(true);
    auto *row = new QHBoxLayout;
    row->addWidget(images, 1);
    row->addWidget(makeMetrics());
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_verdict);
    layout->addWidget(m_progress);
    layout->addLayout(row, 1);
    connect(m_bars, &ImageBars::thresholdChanged, this, &CalibrationResultPage::solveAgain);
    connect(m_bars, &ImageBars::currentChanged, this, &CalibrationResultPage::showImage);
    connect(m_model, &QComboBox::currentIndexChanged, this, &CalibrationResultPage::solve);
    connect(&m_solver, &LensSolver::solved, this, &CalibrationResultPage::showAnswer);
    connect(&m_solver, &LensSolver::failed, this, &CalibrationResultPage::showFailure);
    connect(&m_solver, &LensSolver::progressed, this, [this](double fraction, const QString &text) {
        m_progress->setValue(int(fraction * wholeResult));
        m_progress->setFormat(text);
    });
}

QWidget *CalibrationResultPage::makeMetrics()
{
    auto *errors = new Card(tr("Error by image"));
    errors->setContent(m_bars);
    auto *facts = new Card(tr("Calibration"));
    facts->addToHeader(m_model);
    facts->setContent(scrolled(m_facts, tr("Lens calibration")));
    auto *numbers = new QWidget;
    numbers->setFixedWidth(metricsWidth);
    auto *layout = new QVBoxLayout(numbers);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(errors);
    layout->addWidget(facts, 1);
    return numbers;
}

void CalibrationResultPage::begin(const SearchState &images)
{
    m_images = images;
    m_bars->setBars({}, {});
    m_canvas->setContent({});
    m_straight->setContent({});
    solve();
}

void CalibrationResultPage::solve()
{
    m_all.reset();
    LensQuestion question;
    question.size = m_images.size;
    for (const KeptImage &image : m_images.kept)
        question.views.push_back(image.board.view);
    if (const int model = m_model->currentData().toInt(); model != chosenByItself)
        question.model = LensModel(model);
    ask(std::move(question));
}

void CalibrationResultPage::solveAgain(double mostRmsPx)
{
    if (!m_all)
        return;
    LensQuestion question;
    question.size = m_images.size;
    question.reference = m_all;
    question.chosen = imagesWithin(*m_all, mostRmsPx);
    ask(std::move(question));
}

void CalibrationResultPage::ask(LensQuestion question)
{
    m_calibration.reset();
    m_verdict->setText(tr("Solving…"));
    m_progress->setValue(0);
    m_progress->setVisible(true);
    if (!m_images.kept.empty())
        question.example = m_images.kept.front().image;
    m_solver.solve(std::move(question));
    Q_EMIT completeChanged();
}

const CalibrationImage *CalibrationResultPage::outcomeOf(int index) const
{
    if (!m_calibration)
        return nullptr;
    const auto found =
        std::ranges::find(m_calibration->images, m_images.kept[std::size_t(index)].board.view.source,
                          [](const CalibrationImage &image) { return image.view.source; });
    return found == m_calibration->images.end() ? nullptr : &*found;
}

void CalibrationResultPage::showAnswer(const LensAnswer &answer)
{
    m_calibration = answer.calibration;
    if (!m_all)
        m_all = m_calibration;
    m_progress->setVisible(false);
    m_verdict->setText(breakable(shownWords(m_calibration->verdict)));
    QStringList names;
    std::vector<double> errors;
    for (int i = 0; i < int(m_images.kept.size()); ++i) {
        names << m_images.kept[std::size_t(i)].name;
        // The bars keep the errors of the calibration from all images: the threshold must not move its own
        // bars while it is dragged.
        const std::string &source = m_images.kept[std::size_t(i)].board.view.source;
        const auto found = std::ranges::find(m_all->images, source,
                                             [](const CalibrationImage &image) { return image.view.source; });
        errors.push_back(found == m_all->images.end() ? 0 : found->rmsPx);
    }
    m_bars->setBars(names, errors);
    showMetrics();
    m_straight->setContent(
        {answer.straightened, m_images.size, {}, true, {}, {}, {}, tr("straight edges must be straight")});
    m_bars->setCurrent(std::max(0, m_bars->current()));
    showImage(m_bars->current());
    Q_EMIT completeChanged();
}

void CalibrationResultPage::showSaving()
{
    m_verdict->setText(tr("Storing the lens calibration and its images…"));
}

void CalibrationResultPage::showNotSaved(const Error &error)
{
    m_verdict->setText(tr("The lens calibration was not stored. %1").arg(errorLine(error)));
}

/// One a line: the images that do not count, with the reason.
QString CalibrationResultPage::imagesLeftOut() const
{
    QStringList lines;
    for (int i = 0; i < int(m_images.kept.size()); ++i) {
        const CalibrationImage *outcome = outcomeOf(i);
        if (outcome == nullptr || outcome->used)
            continue;
        const Message &reason = outcome->contradicts.isEmpty() ? outcome->repeats : outcome->contradicts;
        lines << tr("%1: %2").arg(m_images.kept[std::size_t(i)].name,
                                  reason.isEmpty() ? tr("above the threshold") : shownWords(reason));
    }
    for (const RejectedImage &image : m_calibration->rejected)
        lines << tr("%1: %2").arg(QString::fromStdString(image.file), shownWords(image.reason));
    return lines.join(QLatin1Char('\n'));
}

/// How many, and in which images.
QString CalibrationResultPage::cornersLeftOut() const
{
    QStringList lines{QLocale().toString(qulonglong(m_calibration->cornersLeftOut()))};
    for (int i = 0; i < int(m_images.kept.size()); ++i) {
        const CalibrationImage *outcome = outcomeOf(i);
        if (outcome != nullptr && outcome->used && !outcome->leftOut.empty())
            lines << tr("%1: %2").arg(m_images.kept[std::size_t(i)].name,
                                      QLocale().toString(qulonglong(outcome->leftOut.size())));
    }
    return lines.join(QLatin1Char('\n'));
}

void CalibrationResultPage::showMetrics()
{
    const IntrinsicCalibration &calibration = *m_calibration;
    const Intrinsics &lens = calibration.intrinsics;
    QList<Fact> facts(
        {{tr("Model"), tr("%1: %2").arg(modelName(lens.model), shownWords(calibration.modelReason)), {}},
         {tr("Images"), tr("%1 of %2").arg(calibration.imagesUsed()).arg(m_images.kept.size()), {}},
         {tr("Board error"), px(calibration.rmsPx, 3), {}},
         {tr("Held-out error"),
          calibration.crossValidationPx > 0 ? px(calibration.crossValidationPx, 3) : tr("needs six images"),
          {}},
         {tr("Corners left out"), cornersLeftOut(), {}},
         {tr("Focal length"), withSigma(lens, lens.fxPx, 0), {}},
         {tr("Centre x"), withSigma(lens, lens.cxPx, 2), {}},
         {tr("Centre y"), withSigma(lens, lens.cyPx, 3), {}}});
    if (const QString leftOut = imagesLeftOut(); !leftOut.isEmpty())
        facts.insert(2, {tr("Images left out"), leftOut, {}});
    m_facts->setFacts(facts);
}

void CalibrationResultPage::showFailure(const Error &error)
{
    m_progress->setVisible(false);
    m_verdict->setText(
        breakable(fullSentence(shownWords(joined({error.why, error.advice}, Join::Semicolon)))));
    m_facts->setFacts({});
    Q_EMIT completeChanged();
}

void CalibrationResultPage::showImage(int index)
{
    if (index < 0 || index >= int(m_images.kept.size()))
        return;
    const KeptImage &image = m_images.kept[std::size_t(index)];
    BoardCanvas::Content content{image.image, m_images.size, image.board.view.pixels, false, {}, {},
                                 {},          image.name};
    if (const CalibrationImage *outcome = outcomeOf(index)) {
        content.counts = outcome->used;
        content.residuals = outcome->residualsPx;
        content.leftOut = outcome->leftOut;
        const Message &reason = outcome->contradicts.isEmpty() ? outcome->repeats : outcome->contradicts;
        if (!reason.isEmpty())
            content.label = tr("%1: %2").arg(image.name, shownWords(reason));
    }
    m_canvas->setContent(std::move(content));
}

} // namespace odo
