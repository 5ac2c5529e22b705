// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/colour_model.h"
#include "core/tracking/internal/robot_expectation.h"
#include "core/tracking/internal/robot_outline.h"

#include <Eigen/Geometry>
#include <memory>

namespace odo {

/// A region that may be the robot.
struct Candidate
{
    Blob blob;
    Eigen::Vector2d centrePx; ///< luma pixels
    double score = 0;         ///< 0 to 1, for comparison among candidates
    enum class By {
        LearnedColour,
        GivenColour,
        GivenColourAlone
    } by = By::LearnedColour; ///< Alone: whatever the background
};

/// Finds one robot in the whole frame, and once found follows it from frame to frame in a window. The
/// decision which candidate is whose is the caller's, who sees all robots.
class RobotFollower
{
public:
    explicit RobotFollower(RgbColour given) : m_given(given) {}

    bool isFollowing() const { return m_phase == Phase::Following; }
    const ColourModel &model() const { return m_model; }

    /// Restarts for frames of this format. searched: the chroma samples in which it may be; null: all.
    void reset(const FrameFormat &format, std::shared_ptr<const BitMask> searched);

    /// Where in the frame the robot is searched while it is followed, in chroma samples.
    ChromaRect windowOf(const TrackedFrame &frame) const;
    /// Following: all that propose() and accept() may read of a frame of this format and time, perhaps with
    /// some margin beyond the frame; nullopt when the whole frame is needed.
    std::optional<PixelRect> neededRegion(const FrameFormat &format, double timeS) const;
    /// Following: searches candidates in the window about the predicted position, best first.
    void propose(const TrackedFrame &frame);
    /// Following, near robots of a like colour: finds the regions of a window and a table that they share.
    /// Equal windows and tables give equal regions, in the same order, to each of them.
    void lookAt(const TrackedFrame &frame, const ChromaRect &window, const ChromaTable &table);
    const std::vector<Blob> &regions() const { return m_finder.blobs(); }
    void paint(const Blob &region, RegionMask &mask) const
    {
        m_finder.paint(region, RegionMeasure::margin, mask);
    }
    /// What speaks against a region being this robot alone: half the squared standard deviations in place,
    /// size and colour.
    double costOf(const TrackedFrame &frame, const Blob &region) const;
    /// Not following: searches candidates in the whole frame, best first. `background` is everything else.
    void search(const TrackedFrame &frame, const ChromaDensity &background);
    const std::vector<Candidate> &candidates() const { return m_candidates; }

    /// Takes a candidate of propose() as the robot.
    void accept(const TrackedFrame &frame, const Candidate &candidate, Observation &observation);
    /// Takes a candidate of search() as the robot, unless a closer look denies it: then false. `background`
    /// is what else there is beside the candidate.
    bool acceptFound(const TrackedFrame &frame, const Candidate &candidate, const ChromaDensity &background,
                     Observation &observation);
    /// Takes what has its colour at a pixel as the robot, whatever it followed before; false where nothing
    /// has. `background` as of search.
    bool startAt(const TrackedFrame &frame, const Eigen::Vector2d &pixel, const ChromaDensity &background,
                 Observation &observation);
    /// Takes a coarse position of low score, from a region that several robots share.
    void acceptTogether(const TrackedFrame &frame, const Eigen::Vector2d &centrePx, Observation &observation);
    /// None of the candidates is the robot. While another robot hides it, it is not yet given up.
    void miss(bool hidden);

    /// Notes that another robot's region touches this one's: what is seen may be a part of it.
    void setTouched(bool touched) { m_touched = touched; }
    Eigen::Vector2d predictedPx(const TrackedFrame &frame) const { return m_predictor.at(frame.timeS()); }
    double areaPx() const { return m_area.px(); }
    double radiusPx() const { return m_radiusPx; }
    /// The region as it was when it was last seen alone, and its centre, in chroma samples.
    const RegionMask &silhouette() const { return m_silhouette; }
    const Eigen::Vector2d &silhouetteCentre() const { return m_silhouetteCentre; }

    /// The colour has changed, or time has passed: give a fresh background.
    bool wantsTable() const { return m_phase == Phase::Following && m_wantsTable; }
    void buildTable(const ChromaDensity &background);
    /// Another robot's colour has become known: the table should be built again.
    void askForTable() { m_wantsTable = true; }
    /// Where the robot and its blurred edge were seen last; empty when it is not followed.
    ChromaRect occupied() const { return isFollowing() ? m_occupied : ChromaRect(); }

private:
    enum class Phase { Unseen, Following, Lost };

    Eigen::AlignedBox2d expectedBox(double timeS) const;
    double rankInWindow(const TrackedFrame &frame, const Blob &blob) const;
    double rankHidden(const TrackedFrame &frame, const Blob &blob) const;
    double rankLost(const TrackedFrame &frame, const Blob &blob) const;
    void collect(const TrackedFrame &frame, Candidate::By by, double least,
                 double (RobotFollower::*rank)(const TrackedFrame &, const Blob &) const);
    void sortCandidates();
    bool searchAgain(const TrackedFrame &frame, const Candidate &candidate, Blob &blob);
    bool learnFrom(const TrackedFrame &frame, const Candidate &candidate, const ChromaDensity &background,
                   Blob &blob);
    static void fetchLuma(const TrackedFrame &frame, const Blob &blob);
    void observe(const TrackedFrame &frame, const Blob &blob, Observation &observation);
    void uncertainSize(Observation &observation) const;
    double scoreOf(const TrackedFrame &frame, const Blob &blob, const RegionShape &shape) const;
    bool isCut(const TrackedFrame &frame, const Blob &blob) const;
    void keepSilhouette(const TrackedFrame &frame, const Observation &observation);
    void uncertainWhenTouched(Observation &observation) const;
    void update(const TrackedFrame &frame, const Blob &blob, const RegionShape &shape,
                const Observation &observation);

    RgbColour m_given;
    std::shared_ptr<const BitMask> m_searched;
    Phase m_phase = Phase::Unseen;
    ColourModel m_model;
    MotionPredictor m_predictor;
    BlobFinder m_finder;
    RegionMask m_mask, m_silhouette;
    Eigen::Vector2d m_silhouetteCentre = Eigen::Vector2d::Zero();
    RegionMeasure m_measure;
    RobotOutline m_outline;
    std::vector<Candidate> m_candidates;
    Strangers m_strangers;
    ChromaRect m_occupied;
    Ellipse m_ellipse; ///< as last seen alone or touched
    AreaExpectation m_area;
    double m_radiusPx = 0;                                  ///< of the circle of that area
    Eigen::Vector2d m_halfSizePx = Eigen::Vector2d::Zero(); ///< of the last ellipse along x and y
    bool m_atBorder = false;
    bool m_touched = false;
    bool m_wantsTable = false;
    int m_missed = 0, m_framesSinceTable = 0;
    int m_framesTogether = 0; ///< in a row, in a region shared with others
};

} // namespace odo
