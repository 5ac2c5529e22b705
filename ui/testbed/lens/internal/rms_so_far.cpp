// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/internal/rms_so_far.h"

#include "ui/models/shown_message.h"
#include "ui/views/widgets/labels.h"

#include <QLocale>
#include <algorithm>
#include <utility>

namespace odo {

namespace {

constexpr int imagesForRms = 3;

QString twoDecimals(double rmsPx)
{
    return QLocale().toString(rmsPx, 'f', 2);
}

} // namespace

RmsSoFar::RmsSoFar(QWidget *parent) : QLabel(parent)
{
    showAsWords(*this);
    setAccessibleName(tr("RMS so far"));
    connect(&m_task, &BackgroundTask::finished, this, [this](const std::optional<Error> &error) {
        if (m_next)
            begin(*std::exchange(m_next, std::nullopt));
        else
            showFit(error);
    });
    setState({});
}

void RmsSoFar::setState(const SearchState &state)
{
    QStringList names;
    for (const KeptImage &image : state.kept)
        names << image.name;
    if (names == m_names && !text().isEmpty())
        return;
    m_names = names;
    m_next.reset();
    if (names.size() < imagesForRms) {
        m_task.cancel();
        setText(tr("RMS: from %1 images on").arg(imagesForRms));
        return;
    }
    Images images{{}, names, state.size};
    for (const KeptImage &image : state.kept)
        images.views.push_back(image.board.view);
    if (m_task.isRunning()) {
        m_task.cancel();
        m_next = std::move(images);
    } else {
        begin(std::move(images));
    }
}

void RmsSoFar::begin(Images images)
{
    m_fit = std::make_shared<IntrinsicCalibration>();
    m_fitted = {{}, images.names, images.size};
    m_task.start([fit = m_fit, images = std::move(images)](const JobControl &control) -> Result<void> {
        *fit = ODO_TRY(calibrateIntrinsics(images.views, images.size.width(), images.size.height(),
                                           LensModel::Standard, control));
        return {};
    });
}

void RmsSoFar::showFit(const std::optional<Error> &error)
{
    if (m_fitted.names != m_names) // fewer than are needed were left meanwhile
        return;
    if (error) {
        setText(tr("RMS: not yet, %1").arg(shownWords(error->why)));
        return;
    }
    const auto worst = std::ranges::max_element(m_fit->images, {}, &CalibrationImage::rmsPx);
    const auto index = worst - m_fit->images.begin();
    setText(tr("RMS so far: %1 px; highest: %2 px in %3")
                .arg(twoDecimals(m_fit->rmsPx), twoDecimals(worst->rmsPx), m_fitted.names.value(index)));
}

} // namespace odo
