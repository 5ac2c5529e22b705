// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/trajectory/analyser.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace odo {

/// Samples of a series that may be too long to be held at once: so many of them, made or read in chunks from
/// `first` on. An error that a chunk gives ends whatever asked for it.
struct SampleSource
{
    std::size_t count = 0;
    std::function<Result<std::vector<Sample>>(std::size_t first, std::size_t count)> chunk;
};

/// Those of a vector, which must outlive it.
inline SampleSource sourceOf(const std::vector<Sample> &samples)
{
    return {samples.size(), [&samples](std::size_t first, std::size_t count) -> Result<std::vector<Sample>> {
                const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(first);
                return std::vector<Sample>(begin, begin + static_cast<std::ptrdiff_t>(count));
            }};
}

/// A track that another program measured, as it was imported: positions in metres in the world frame, in
/// order of time. Nothing here alters them: they are the raw measurement. All functions are pure and
/// thread-safe.

/// One line of such a track.
struct ImportedPosition
{
    using Pair = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>; // millions of them need not take a third more
    Nanoseconds time{0};
    std::optional<Pair> position;          ///< empty: the robot was not measured then
    std::optional<Pair> sigmaM;            ///< of x and y, where it is stated
    std::optional<double> headingRad = {}; ///< of the body, anticlockwise from the world's X
};

/// The samples of such a track; Sample::frame is the line's index, no view is named. Positions without a
/// stated σ get noiseM. Headings get a σ by their scatter. Those that never change do not count, unless the
/// robot drives along them: programs that know no orientation write the same one in every line.
std::vector<Sample> samplesOfImported(const std::vector<ImportedPosition> &track, double noiseM);

/// The same, held in a sixth of the memory of the samples.
class ImportedSeries
{
public:
    ImportedSeries(const std::vector<ImportedPosition> &track, double noiseM);
    std::size_t size() const { return m_times.size(); }
    Sample sample(std::size_t i) const;

private:
    std::vector<Nanoseconds> m_times;
    std::vector<std::array<double, 2>> m_positions; ///< NaN: not measured
    std::vector<std::array<double, 2>> m_sigmas;    ///< as stated; empty: none is, all have the noise
    std::vector<double> m_headings;                 ///< NaN: not known; empty: none is
    double m_noiseM, m_headingSigmaRad = 0;
};

/// How far the positions scatter from frame to frame, metres: what the motion noise's maximum likelihood
/// leaves over for the measurement (estimateMotionNoise), spikes left out. At least leastImportedNoiseM.
double estimateImportedNoiseM(const std::vector<ImportedPosition> &track, const JobControl &control = {});
/// no camera measures finer, and numbers that were rounded look as if it did
constexpr double leastImportedNoiseM = 1e-4;

/// NoiseLevel of these samples.
double noiseLevelM(const std::vector<Sample> &samples);

/// Analyses imported samples as those of our own views are: spikes, profile, metrics. Gaps are bridged over
/// four times the usual interval where that is longer than the options say, which gets into the options.
/// Undetermined where fewer than three positions can be used.
Result<Profile> analyseImported(const std::vector<Sample> &raw, const AnalysisOptions &options);
/// The same of samples that are not held: the profile has their flags in place of them. Longer tracks than
/// longestAtOnce are analysed in parts that overlap, with the noise learnt from stretches all over the track.
/// Asks for cancellation; reports progress.
Result<Profile> analyseImported(const SampleSource &raw, const AnalysisOptions &options,
                                const JobControl &control);
constexpr std::size_t longestAtOnce = 131'072;
/// The options with which a track of these times is analysed.
AnalysisOptions optionsForImported(AnalysisOptions options, const std::vector<Sample> &raw);
Result<AnalysisOptions> optionsForImported(AnalysisOptions options, const SampleSource &raw);

} // namespace odo
