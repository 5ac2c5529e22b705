// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/verdict_mark.h"

#include "ui/models/shown_message.h"

#include <QCoreApplication>

namespace odo {

namespace {

class VerdictMarkWords
{
    Q_DECLARE_TR_FUNCTIONS(VerdictMark)
};

} // namespace

Badge verdictBadge(const TrialVerdict &verdict)
{
    if (verdict.isAccepted())
        return {QStringLiteral("✓ ") + VerdictMarkWords::tr("accepted"), BadgeState::Neutral};
    switch (verdict.level()) {
    case CheckLevel::Doubtful:
        return {QStringLiteral("! ") + VerdictMarkWords::tr("doubtful"), BadgeState::Warning};
    case CheckLevel::Bad:
        return {QStringLiteral("✕ ") + VerdictMarkWords::tr("bad"), BadgeState::Bad};
    case CheckLevel::Pass:
        break;
    }
    return {QStringLiteral("✓ ") + VerdictMarkWords::tr("passed"), BadgeState::Good};
}

QStringList verdictReasons(const TrialVerdict &verdict)
{
    QStringList reasons;
    for (const TrialCheck &check : verdict.checks)
        if (check.level != CheckLevel::Pass)
            reasons << fullSentence(shownWords(check.text));
    if (verdict.isAccepted())
        reasons << VerdictMarkWords::tr("Accepted: %1").arg(QString::fromStdString(verdict.acceptance->reason));
    return reasons;
}

QString verdictText(const TrialVerdict &verdict)
{
    const QStringList reasons = verdictReasons(verdict);
    return reasons.isEmpty() ? VerdictMarkWords::tr("all checks passed") : reasons.join(u'\n');
}

} // namespace odo
