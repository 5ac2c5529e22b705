// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/message.h"
#include "core/project/records.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace odo {

struct ProjectConnection;

/// How far a result can be relied on. Doubtful: read the reason first. Bad: do not use it.
enum class CheckLevel { Pass, Doubtful, Bad };
/// "pass", "doubtful", "bad": how the command line says it, and as it is stored.
std::string wordOf(CheckLevel level);

/// The outcome of one check of a trial.
struct TrialCheck
{
    std::string code; ///< stable, such as "views_agree"
    CheckLevel level = CheckLevel::Pass;
    Message text; ///< a whole sentence; of a check that was passed what was checked
};

/// That a person relies on a doubtful result.
struct VerdictAcceptance
{
    std::string reason; ///< theirs, not blank
    Instant made;
    std::vector<std::string> checks; ///< codes of those that were doubtful then, in alphabetical order
};

/// What the checks of a trial say; docs/trust.md explains what each can know.
struct TrialVerdict
{
    std::vector<TrialCheck> checks; ///< each code once at least, in a fixed order
    /// The latest; it counts only while isAccepted().
    std::optional<VerdictAcceptance> acceptance = {};

    /// The worst of them. Pass without any.
    CheckLevel level() const;
    /// Doubtful, and a person accepted each check that is doubtful now.
    bool isAccepted() const;
    /// Pass or accepted: nothing has to be said before the result is used.
    bool isSound() const { return level() == CheckLevel::Pass || isAccepted(); }
};

/// Its level, or "doubtful, accepted".
std::string wordOf(const TrialVerdict &verdict);

/// A verdict with what is stored of it.
struct StoredVerdict
{
    RecordId trial = 0;
    TrialVerdict verdict;
    std::string basis; ///< VerdictRepository::basis, read before the verdict was computed
    /// of the analyses it is on: metrics that are at least so large, by the analyses
    std::map<RecordId, std::vector<std::string>> lowerBounds;
};

/// The verdicts on the trials of a project. Plain synchronous calls on the project's thread, as those of
/// repositories.h.
class VerdictRepository
{
public:
    explicit VerdictRepository(ProjectConnection &connection);
    /// What the verdict on a trial follows from, as one text: once that is another, the stored one counts no
    /// more.
    Result<std::string> basis(RecordId trial) const;
    /// Replaces the stored verdict. Undoing other changes leaves it alone.
    Result<void> set(const StoredVerdict &verdict);
    /// Of the trials from one moment to another (both belong to them), the verdicts that count, without the
    /// checks that were passed. Quick.
    Result<std::map<RecordId, TrialVerdict>> all(Instant from, Instant to) const;
    /// Trials from one moment to another that have an analysis, but no verdict that counts, the newest first.
    Result<std::vector<RecordId>> missing(Instant from, Instant to) const;
    Result<std::optional<VerdictAcceptance>> acceptance(RecordId trial) const;
    /// Replaces the trial's acceptance; nullopt: withdraws it. InvalidInput for a blank reason.
    Result<void> setAcceptance(RecordId trial, const std::optional<VerdictAcceptance> &acceptance);

private:
    Result<void> readAcceptances(std::map<RecordId, TrialVerdict> &verdicts) const;
    ProjectConnection &m_connection;
};

} // namespace odo
