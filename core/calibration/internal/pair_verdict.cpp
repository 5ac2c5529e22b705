// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/pair_verdict.h"

#include "core/base/units.h"
#include "core/calibration/internal/wording.h"

namespace odo {

namespace {

constexpr double goodPairPx = 0.5, usablePairPx = 1;            // RMS of the corners
constexpr double goodPairSigma = 0.005, usablePairSigma = 0.02; // of the distance
constexpr double manyTimes = 10; // the variance that the corners' noise explains

} // namespace

Message relationOfCameras()
{
    return ODO_TEXT("calibration.pair_of_cameras", "the relative position of the cameras");
}

tl::unexpected<Error> refusePair(Message why, Message advice, ErrorCode code)
{
    return fail(code, relationOfCameras(), std::move(why), std::move(advice));
}

Message noRelation()
{
    return ODO_TEXT("calibration.pair_undetermined", "the board positions do not determine it");
}

Message noPairHasBoard(std::size_t pairs, const std::vector<RejectedPair> &rejected)
{
    Message none = ODO_TEXT("calibration.no_pair_has_board", "none of %1 pairs can be used")(pairs);
    return rejected.empty() ? none : joined({std::move(none), rejected.front().reason}, Join::Colon);
}

Message pairsContradict(const CameraPair &pair)
{
    return ODO_TEXT("calibration.pairs_contradict",
                    "the pairs contradict each other (%1 RMS together, %2 in each image alone)")(
        quantity(pair.rmsPx, 1, "px"), quantity(pair.freeRmsPx, 2, "px"));
}

Message showBoardToBoth()
{
    return ODO_TEXT("calibration.show_board_to_both",
                    "show the whole board to both cameras at once, in ten positions or more");
}

Message takeAtSameMoment()
{
    return ODO_TEXT("calibration.take_at_same_moment",
                    "check that the files belong together in this order and were taken at the same moments, "
                    "and that both lens calibrations belong to these cameras");
}

Message pairVerdict(const CameraPair &pair)
{
    Message fit = ODO_TEXT("calibration.pair_fits",
                           "the cameras are %1 apart (±%2) by %3 pairs, whose corners fit to %4 RMS")(
        millimetres(pair.baselineM), quantity(toMillimetres(pair.baselineSigmaM), 2, "mm"), pair.used.size(),
        quantity(pair.rmsPx, 2, "px"));
    const double sigma = pair.baselineSigmaM / pair.baselineM;
    Message grade = pair.rmsPx < goodPairPx && sigma < goodPairSigma       ? goodVerdict(std::move(fit))
                    : pair.rmsPx < usablePairPx && sigma < usablePairSigma ? usableVerdict(std::move(fit))
                                                                           : uncertainVerdict(std::move(fit));
    std::vector<Message> sentences{std::move(grade)};
    if (pair.squares.count > 0)
        sentences.push_back(
            ODO_TEXT("calibration.pair_squares",
                     "Triangulated, the squares of the board are %1 (standard deviation %2).")(
                quantity(toMillimetres(pair.squares.meanM), 2, "mm"),
                quantity(toMillimetres(pair.squares.sdM), 2, "mm")));
    if (pair.overdispersion > manyTimes)
        sentences.push_back(
            ODO_TEXT("calibration.pairs_scatter",
                     "The pairs agree less well than the corners would allow, which is in the "
                     "uncertainty: the board moved between the two frames of a pair, or a lens "
                     "calibration is less accurate than stated."));
    if (!pair.areIntrinsicsSigmasStated)
        sentences.push_back(
            ODO_TEXT("calibration.pair_lens_usual",
                     "A lens calibration has no stated uncertainty: a usual one was assumed."));
    if (!pair.rejected.empty())
        sentences.push_back(
            ODO_TEXT("calibration.pairs_left_out", "%1 pairs were not used.")(pair.rejected.size()));
    return joined(std::move(sentences), Join::Space);
}

} // namespace odo
