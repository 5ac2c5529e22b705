// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/layout_tags.h"

#include "core/calibration/internal/tag_fit.h"
#include "core/calibration/internal/tag_prediction.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace odo {

namespace {

constexpr double tagHintReachPx = 20;
constexpr std::size_t leastFitted = 4;

Message markersNotFound()
{
    return ODO_TEXT("calibration.markers_not_found", "the floor markers cannot be found");
}

Message nameFamily()
{
    return ODO_TEXT("calibration.name_tag_family",
                    "write the family into the labels, such as 36h11:7, or mark a marker by hand");
}

TagName nameOfTag(const SeenTag &tag)
{
    return {tag.family, tag.number};
}

bool isPartOf(const TagRule &rule, const SeenTag &tag)
{
    return std::ranges::any_of(rule.points, [&](const TaggedPoint &point) {
        return std::ranges::find(point.tags, nameOfTag(tag)) != point.tags.end();
    });
}

/// One reading of the layout and how the tags of an image fit it.
struct Reading
{
    const TagRule *rule = nullptr;
    std::vector<TagSighting> sightings;
    TagFit fit;

    bool isReadByChance() const
    {
        return std::ranges::all_of(sightings, [](const TagSighting &sighting) {
            return odo::isReadByChance(sighting.tags.front().family);
        });
    }
};

bool isSameFit(const Reading &one, const Reading &other)
{
    return std::ranges::equal(one.fit.inliers, other.fit.inliers, [](const auto &a, const auto &b) {
        return a.marker == b.marker && a.pixel == b.pixel;
    });
}

std::vector<TagFamily> familiesIn(const std::vector<TagRule> &rules, std::span<const TagFamily> of)
{
    std::vector<TagFamily> families;
    std::ranges::copy_if(of, std::back_inserter(families), [&](TagFamily family) {
        return std::ranges::any_of(rules, [&](const TagRule &rule) { return rule.uses(family); });
    });
    return families;
}

class TagSearch
{
public:
    TagSearch(const Frame &frame, const MarkerLayout &layout, const MarkerSearch &search)
        : m_frame(frame), m_layout(layout), m_search(search),
          m_camera(search.intrinsicsKnown ? search.camera : std::nullopt), m_rules(tagRules(layout))
    {
    }

    Result<LayoutTags> run();

private:
    bool isOnlyByPlace() const { return m_rules.size() == 1 && m_rules.front().byPlace; }
    void addTags(std::vector<SeenTag> tags);
    Reading readingOf(const TagRule &rule) const;
    bool contradictsHints(const Reading &reading) const;
    Result<std::optional<Reading>> search(const std::vector<TagFamily> &families);
    Result<std::optional<Reading>> best() const;
    Result<std::optional<Reading>> bestWithoutFit() const;
    std::optional<Error> seenTwice(const Reading &reading) const;
    void addPredicted(Reading &reading) const;
    Result<LayoutTags> complete(Reading reading) const;

    const Frame &m_frame;
    const MarkerLayout &m_layout;
    const MarkerSearch &m_search;
    const std::optional<CameraModel> m_camera;
    const std::vector<TagRule> m_rules;
    std::vector<SeenTag> m_tags; ///< that some reading has
};

Result<LayoutTags> TagSearch::run()
{
    if (m_rules.empty())
        return complete({});
    // Many families read more by chance and take longer: they come where the printed one does not fit.
    const auto printed = familiesIn(m_rules, printedTagFamily()), all = familiesIn(m_rules, allTagFamilies());
    std::optional<Reading> chosen;
    if (!printed.empty())
        chosen = ODO_TRY(search(printed));
    if (!chosen && all.size() > printed.size())
        chosen = ODO_TRY(search(all));
    if (!chosen)
        chosen = ODO_TRY(bestWithoutFit());
    return complete(chosen ? *chosen : Reading());
}

/// Those of a name that was not read yet.
void TagSearch::addTags(std::vector<SeenTag> tags)
{
    const std::vector<SeenTag> read = m_tags;
    for (SeenTag &tag : tags) {
        const auto isIt = [&](const SeenTag &other) { return nameOfTag(other) == nameOfTag(tag); };
        if (std::ranges::none_of(read, isIt) &&
            std::ranges::any_of(m_rules, [&](const TagRule &rule) { return isPartOf(rule, tag); }))
            m_tags.push_back(std::move(tag));
    }
}

Reading TagSearch::readingOf(const TagRule &rule) const
{
    Reading reading{&rule, sightingsOf(rule, m_tags), {}};
    if (!isOnlyByPlace())
        reading.fit = fitTags(m_layout, rule, reading.sightings, m_camera);
    return reading;
}

bool TagSearch::contradictsHints(const Reading &reading) const
{
    return std::ranges::any_of(reading.sightings, [&](const TagSighting &sighting) {
        const auto hint =
            std::ranges::find(m_search.hints, m_layout.markers[sighting.marker].label, &MarkerPixel::label);
        return hint != m_search.hints.end() && (hint->pixel - sighting.pixel).norm() > tagHintReachPx;
    });
}

Result<std::optional<Reading>> TagSearch::search(const std::vector<TagFamily> &families)
{
    m_tags.clear();
    addTags(findTags(m_frame, {}, families));
    auto chosen = ODO_TRY(best());
    if (!m_tags.empty() && (!chosen || chosen->sightings.size() < chosen->rule->points.size())) {
        addTags(findSmallTags(m_frame, {}, families));
        chosen = ODO_TRY(best());
    }
    return chosen;
}

/// The reading that fits with the most markers.
Result<std::optional<Reading>> TagSearch::best() const
{
    if (isOnlyByPlace())
        return readingOf(m_rules.front());
    std::vector<Reading> fitting;
    for (const TagRule &rule : m_rules) {
        Reading reading = readingOf(rule);
        if (reading.fit.isAccepted() && !contradictsHints(reading))
            fitting.push_back(std::move(reading));
    }
    if (fitting.empty())
        return std::optional<Reading>();
    const auto markersOf = [](const Reading &reading) { return reading.fit.inliers.size(); };
    std::ranges::stable_sort(fitting, std::greater(), markersOf);
    for (const Reading &other : fitting) {
        if (markersOf(other) < markersOf(fitting.front()) || isSameFit(other, fitting.front()))
            continue;
        if (other.rule->byPlace || fitting.front().rule->byPlace)
            return fail(ErrorCode::Undetermined, markersNotFound(),
                        ODO_TEXT("calibration.tags_fit_by_place_too",
                                 "the tags fit the layout by the numbers in its labels and, numbered from 0, "
                                 "by its order"),
                        nameFamily());
        return fail(
            ErrorCode::Undetermined, markersNotFound(),
            ODO_TEXT("calibration.tags_of_two_families", "tags of two families, %1 and %2, fit the layout")(
                nameOf(fitting.front().fit.inliers.front().tags.front().family),
                nameOf(other.fit.inliers.front().tags.front().family)),
            nameFamily());
    }
    return fitting.front();
}

/// Where none fits: what would be expected in the image, which may still tell what is wrong with the layout.
Result<std::optional<Reading>> TagSearch::bestWithoutFit() const
{
    std::vector<Reading> expected;
    const Reading *unexpected = nullptr;
    std::vector<Reading> readings;
    for (const TagRule &rule : m_rules)
        readings.push_back(readingOf(rule));
    for (const Reading &reading : readings) {
        if (reading.sightings.empty() || reading.isReadByChance() || contradictsHints(reading))
            continue;
        if (reading.rule->isExpected())
            expected.push_back(reading);
        else if (reading.fit.seen >= leastFitted)
            unexpected = &reading;
    }
    const auto seen = [](const Reading &reading) { return reading.fit.seen; };
    std::ranges::stable_sort(expected, std::greater(), seen);
    const bool isOne = expected.size() == 1 || (expected.size() > 1 && seen(expected[0]) > seen(expected[1]));
    const bool areMany = expected.size() > 1 && seen(expected[1]) >= leastFitted;
    if (isOne && !areMany && !unexpected)
        return expected.front();
    if (!areMany && !unexpected)
        return std::optional<Reading>();
    return fail(ErrorCode::Undetermined, markersNotFound(),
                ODO_TEXT("calibration.tags_fit_nowhere",
                         "tags with the layout's numbers are there (%1), but not at its positions")(nameOf(
                    (unexpected ? *unexpected : expected.front()).sightings.front().tags.front().family)),
                ODO_TEXT("calibration.check_tag_places",
                         "check the layout's positions and their unit, or mark the markers by hand"));
}

std::optional<Error> TagSearch::seenTwice(const Reading &reading) const
{
    for (const TagSighting &sighting : reading.sightings) {
        for (const SeenTag &tag : sighting.tags) {
            const auto count = std::ranges::count(m_tags, nameOfTag(tag), nameOfTag);
            if (count > 1)
                return Error{ErrorCode::Undetermined, markersNotFound(),
                             ODO_TEXT("calibration.tag_seen_often", "tag %1 (marker %2) appears %3 times")(
                                 tag.number, Named::marker(m_layout.markers[sighting.marker].label), count),
                             ODO_TEXT("calibration.leave_one_tag", "leave one of them on the floor")};
        }
    }
    return std::nullopt;
}

void TagSearch::addPredicted(Reading &reading) const
{
    std::vector<FloorTag> floor;
    for (const TaggedPoint &point : reading.rule->points) {
        if (point.tags.size() == 1 && !point.corner)
            floor.push_back({point.tags.front(), m_layout.markers[point.marker].pointInWorld});
    }
    std::vector<SeenTag> read;
    for (const TagSighting &sighting : reading.sightings) {
        const SeenTag &tag = sighting.tags.front();
        if (std::ranges::find(floor, nameOfTag(tag), &FloorTag::name) != floor.end() &&
            std::ranges::find(read, nameOfTag(tag), nameOfTag) == read.end())
            read.push_back(tag);
    }
    if (read.empty() || read.size() == floor.size())
        return;
    const auto found = sightingsOf(*reading.rule, predictedTags(m_frame, floor, read, m_camera));
    reading.sightings.insert(reading.sightings.end(), found.begin(), found.end());
}

Result<LayoutTags> TagSearch::complete(Reading reading) const
{
    // What reads by chance is a tag only where it fits, or lies on the floor like one: numbers that are off
    // by one fit a grid with most of them, shifted by a column.
    if (reading.isReadByChance()) {
        reading.sightings = reading.fit.inliers;
        std::ranges::copy(reading.fit.contradicting, std::back_inserter(reading.sightings));
    }
    if (const auto error = reading.isReadByChance() ? std::nullopt : seenTwice(reading))
        return tl::unexpected(*error);
    if (reading.rule)
        addPredicted(reading);
    refineGroups(m_layout, reading.sightings, m_camera);
    LayoutTags tags{{}, {}, reading.rule && reading.rule->byPlace};
    for (std::size_t i = 0; i < m_layout.markers.size(); ++i) {
        const auto seen = std::ranges::find(reading.sightings, i, &TagSighting::marker);
        if (seen == reading.sightings.end())
            tags.missing.push_back(m_layout.markers[i].label);
        else
            tags.markers.push_back({m_layout.markers[i].label, seen->pixel});
    }
    return tags;
}

} // namespace

Result<LayoutTags> findLayoutTags(const Frame &frame, const MarkerLayout &layout, const MarkerSearch &search)
{
    ODO_TRY(checkTagLabels(layout));
    return TagSearch(frame, layout, search).run();
}

std::size_t countLayoutTags(const Frame &frame, const MarkerLayout &layout)
{
    const auto rules = tagRules(layout);
    auto families = familiesIn(rules, allTagFamilies());
    std::erase_if(families, isReadByChance);
    const auto tags = findTags(frame, {}, families);
    std::size_t most = 0;
    for (const TagRule &rule : rules)
        most = std::max(most, sightingsOf(rule, tags).size());
    return most;
}

} // namespace odo
