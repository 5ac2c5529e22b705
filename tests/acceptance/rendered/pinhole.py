# SPDX-License-Identifier: GPL-3.0-or-later
import numpy

WIDTH, HEIGHT = 1280, 720


class Camera:
    """An ideal pinhole camera whose pixel centres have whole coordinates."""

    def __init__(self, name, position, target, focal_px):
        self.name, self.focal_px = name, focal_px
        self.position = numpy.array(position)
        forward = numpy.array(target) - self.position
        self.forward = forward / numpy.linalg.norm(forward)
        right = numpy.cross(self.forward, (0, 0, 1))
        self.right = right / numpy.linalg.norm(right)
        self.down = numpy.cross(self.forward, self.right)

    def pixel(self, point):
        away = numpy.array(point) - self.position
        depth = away @ self.forward
        return (WIDTH / 2 - 0.5 + self.focal_px * (away @ self.right) / depth,
                HEIGHT / 2 - 0.5 + self.focal_px * (away @ self.down) / depth)

    def povray(self):
        vector = lambda v: "<%.9f,%.9f,%.9f>" % tuple(v)
        return "camera { location %s direction %s right %s up %s }\n" % (
            vector(self.position), vector(self.forward), vector(self.right * WIDTH / self.focal_px),
            vector(-self.down * HEIGHT / self.focal_px))

    def yaml(self):
        return (f"image_width: {WIDTH}\nimage_height: {HEIGHT}\ncamera_name: {self.name}\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
                f"  data: [{self.focal_px}, 0, {WIDTH / 2 - 0.5}, 0, {self.focal_px}, {HEIGHT / 2 - 0.5}, 0, 0, 1]\n"
                "distortion_model: plumb_bob\ndistortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [0, 0, 0, 0, 0]\n")
