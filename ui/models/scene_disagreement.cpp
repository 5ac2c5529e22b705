// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/scene_disagreement.h"

#include "ui/models/figure_text.h"

#include <QCoreApplication>
#include <algorithm>

namespace odo {

namespace {

class SceneDisagreementWords
{
    Q_DECLARE_TR_FUNCTIONS(SceneDisagreement)
};

constexpr double surprising = 1.5; // times what is expected

double stepSigmaS(const TrialScene &scene)
{
    double largest = 0;
    for (const SceneView &view : scene.views)
        largest = std::max(largest, view.recording.startOffsetSigmaS);
    return largest;
}

} // namespace

std::vector<ViewDisagreement> disagreementsOf(const TrialScene &scene)
{
    std::vector<ViewDisagreement> all;
    for (const SceneRobot &robot : scene.robots) {
        std::vector<ViewTrack> tracks;
        for (std::size_t view = 0; view < scene.views.size() && view < robot.observations.size(); ++view) {
            const SceneView &shown = scene.views[view];
            tracks.push_back({shown.camera, shown.floorView, shown.startOffset, robot.observations[view],
                              shown.clockRate});
        }
        all.push_back(robot.analysis ? disagreementOf(robot.analysis->profile, tracks, stepSigmaS(scene))
                                     : ViewDisagreement());
    }
    return all;
}

QString disagreementWords(const ViewDisagreement &disagreement)
{
    if (disagreement.places.empty())
        return SceneDisagreementWords::tr("Only one view at a time: nothing to compare");
    const QString measured = SceneDisagreementWords::tr("RMS %1, median %2")
                                 .arg(lengthText(disagreement.rmsM), lengthText(disagreement.medianM));
    const QString expected =
        SceneDisagreementWords::tr("expected by the errors: %1").arg(lengthText(disagreement.expectedRmsM));
    return measured + u'\n' +
           (disagreement.ratio() > surprising
                ? SceneDisagreementWords::tr("%1 – more than they explain").arg(expected)
                : expected);
}

Explanation explainDisagreement(const TrialScene &scene, std::size_t robot,
                                const ViewDisagreement &disagreement)
{
    Explanation explanation{SceneDisagreementWords::tr("Disagreement of the views"),
                            disagreementWords(disagreement).replace(u'\n', QStringLiteral("; ")),
                            {},
                            {},
                            analysisInputs(scene, robot),
                            {}};
    explanation.formula =
        SceneDisagreementWords::tr("Each view alone puts the robot at a place on the floor. Shown is how "
                                   "far these places are apart in each "
                                   "frame in which two views or more saw it (of more than two, the largest "
                                   "distance); RMS is √(mean of the "
                                   "squares). Samples that are not used are left out.\n"
                                   "Expected is √(tr A + tr B + (v·σs)²) from the covariances A and B of "
                                   "two views (pixels and calibration), "
                                   "the speed v and the views' step σs.\n"
                                   "Much more than expected means that something is not as it was told: the "
                                   "views are not in step (then it grows "
                                   "with the speed), a camera has moved or is badly registered (then it "
                                   "depends on the place), or the robot's "
                                   "height is wrong (then it points to and from the cameras).");
    explanation.inputs.prepend(
        SceneDisagreementWords::tr("%1 frames seen by two views or more; largest %2; views in step to %3 ms")
            .arg(disagreement.places.size())
            .arg(lengthText(disagreement.largestM), QLocale().toString(1e3 * stepSigmaS(scene), 'f', 1)));
    return explanation;
}

} // namespace odo
