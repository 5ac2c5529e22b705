// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace odo {

struct ProjectConnection;

/// What an analysis was made from and what came out, each with a SHA-256 of its own, so that a difference can
/// be named (table analysis_digest). A digest goes over the values as they are stored, in the order of their
/// positions.
enum class DigestPart {
    Measurements,  ///< observations of all views, or the imported track
    Recordings,    ///< hashes, sizes, frame times and synchronisation of the trial's recordings
    Registrations, ///< of the views that were used, with the lens of each
    Task,          ///< the course, gates, zones and limits it was measured by
    Positions,     ///< samples and points
    Results,       ///< version, options, overrides, metrics, spikes, passages and ambiguous names
};
inline constexpr std::array allDigestParts{DigestPart::Measurements,  DigestPart::Recordings,
                                           DigestPart::Registrations, DigestPart::Task,
                                           DigestPart::Positions,     DigestPart::Results};
/// What the analysis gave: read with it, so that these are compared whenever it is shown.
inline constexpr std::array shownDigestParts{DigestPart::Positions, DigestPart::Results};

/// Makes and compares digests through prepared statements, which are kept: thousands of analyses in a row are
/// quick. On the connection's thread; the connection must outlive it.
class AnalysisDigests
{
public:
    explicit AnalysisDigests(const ProjectConnection &connection);
    ~AnalysisDigests();
    AnalysisDigests(const AnalysisDigests &) = delete;
    AnalysisDigests &operator=(const AnalysisDigests &) = delete;

    /// What is stored now.
    Result<std::string> make(RecordId analysis, DigestPart part);

    struct Outcome
    {
        bool isKept = false;             ///< it has digests: analyses before format 12 have none
        std::vector<DigestPart> changed; ///< parts that are not as they were when the analysis was made
    };
    Result<Outcome> compare(RecordId analysis, std::span<const DigestPart> parts);

private:
    struct Queries;
    std::unique_ptr<Queries> m_queries;
};

/// Stores the digests of an analysis whose rows are all stored. Everything that adds an analysis comes
/// through here.
Result<void> writeDigests(ProjectConnection &connection, RecordId analysis);

/// What a digest is of.
struct DigestedPart
{
    RecordId analysis = 0;
    DigestPart part = DigestPart::Results;
};

/// Runs work in one transaction, which changes rows that the digests of these parts go over, but nothing that
/// counts: those that were right before are right afterwards. Those that were not stay as they are.
Result<void> keepDigestsRight(ProjectConnection &connection, const std::vector<DigestedPart> &parts,
                              const std::function<Result<void>()> &work);

/// Stores the hash of a recording, which is made after its trial was recorded, and perhaps analysed: analyses
/// whose digest of the recordings was right before get the new one.
Result<void> setRecordingHash(ProjectConnection &connection, RecordId recording, const std::string &sha256);

} // namespace odo
