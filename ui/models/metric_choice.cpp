// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/metric_choice.h"

#include <algorithm>
#include <string>

namespace odo {

std::vector<Metric> tellingMetrics(const std::vector<Metric> &all, std::size_t count)
{
    static const std::vector<std::string> order = {"gate_time", "best_lap",    "laps",      "cross_track_rms",
                                                   "duration",  "path_length", "max_speed", "mean_speed",
                                                   "max_accel", "moving_time"};
    std::vector<Metric> chosen;
    for (const std::string &name : order) {
        const auto found = std::ranges::find(all, name, &Metric::name);
        if (found != all.end())
            chosen.push_back(*found);
    }
    for (const Metric &metric : all) {
        if (std::ranges::find(chosen, metric.name, &Metric::name) == chosen.end())
            chosen.push_back(metric);
    }
    chosen.resize(std::min(chosen.size(), count));
    return chosen;
}

std::vector<std::string> tellingNames(const std::vector<std::string> &names)
{
    std::vector<Metric> known;
    for (const std::string &name : names)
        known.push_back({name, {}, 0, {}});
    std::vector<std::string> ordered;
    for (Metric &metric : tellingMetrics(known, known.size()))
        ordered.push_back(std::move(metric.name));
    return ordered;
}

} // namespace odo
