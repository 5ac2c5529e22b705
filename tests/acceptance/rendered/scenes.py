# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenes of render_scenes: a robot, a room and a motion each, in POV-Ray's language. They show what holds on material
that nothing was tuned on, so draw new ones once the tracker was changed because of these."""

from dataclasses import dataclass, field
from math import atan2, cos, pi, sin
from typing import Callable

from pinhole import Camera


@dataclass
class Scene:
    robot: str  # objects about the footprint's centre
    room: str
    motion: Callable  # of seconds: x, y, heading
    cameras: list = field(default_factory=lambda: two_cameras())
    seconds: float = 4
    reach: float = 0.45  # of the robot and its shadow on the floor, metres
    reach_height: float = 0.3
    noise: float = 1.2  # standard deviation of a code value
    size_mm: tuple = (200, 150)  # what a user would measure
    height_mm: float = 80


def two_cameras(height=2.0, back=2.1, focal_px=950):
    return [Camera("A", (-back, -1.9, height), (0, 0.05, 0), focal_px), Camera("B", (back + 0.15, -1.8, height + 0.15), (0, 0, 0), focal_px)]


# Motions


def circle(radius=0.6, speed=0.5, centre=(0, 0), start=0.3):
    def pose(t):
        angle = start + speed / radius * t
        return centre[0] + radius * cos(angle), centre[1] + radius * sin(angle), angle + pi / 2
    return pose


def eight(width=0.75, depth=0.45, period=5.0, start=0.15):
    def pose(t):
        a = 2 * pi * (t / period + start)
        return width * sin(a), depth * sin(2 * a), atan2(2 * depth * cos(2 * a), width * cos(a))
    return pose


def straight(start=(-0.8, -0.3), heading=0.35, speed=0.6, ramp=0.5, seconds=4):
    """From rest to rest, with constant accelerations."""
    def pose(t):
        t = min(max(t, 0), seconds)
        cruise = seconds - ramp
        if t < ramp:
            path = speed * t * t / (2 * ramp)
        elif t < cruise:
            path = speed * (t - ramp / 2)
        else:
            path = speed * (cruise - ramp / 2) + speed * (t - cruise) - speed * (t - cruise) ** 2 / (2 * ramp)
        return start[0] + path * cos(heading), start[1] + path * sin(heading), heading
    return pose


def turning(at=(0.1, 0.05), drift=0.25, turns=0.35):
    """Strafes to and fro while it turns, as a robot with mecanum wheels can."""
    def pose(t):
        return at[0] + 0.5 * sin(2 * pi * drift * t), at[1] + 0.35 * sin(4 * pi * drift * t + 0.4), 2 * pi * turns * t
    return pose


# Materials and parts


def paint(rgb, gloss=0.0, mirror=0.0):
    return "texture { pigment { color rgb <%g,%g,%g> } finish { ambient 0 diffuse 0.85 specular %g roughness 0.02 reflection %g } }" % (
        *rgb, gloss, mirror)


def box(x0, y0, z0, x1, y1, z1, look):
    return f"box {{ <{x0},{y0},{z0}>, <{x1},{y1},{z1}> {look} }}\n"


def wheel(x, y, radius, width, look):
    return f"cylinder {{ <{x},{y - width / 2},{radius}>, <{x},{y + width / 2},{radius}>, {radius} {look} }}\n"


def wheels(positions, radius, width, look):
    return "".join(wheel(x, y, radius, width, look) for x, y in positions)


RUBBER = paint((0.02, 0.02, 0.022), 0.1)
BLACK = paint((0.03, 0.03, 0.032), 0.2)
STEEL = paint((0.5, 0.5, 0.52), 0.5, 0.15)


def floor(texture):
    return f"plane {{ z, 0 {texture} }}\n"


def lamp(x, y, z, power, size=0.0, colour=(1, 1, 1), reach=4):
    r, g, b = (power * c for c in colour)
    area = f"area_light <{size},0,0>, <0,{size},0>, 4, 4 adaptive 1 jitter circular orient" if size else ""
    return f"light_source {{ <{x},{y},{z}> color rgb <{r},{g},{b}> {area} fade_distance {reach} fade_power 2 }}\n"


def sky(power, colour=(1, 1, 1)):
    """Light from everywhere, without a shadow: what the walls throw back."""
    r, g, b = (power * c for c in colour)
    return "".join(f"light_source {{ <{x},{y},5> color rgb <{r / 4},{g / 4},{b / 4}> shadowless }}\n" for x in (-4, 4) for y in (-4, 4))


WOOD = floor("texture { pigment { wood turbulence 0.06 color_map { [0 rgb <0.62,0.44,0.27>] [0.8 rgb <0.52,0.35,0.2>] [1 rgb <0.4,0.26,0.14>] } "
             "rotate y*88 rotate z*12 scale <0.5,0.06,0.06> } finish { ambient 0 diffuse 0.8 specular 0.1 } }")
LINO = floor("texture { pigment { granite color_map { [0 rgb 0.42] [1 rgb 0.56] } scale 0.03 } finish { ambient 0 diffuse 0.8 } }")
PLAIN = floor("texture { pigment { color rgb <0.55,0.54,0.52> } finish { ambient 0 diffuse 0.8 } }")
BLUE_MAT = floor("texture { pigment { bozo color_map { [0 rgb <0.05,0.12,0.3>] [1 rgb <0.07,0.15,0.35>] } scale 0.02 } finish { ambient 0 diffuse 0.8 } }")
BOARD = floor("texture { pigment { checker rgb 0.75, rgb 0.12 scale 0.3 } finish { ambient 0 diffuse 0.8 specular 0.2 } }")
GLOSS = floor("texture { pigment { color rgb <0.5,0.45,0.38> } finish { ambient 0 diffuse 0.7 specular 0.4 reflection 0.12 } }")
CARPET = floor("texture { pigment { bozo turbulence 1 color_map { [0 rgb <0.2,0.21,0.22>] [1 rgb <0.36,0.34,0.33>] } scale 0.008 } finish { ambient 0 diffuse 0.8 } }")

# Robots

MECANUM = (box(-0.12, -0.07, 0.03, 0.12, 0.07, 0.055, STEEL)
           + wheels([(x, y) for x in (-0.08, 0.08) for y in (-0.09, 0.09)], 0.04, 0.035, paint((0.05, 0.05, 0.05)))
           + wheels([(x, y) for x in (-0.08, 0.08) for y in (-0.09, 0.09)], 0.03, 0.037, paint((0.7, 0.55, 0.05)))
           + box(-0.05, -0.035, 0.07, 0.04, 0.025, 0.074, paint((0.02, 0.3, 0.1))))
DOME = (f"intersection {{ sphere {{ <0,0,0>, 0.1 }} box {{ <-1,-1,0.012>, <1,1,1> }} {paint((0.8, 0.8, 0.78), 0.6)} }}\n"
        + box(0.05, -0.02, 0.05, 0.095, 0.02, 0.065, BLACK) + wheels([(0, -0.05), (0, 0.05)], 0.02, 0.015, RUBBER))
TRICYCLE = (box(-0.11, -0.05, 0.045, 0.09, 0.05, 0.05, BLACK) + box(-0.06, -0.035, 0.05, 0.05, 0.035, 0.105, paint((0.75, 0.25, 0.03)))
            + wheels([(-0.06, -0.075), (-0.06, 0.075)], 0.055, 0.02, RUBBER) + wheel(0.08, 0, 0.025, 0.02, RUBBER))
BRICKS = (box(-0.1, -0.06, 0.01, 0.1, 0.06, 0.05, paint((0.6, 0.04, 0.03), 0.5)) + box(-0.1, -0.06, 0.05, 0.0, 0.06, 0.09, paint((0.7, 0.55, 0.03), 0.5))
          + box(-0.1, -0.02, 0.09, -0.04, 0.06, 0.14, paint((0.03, 0.1, 0.5), 0.5)) + wheels([(-0.07, 0), (0.07, 0)], 0.025, 0.15, RUBBER))
DARK_ROVER = (box(-0.11, -0.07, 0.05, 0.11, 0.07, 0.1, paint((0.06, 0.06, 0.065)))
              + wheels([(x, y) for x in (-0.075, 0.075) for y in (-0.085, 0.085)], 0.03, 0.028, RUBBER))
CAN = (f"cylinder {{ <0,0,0.015>, <0,0,0.17>, 0.075 {paint((0.6, 0.6, 0.62), 0.6, 0.35)} }}\n"
       + box(0.07, -0.03, 0.06, 0.085, 0.03, 0.08, BLACK) + wheels([(0, -0.055), (0, 0.055)], 0.03, 0.02, RUBBER))
PLOUGH = (box(-0.1, -0.05, 0.02, 0.08, 0.05, 0.06, paint((0.05, 0.35, 0.1))) + box(0.09, -0.13, 0.005, 0.1, 0.13, 0.07, paint((0.7, 0.6, 0.1)))
          + box(0.07, -0.02, 0.03, 0.1, 0.02, 0.04, STEEL) + wheels([(x, y) for x in (-0.06, 0.05) for y in (-0.06, 0.06)], 0.03, 0.02, RUBBER))
GREY_CRAWLER = (box(-0.09, -0.05, 0.015, 0.09, 0.05, 0.06, paint((0.3, 0.3, 0.3)))
                + "".join(box(-0.12, y - 0.02, 0, 0.12, y + 0.02, 0.05, paint((0.12, 0.12, 0.12))) for y in (-0.075, 0.075))
                + f"cylinder {{ <-0.03,0,0.06>, <-0.03,0,0.2>, 0.008 {STEEL} }}\n" + f"sphere {{ <-0.03,0,0.2>, 0.025 {paint((0.3, 0.3, 0.3))} }}\n")

CEILING = lamp(-0.6, 0.3, 2.9, 0.45, 0.5) + lamp(0.9, -0.2, 2.9, 0.45, 0.5) + sky(0.3)
WINDOW = lamp(-4, 2.5, 2.2, 2.6, 1.2, (0.9, 0.96, 1.1), 5) + sky(0.45)
DESK_LAMP = lamp(0.5, 0.8, 1.9, 1.6, 0.12, (1.1, 0.95, 0.75), 2) + sky(0.22)
SPOT = lamp(0.5, 0.25, 2.6, 1.5, 0.1, reach=3) + sky(0.3)

ALL = {
    "mecanum-wood": Scene(MECANUM, WINDOW + WOOD, turning(), size_mm=(240, 215), height_mm=80),
    "dome-lino": Scene(DOME, CEILING + LINO, circle(), size_mm=(200, 200), height_mm=100),
    "tricycle-blue-mat": Scene(TRICYCLE, DESK_LAMP + BLUE_MAT, eight(), size_mm=(220, 170), height_mm=110),
    "bricks-board": Scene(BRICKS, CEILING + BOARD, eight(start=0.4), size_mm=(200, 150), height_mm=140),
    "dark-rover-plain": Scene(DARK_ROVER, SPOT + PLAIN, circle(0.7, 0.6), size_mm=(220, 198), height_mm=100),
    "dark-rover-window": Scene(DARK_ROVER, WINDOW + LINO, eight(), size_mm=(220, 198), height_mm=100),
    "can-gloss": Scene(CAN, CEILING + GLOSS, straight(), size_mm=(150, 150), height_mm=170),
    "plough-carpet": Scene(PLOUGH, DESK_LAMP + CARPET, straight((-0.7, 0.4), -0.5, 0.5), size_mm=(200, 260), height_mm=70),
    "crawler-lino": Scene(GREY_CRAWLER, WINDOW + LINO, turning(turns=0.15), size_mm=(240, 190), height_mm=225),
    "crawler-low-cameras": Scene(GREY_CRAWLER, CEILING + PLAIN, eight(), two_cameras(1.1, 2.0, 900), size_mm=(240, 190), height_mm=225),
}
