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

QString shownVerdict(const TrialVerdict &verdict)
{
    if (verdict.isAccepted())
        return VerdictMarkWords::tr("accepted");
    switch (verdict.level()) {
    case CheckLevel::Doubtful:
        return VerdictMarkWords::tr("doubtful");
    case CheckLevel::Bad:
        return VerdictMarkWords::tr("bad");
    case CheckLevel::Pass:
        break;
    }
    return VerdictMarkWords::tr("passed");
}

Badge verdictBadge(const TrialVerdict &verdict)
{
    const QString word = QStringLiteral(" ") + shownVerdict(verdict);
    if (verdict.isAccepted())
        return {u'✓' + word, BadgeState::Neutral};
    switch (verdict.level()) {
    case CheckLevel::Doubtful:
        return {u'!' + word, BadgeState::Warning};
    case CheckLevel::Bad:
        return {u'✕' + word, BadgeState::Bad};
    case CheckLevel::Pass:
        break;
    }
    return {u'✓' + word, BadgeState::Good};
}

QStringList verdictReasons(const TrialVerdict &verdict)
{
    QStringList reasons;
    for (const TrialCheck &check : verdict.checks)
        if (check.level != CheckLevel::Pass)
            reasons << fullSentence(shownWords(check.text));
    if (verdict.isAccepted())
        reasons
            << VerdictMarkWords::tr("Accepted: %1").arg(QString::fromStdString(verdict.acceptance->reason));
    return reasons;
}

QString verdictText(const TrialVerdict &verdict)
{
    const QStringList reasons = verdictReasons(verdict);
    return reasons.isEmpty() ? VerdictMarkWords::tr("all checks passed") : reasons.join(u'\n');
}

} // namespace odo
