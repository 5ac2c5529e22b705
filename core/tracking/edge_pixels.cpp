// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/edge_pixels.h"

#include "core/tracking/compared_window.h"
#include "core/tracking/difference_test.h"

namespace odo {

void EdgePixels::makeRoom(std::size_t pixels)
{
    if (pixels <= at.size())
        return;
    at.resize(pixels);
    around.resize(pixels);
    found.resize(pixels);
    for (std::vector<float> *values : {&luma, &u, &v, &lumaBehind, &uBehind, &vBehind, &lumaNoise2, &chromaNoise2})
        values->resize(pixels);
}

void EdgePixels::findCovered() // plainly, so that several are computed at once
{
    if (count == 0)
        return;
    float *__restrict into = found.front().data();
    for (std::size_t i = 0, end = count; i < end; ++i, into += 2) {
        const Sums &sums = around[i];
        const float perPixel = 1 / float(sums[insideCount]), perChroma = perPixel / ComparedWindow::chromaUnit;
        const int isNoneOutside = sums[outsideCount] == 0; // it counts as one in full light
        const float light = float(sums[outsideLight] + isNoneOutside * lightUnit) / float((sums[outsideCount] + isNoneOutside) * lightUnit);
        const float lumaOutside = light * lumaBehind[i], uOutside = light * uBehind[i], vOutside = light * vBehind[i];
        const float dy = float(sums[insideLuma]) * perPixel - lumaOutside;
        const float du = float(sums[insideU]) * perChroma - uOutside, dv = float(sums[insideV]) * perChroma - vOutside;
        const float y2 = lumaNoise2[i], c2 = chromaNoise2[i];
        const float contrast = dy * dy * c2 + (du * du + dv * dv) * y2; // times both variances, as `along`
        const float along = (luma[i] - lumaOutside) * dy * c2 + ((u[i] - uOutside) * du + (v[i] - vOutside) * dv) * y2;
        into[0] = along / contrast;
        into[1] = contrast - differsInSigmas2 * y2 * c2;
    }
}

} // namespace odo
