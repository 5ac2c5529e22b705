// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/school/internal/hub_words.h"

#include "core/school/hub_address.h"
#include "ui/models/shown_message.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace odo {

namespace {

constexpr std::size_t mostWarnings = 5;

class HubWords
{
    Q_DECLARE_TR_FUNCTIONS(Hub)
};

} // namespace

QString outcomeWords(HubState::Work work, const SchoolReport &report)
{
    QStringList sentences;
    switch (work) {
    case HubState::Work::None:
        return {};
    case HubState::Work::Connecting:
        sentences << HubWords::tr("Connected.");
        break;
    case HubState::Work::Publishing:
        sentences << (report.sent == 0 ? HubWords::tr("Everything had been sent.")
                                       : HubWords::tr("%n item(s) sent.", nullptr, report.sent));
        break;
    case HubState::Work::Pulling:
        sentences << (report.received == 0 ? HubWords::tr("Nothing new at the hub.")
                                           : HubWords::tr("%n item(s) received.", nullptr, report.received));
        break;
    }
    if (report.mediaBytes > 0)
        sentences
            << HubWords::tr("Recordings: %1 copied.").arg(QLocale().formattedDataSize(report.mediaBytes));
    const std::size_t shown = std::min(report.warnings.size(), mostWarnings);
    for (std::size_t i = 0; i < shown; ++i)
        sentences << fullSentence(shownWords(report.warnings[i]));
    if (report.warnings.size() > shown)
        sentences << HubWords::tr("%n more warning(s).", nullptr, int(report.warnings.size() - shown));
    return sentences.join(u' ');
}

QString hubName(const SchoolLink &link)
{
    const auto address = HubAddress::parse(link.url);
    if (!address)
        return QString::fromStdString(link.url);
    const QString database = QString::fromStdString(address->database);
    const QString place =
        address->host.empty() ? database : QString::fromStdString(address->host) + u'/' + database;
    return address->user.empty() ? place
                                 : HubWords::tr("%1 at %2").arg(QString::fromStdString(address->user), place);
}

QString roleWords(const std::string &role)
{
    if (role == "teacher")
        return HubWords::tr("Teacher: may change everything");
    if (role == "bench")
        return HubWords::tr("Bench: publishes its own trials, reads those of others");
    return HubWords::tr("Viewer: reads results only");
}

QString pendingWords(const HubState &state)
{
    return state.pending == 0 ? HubWords::tr("Nothing: all is sent")
                              : HubWords::tr("%n change(s)", nullptr, static_cast<int>(state.pending));
}

Badge hubBadge(const HubState &state)
{
    if (!state.link)
        return {};
    if (state.isPasswordWanted)
        return {HubWords::tr("password needed"), BadgeState::Warning};
    if (state.isSilent)
        return {HubWords::tr("no answer yet"), BadgeState::Warning};
    if (state.isAway())
        return {HubWords::tr("server away"), BadgeState::Warning};
    if (state.problem)
        return {HubWords::tr("not accepted"), BadgeState::Bad};
    return {};
}

QString hubStateWords(const HubState &state)
{
    if (!state.link)
        return {};
    const int pending = static_cast<int>(state.pending);
    if (const Badge badge = hubBadge(state); !badge.text.isEmpty())
        return pending == 0 ? HubWords::tr("Hub: %1").arg(badge.text)
                            : HubWords::tr("Hub: %n pending, %1", nullptr, pending).arg(badge.text);
    switch (state.work) {
    case HubState::Work::Publishing:
        return pending == 0 ? HubWords::tr("Hub: publishing…")
                            : HubWords::tr("Hub: publishing, %n pending", nullptr, pending);
    case HubState::Work::Pulling:
        return HubWords::tr("Hub: pulling…");
    case HubState::Work::Connecting:
    case HubState::Work::None:
        break;
    }
    return pending == 0 ? HubWords::tr("Hub: all sent") : HubWords::tr("Hub: %n pending", nullptr, pending);
}

} // namespace odo
