// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/internal/lens_solver.h"

#include "core/base/shortage.h"
#include "core/workflow/job_runner.h"
#include "ui/models/shown_message.h"

#include <cmath>

namespace odo {
namespace {

Result<LensAnswer> answerTo(const LensQuestion &question, const JobControl &control)
{
    auto calibration =
        ODO_TRY(question.reference ? recalibrate(*question.reference, question.chosen, control)
                                   : calibrateIntrinsics(question.views, question.size.width(),
                                                         question.size.height(), question.model, control));
    QImage picture = straightened(question.example, calibration.intrinsics);
    return LensAnswer{std::move(calibration), std::move(picture)};
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

QImage straightened(const QImage &picture, const Intrinsics &lens)
{
    const auto camera = CameraModel::create(lens);
    if (picture.isNull() || !camera)
        return {};
    const QImage from = picture.convertToFormat(QImage::Format_RGB32);
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

} // namespace odo
