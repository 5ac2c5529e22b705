// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/range_report.h"

#include <utility>

namespace odo {

RangeReport reportOf(const RangeRequest &request)
{
    const Profile &profile = request.scene->robots.at(request.robot).analysis->profile;
    RangeReport report{request, pathWithin(profile, request.span), {}, {}};
    for (const Quantity quantity : request.quantities)
        report.statistics.push_back(statisticsOf(profile, quantity, request.span));
    if (request.shape)
        report.fit = fitQuantity(profile, request.fitted, request.span, *request.shape);
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
    // What is known already is told though something newer is wanted, so that a drag shows figures on its
    // way.
    if (!m_isForgotten)
        Q_EMIT reported(*m_result);
    if (m_wanted)
        begin();
}

} // namespace odo
