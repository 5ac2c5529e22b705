// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/project/repositories.h"

#include <random>

namespace odo {

/// Records with every field set to something that is easily lost: numbers with all digits, negative times,
/// long lists, and names in other scripts.
class RecordSource
{
public:
    explicit RecordSource(std::uint32_t seed) : m_random(seed) {}

    double number() { return std::uniform_real_distribution<double>(-1000, 1000)(m_random); }
    double positive() { return std::uniform_real_distribution<double>(0.001, 1000)(m_random); }
    std::int64_t integer()
    {
        return std::uniform_int_distribution<std::int64_t>(-(1ll << 52), 1ll << 52)(m_random);
    }
    Eigen::Vector2d vector() { return {number(), number()}; }
    Eigen::Matrix2d covariance();
    Instant instant() { return Instant(std::chrono::milliseconds(integer() / 1000000)); }

    Intrinsics intrinsics(LensModel model);
    IntrinsicsRecord calibration(RecordId camera);
    RegistrationRecord registration(RecordId camera, RecordId layout, RecordId intrinsics);
    MarkerLayout layout(const std::string &name);
    Task task();
    RecordingRecord recording(RecordId camera, std::size_t frames);
    Observation observation(std::int64_t frame);
    AnalysisRecord analysis(RecordId trial, RecordId robot, std::size_t samples);
    TruthSeries truth(RecordId trial, RecordId robot, std::size_t rows);

private:
    std::mt19937 m_random;
};

/// Fills a project with two cameras, a robot, and a trial with observations, an analysis and a truth.
struct FilledProject
{
    RecordId trial = 0, robot = 0;
    std::vector<RecordId> recordings;
};
/// Duration and synchronisation of a trial, as two views give them.
void describe(TrialRecord &trial, const std::vector<RecordingRecord> &views);
Result<FilledProject> fill(Project &project, RecordSource &source);

} // namespace odo
