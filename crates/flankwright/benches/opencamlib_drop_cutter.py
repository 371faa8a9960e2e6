"""Drops a cutter of OpenCAMLib along -z onto a mesh, on one core, and prints how many seconds that takes.

opencamlib_drop_cutter.py FILE.stl DIAMETER CORNER_RADIUS LENGTH POINTS

It comes down over the middles of POINTS triangles of the binary STL file, spread evenly over the file.
"""

import struct
import sys
import time

import opencamlib

HEADER = 84
TRIANGLE = struct.Struct("<12fH")
LOWEST = -1e6


def triangles(path):
    """The corners of the triangles of a binary STL file."""
    with open(path, "rb") as file:
        data = file.read()
    return [[values[i : i + 3] for i in (3, 6, 9)] for values in TRIANGLE.iter_unpack(data[HEADER:])]


def main():
    path = sys.argv[1]
    diameter, corner_radius, length = map(float, sys.argv[2:5])
    count = int(sys.argv[5])
    faces = triangles(path)
    mesh = opencamlib.STLSurf()
    for face in faces:
        mesh.addTriangle(opencamlib.Triangle(*(opencamlib.Point(*corner) for corner in face)))
    # The search holds no reference to its cutter.
    cutter = opencamlib.BullCutter(diameter, corner_radius, length)
    drop = opencamlib.BatchDropCutter()
    drop.setSTL(mesh)
    drop.setCutter(cutter)
    drop.setThreads(1)
    for number in range(count):
        corners = faces[number * len(faces) // count]
        x, y = (sum(corner[axis] for corner in corners) / 3 for axis in (0, 1))
        drop.appendPoint(opencamlib.CLPoint(x, y, LOWEST))
    begin = time.perf_counter()
    drop.run()
    seconds = time.perf_counter() - begin
    reached = sum(point.z > LOWEST for point in drop.getCLPoints())
    if reached != count:
        sys.exit(f"only {reached} of {count} points come down onto the mesh")
    print(seconds)


main()
