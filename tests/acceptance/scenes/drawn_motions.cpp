// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/drawn_motions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo::test {

namespace {

using std::numbers::pi;

/// Whether a walk keeps to the floor, and to speeds and accelerations that a classroom's robot has.
bool isDrivable(const Motion &motion, double endS)
{
    for (double t = 0; t <= endS; t += 0.02) {
        const MotionState state = motion.at(t);
        const double speed = state.velocity.norm();
        const bool onItsWay = t > 0.5 && t < endS - 0.5;
        if (state.position.x() < 0.3 || state.position.x() > 2.7 || state.position.y() < 0.25 ||
            state.position.y() > 1.95 || speed > 1.6 || state.acceleration.norm() > 6 ||
            (onItsWay && speed < 0.15))
            return false;
    }
    return true;
}

} // namespace

SharedMotion drawnLine(SeededDraw &draw, double durationS)
{
    const Eigen::Vector2d start(draw.between(0.3, 0.6), draw.between(0.4, 1.8));
    const Eigen::Vector2d end(draw.between(2.4, 2.7), draw.between(0.4, 1.8));
    return makeLineMotion(start, end, draw.between(0.7, 1.2), durationS);
}

SharedMotion drawnCircle(SeededDraw &draw)
{
    const double radius = draw.between(0.55, 0.75), speed = draw.between(0.8, 1.2);
    return makeEllipseMotion({draw.between(1.3, 1.7), draw.between(1.03, 1.17)}, radius, radius,
                             2 * pi * radius / speed, draw.between(0, 2 * pi), draw.between(1.0, 1.6));
}

SharedMotion drawnFigureEight(SeededDraw &draw, double topSpeedMps)
{
    const double a = draw.between(0.9, 1.1), b = draw.between(0.5, 0.65);
    // Fastest in the middle, where it crosses itself.
    const double period = 2 * pi * std::hypot(a, 2 * b) / topSpeedMps;
    return makeFigureEightMotion({draw.between(1.45, 1.55), draw.between(1.05, 1.15)}, draw.sign() * a, b,
                                 period, draw.between(1.0, 1.5));
}

SharedMotion drawnStopAndGo(SeededDraw &draw)
{
    const auto near = [&](double x, double y) {
        return Eigen::Vector2d(x + draw.between(-0.12, 0.12), y + draw.between(-0.12, 0.12));
    };
    return makeStopAndGoMotion({near(0.5, 0.5), near(2.4, 0.6), near(2.3, 1.65), near(0.7, 1.6)},
                               draw.between(1.7, 2.0), draw.between(0.6, 0.8));
}

SharedMotion drawnWander(SeededDraw &draw, int points, double stepS)
{
    for (;;) {
        std::vector<Eigen::Vector2d> way{{draw.between(0.5, 2.5), draw.between(0.5, 1.7)}};
        double direction = draw.between(0, 2 * pi);
        while (static_cast<int>(way.size()) < points) {
            direction += draw.between(-1.3, 1.3);
            const double stepM = stepS * draw.between(0.4, 1.1);
            way.emplace_back(way.back() + stepM * Eigen::Vector2d(std::cos(direction), std::sin(direction)));
        }
        SharedMotion motion = makeSplineMotion(std::move(way), stepS);
        if (isDrivable(*motion, stepS * (points - 1)))
            return motion;
    }
}

SharedMotion drawnCrawl(SeededDraw &draw, double durationS)
{
    const double direction = draw.between(0, 2 * pi), speed = draw.between(0.025, 0.05);
    const Eigen::Vector2d velocity = speed * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    const Eigen::Vector2d start(draw.between(0.8, 2.2), draw.between(0.7, 1.5));
    return makeVelocityMotion(start, direction, {{0.5, 0.4, velocity}, {durationS - 1.5, 0.4, -velocity}});
}

SharedMotion drawnCollision(SeededDraw &draw, double impactS)
{
    constexpr double contactS = 0.03;
    const double direction = draw.between(-0.25, 0.25), speed = draw.between(0.8, 1.1);
    const double back = draw.between(0.2, 0.4); // of the speed
    const Eigen::Vector2d velocity = speed * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    const Eigen::Vector2d wall(draw.between(2.2, 2.5), draw.between(0.9, 1.5));
    const double startS = 1.0, rampS = 0.8;
    // By its ramp's half and the way to the contact's first half.
    const Eigen::Vector2d start = wall - velocity * (impactS - startS - rampS / 2);
    return makeVelocityMotion(start, direction,
                              {{startS, rampS, velocity},
                               {impactS - contactS / 2, contactS, -(1 + back) * velocity},
                               {impactS + 0.3, 0.6, back * velocity}});
}

} // namespace odo::test
