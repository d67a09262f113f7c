#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes t_junction.sdf, or the file named: a plain hall, a plain aisle and, where it meets a cross aisle, columns and goods. README.md has a plan."""

import pathlib
import sys

HEIGHT = 3.0

# name, x from, x to, y from, y to; their tops at 0
FLOORS = [
    ("floor_hall", -9.2, 8.2, -6.2, 6.2),
    ("floor_aisle", 8.2, 13.8, -1.7, 1.7),
    ("floor_cross", 13.8, 22.2, -8.4, 8.4),
]

# name, x from, x to, y from, y to, height
BOXES = [
    ("hall_west", -9.2, -9.0, -6.2, 6.2, HEIGHT),
    ("hall_south", -9.0, 8.0, -6.2, -6.0, HEIGHT),
    ("hall_north", -9.0, 8.0, 6.0, 6.2, HEIGHT),
    ("hall_southeast", 8.0, 8.2, -6.2, -1.5, HEIGHT),
    ("hall_northeast", 8.0, 8.2, 1.5, 6.2, HEIGHT),
    ("aisle_south", 8.2, 14.0, -1.7, -1.5, HEIGHT),
    ("aisle_north", 8.2, 14.0, 1.5, 1.7, HEIGHT),
    ("cross_southwest", 13.8, 14.0, -8.2, -1.7, HEIGHT),
    ("cross_northwest", 13.8, 14.0, 1.7, 8.2, HEIGHT),
    ("cross_south", 13.8, 22.2, -8.4, -8.2, HEIGHT),
    ("cross_north", 13.8, 22.2, 8.2, 8.4, HEIGHT),
    ("cross_east", 22.0, 22.2, -8.2, 8.2, HEIGHT),
    ("column_south", 15.0, 15.6, -2.4, -1.8, HEIGHT),
    ("column_north", 15.0, 15.6, 1.8, 2.4, HEIGHT),
    ("goods_south", 20.4, 21.6, -4.0, -2.8, 1.5),
    ("goods_middle", 20.4, 21.6, -0.9, 0.9, 2.2),
    ("goods_north", 20.4, 21.6, 2.8, 4.0, 1.5),
    ("machine", 16.5, 18.0, -8.0, -6.5, 2.0),
]


def box(name, x0, x1, y0, y1, z0, z1):
    geometry = f"<box><size>{x1 - x0:.3f} {y1 - y0:.3f} {z1 - z0:.3f}</size></box>"
    return f"""    <model name="{name}">
      <static>true</static>
      <pose>{(x0 + x1) / 2:.3f} {(y0 + y1) / 2:.3f} {(z0 + z1) / 2:.3f} 0 0 0</pose>
      <link name="link">
        <collision name="collision"><geometry>{geometry}</geometry></collision>
        <visual name="visual"><geometry>{geometry}</geometry></visual>
      </link>
    </model>
"""


def main():
    world = "".join(box(name, x0, x1, y0, y1, -0.1, 0.0) for name, x0, x1, y0, y1 in FLOORS)
    world += "".join(box(name, x0, x1, y0, y1, 0.0, height) for name, x0, x1, y0, y1, height in BOXES)
    target = sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).with_name("t_junction.sdf")
    with open(target, "w", encoding="ascii") as file:
        file.write(f'<?xml version="1.0"?>\n<sdf version="1.7">\n  <world name="t_junction">\n{world}  </world>\n</sdf>\n')


if __name__ == "__main__":
    main()
