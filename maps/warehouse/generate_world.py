#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes warehouse.sdf: a warehouse of primitives, with places where a lidar cut to 6.5 m localizes well and places where it cannot.

Usage: generate_world.py [OUTPUT]      (default: warehouse.sdf beside this script)

Frame `map`: metres, x right, y up on the plan, z = 0 on the floor. No roof: nothing above 3.2 m is in view, and Gazebo's camera looks in.

    45 +-----------------------+------------------------------------+
       |                       |  ======= rack 1 ================   |
       |                       |          aisle 1                   |
       |                       |  ======= racks 2, 3 ============   |
       |       H  (hall)      door        aisle 2                   |
       |                       |  ======= racks 4, 5 ============   |
       |                       |          aisle 3                   |
       |                       |  ======= rack 6 ================   |
       |                       |          aisle 4                   |
    24 +---door---+------------+--------------------------+---door--+
       |          B             plain corridor            C         |
    21 |  start   +---------+---------+---------+---------+  goal   |
       |        --|         |         |         |         |--       |
       |          | room 1  | room 2  | room 3  | room 4  |         |
    16 |----      +--door---+--door---+--door---+--door---+     ----|
       |         door   G  (goods lane, the safe way)    door       |
       |    A     |  [] [] [] [] [] [] [] [] [] columns   |    D    |
     5 |          +---------------------------------------+         |
       |         door   P  (dock gallery, equal bays)    door       |
     0 +----------+---------------------------------------+---------+
       0          10           23                         50       60
"""

import pathlib
import sys

# The building [m].
LENGTH, WIDTH = 60.0, 45.0
WALL_HEIGHT, WALL_THICKNESS = 5.0, 0.2
DOOR_HEIGHT = 3.0
CORRIDOR_SOUTH, CORRIDOR_NORTH = 20.9, 24.1  # wall centre lines: 3 m clear between them
LOBBY_WEST, LOBBY_EAST = 10.0, 50.0          # the corridor's ends B and C
HALL_EAST = 23.0
ROOMS_SOUTH, GALLERY_NORTH = 15.9, 5.1

# Racks [m].
RACK_WEST, BAY, BAYS, SLOTS = 26.0, 3.0, 10, 3  # 30 m: ten bays of three pallets
RACK_DEPTH, RACK_HEIGHT = 1.2, 3.6
POST, BEAM_HEIGHT, BEAM_DEPTH = 0.1, 0.12, 0.05
SHELF = 1.72                                    # top of the beams that carry the upper pallets
LOADS = {"S": (0.6, 0.8), "M": (0.8, 1.1), "H": (0.8, 1.4), "F": (0.92, 1.4)}  # width, height with the pallet; '.' is a missing one
SETBACKS = (0.0, 0.12, 0.04, 0.2, 0.08)         # how far a load stands behind the rack's front, in turn
SIDESTEPS = (0.0, 0.05, -0.04, 0.02, -0.05)     # and how far off its slot's middle

# Rack fronts from north to south: y, the side the front looks to, pallets on the floor, pallets on the shelf.
RACKS = (
    (43.4, -1, "S.M|M.S|.HS|S.S|M.H|.SM|S.H|H.S|.MS|S.M", "M.H|.SM|S.M|H..|.MS|M.S|..H|S.M|M.S|.H."),
    (40.2, +1, ".SM|S.H|M.S|.MS|S.M|H.S|.SM|S.H|M.S|.SM", "H.M|S.S|.M.|M.H|S..|.SM|M.S|.H.|S.M|M.S"),
    (37.6, -1, "MHM|.MH|HM.|MMH|H.M|MHM|.HM|MHH|M.M|HMM", "HMH|M.M|HHM|.MH|MHM|H.M|MMH|HM.|MHM|M.H"),
    (34.4, +1, "HMM|MH.|MHM|H.M|MMH|.HM|MHM|HM.|MMH|M.H", "M.H|HMM|MH.|HMM|M.H|MHM|H.M|MMH|.HM|MHM"),
    (31.8, -1, "FFF|FFF|FFF|FFF|FFF|FFF|FFF|FFF|FFF|FFF", "FFF|FFF|FFF|FFF|FFF|FFF|FFF|FFF|FFF|FFF"),
    (28.6, +1, "FFF|FFF|FFF|FFF|F.F|M.S|.HM|S.M|M.H|.SM", "FFF|FFF|FFF|FFF|FFF|.HM|S.M|H.S|.M.|M.S"),
)

# Square columns [m].
COLUMN = 0.9
LANE_COLUMNS = (  # y of a row, x of its first column; the rows are staggered, so that one is never abreast of both
    (9.4, 15.0),
    (13.8, 13.0),
)
LANE_COLUMN_PITCH, LANE_COLUMNS_A_ROW = 4.0, 9
LOBBY_COLUMNS = ((2.6, 8.3), (2.6, 12.5), (2.2, 18.6), (7.4, 7.6))  # the west lobby's; the east lobby mirrors them

# The dock gallery's pilasters [m]: every bay alike.
PILASTER_WIDTH, PILASTER_DEPTH, PILASTER_PITCH = 0.5, 0.4, 3.0

# Goods set down on the floor: west edge, south edge, pallets along x, pallets along y, number of the first height.
PALLET_X, PALLET_Y, PALLET_GAP = 1.2, 0.8, 0.15
GOODS_HEIGHTS = (1.0, 1.4, 0.8, 1.2, 0.9)
GOODS = {
    "goods_lane_south": ((11.0, 5.4, 2, 2, 1), (16.2, 5.4, 1, 3, 0), (19.9, 5.5, 2, 2, 3), (24.6, 5.4, 1, 3, 2), (28.2, 5.6, 2, 2, 4),
                         (32.3, 5.4, 2, 3, 0), (37.1, 5.5, 1, 2, 3), (40.6, 5.4, 2, 3, 1), (46.4, 5.5, 2, 2, 2)),
    "goods_lane_north": ((18.4, 14.9, 2, 1, 0), (28.1, 14.9, 1, 1, 3), (30.6, 14.9, 1, 1, 1), (38.3, 14.9, 2, 1, 2), (47.6, 14.9, 1, 1, 0)),
    "goods_west_lobby": ((0.4, 20.6, 1, 2, 0), (0.4, 13.2, 1, 2, 2), (8.4, 14.2, 1, 2, 3),
                         (4.6, 12.0, 1, 2, 3), (4.8, 9.2, 1, 2, 4), (8.4, 6.0, 1, 2, 1)),
    "goods_east_lobby": ((58.3, 20.2, 1, 3, 1), (58.3, 13.0, 1, 2, 3), (50.5, 14.5, 1, 2, 0),
                         (54.4, 12.1, 1, 2, 0), (54.0, 8.8, 1, 2, 1), (50.5, 5.7, 1, 2, 3)),
}

COLOURS = {"floor": "0.55 0.55 0.55", "wall": "0.85 0.85 0.8", "column": "0.7 0.7 0.7",
           "rack": "0.1 0.25 0.6", "load": "0.7 0.5 0.3", "drum": "0.2 0.45 0.3"}


def number(value):
    """A length to the millimetre, without trailing zeros."""
    return f"{round(value, 3) + 0.0:.3f}".rstrip("0").rstrip(".")


class Model:
    """One static model of one link: a meaningful thing of the warehouse."""

    def __init__(self, name, kind):
        self.name, self.kind, self.parts = name, kind, []

    def box(self, name, x, y, z):
        """An axis-aligned box; x, y and z are (from, to)."""
        centre = " ".join(number((low + high) / 2) for low, high in (x, y, z))
        size = " ".join(number(high - low) for low, high in (x, y, z))
        self.parts.append((name, centre, f"<box><size>{size}</size></box>"))

    def cylinder(self, name, x, y, radius, height):
        """An upright cylinder on the floor."""
        shape = f"<cylinder><radius>{number(radius)}</radius><length>{number(height)}</length></cylinder>"
        self.parts.append((name, f"{number(x)} {number(y)} {number(height / 2)}", shape))

    def sdf(self):
        paint = f"<material><ambient>{COLOURS[self.kind]} 1</ambient><diffuse>{COLOURS[self.kind]} 1</diffuse></material>"
        lines = [f'    <model name="{self.name}">', "      <static>true</static>", '      <link name="link">']
        for name, centre, shape in self.parts:
            body = f"<pose>{centre} 0 0 0</pose><geometry>{shape}</geometry>"
            lines.append(f'        <collision name="{name}">{body}</collision>')
            lines.append(f'        <visual name="{name}">{body}{paint}</visual>')
        return lines + ["      </link>", "    </model>"]


def floor():
    model = Model("floor", "floor")
    model.box("slab", (0, LENGTH), (0, WIDTH), (-0.1, 0))
    return model


def wall(name, start, end, doors=()):
    """A wall along x or y between two points of its centre line; doors are (from, to) along it."""
    along = 0 if start[1] == end[1] else 1
    across = start[1 - along]
    thickness = (across - WALL_THICKNESS / 2, across + WALL_THICKNESS / 2)
    model = Model(name, "wall")

    def piece(part, low, high, z):
        model.box(part, *(((low, high), thickness) if along == 0 else (thickness, (low, high))), z)

    edges = [start[along]] + [edge for door in doors for edge in door] + [end[along]]
    for i in range(0, len(edges), 2):
        piece(f"wall_{i // 2 + 1}", edges[i], edges[i + 1], (0, WALL_HEIGHT))
    for i, (low, high) in enumerate(doors):
        piece(f"lintel_{i + 1}", low, high, (DOOR_HEIGHT, WALL_HEIGHT))
    return model


def walls():
    edge = WALL_THICKNESS / 2
    west, east, south, north = edge, LENGTH - edge, edge, WIDTH - edge
    room_doors = tuple((x - 1.3, x + 1.3) for x in (15.0, 25.0, 35.0, 45.0))
    yield wall("outer_wall_south", (0, south), (LENGTH, south))
    yield wall("outer_wall_north", (0, north), (LENGTH, north))
    yield wall("outer_wall_west", (west, 2 * edge), (west, WIDTH - 2 * edge))
    yield wall("outer_wall_east", (east, 2 * edge), (east, WIDTH - 2 * edge))
    yield wall("corridor_wall_north", (2 * edge, CORRIDOR_NORTH), (LENGTH - 2 * edge, CORRIDOR_NORTH), ((3.6, 6.4), (54.6, 58.0)))
    yield wall("corridor_wall_south", (LOBBY_WEST + edge, CORRIDOR_SOUTH), (LOBBY_EAST - edge, CORRIDOR_SOUTH))
    yield wall("lobby_wall_west", (LOBBY_WEST, 2 * edge), (LOBBY_WEST, CORRIDOR_SOUTH + edge), ((1.2, 4.0), (9.9, 13.3)))
    yield wall("lobby_wall_east", (LOBBY_EAST, 2 * edge), (LOBBY_EAST, CORRIDOR_SOUTH + edge), ((1.2, 4.0), (9.9, 13.3)))
    for x_far, x_near, side in ((2 * edge, 4.2, "west"), (LENGTH - 4.2, LENGTH - 2 * edge, "east")):
        yield wall(f"{side}_lobby_outer_stub", (x_far, 15.5), (x_near, 15.5))
    for x_far, x_near, side in ((7.8, LOBBY_WEST - edge, "west"), (LOBBY_EAST + edge, LENGTH - 7.8, "east")):
        yield wall(f"{side}_lobby_inner_stub", (x_far, 18.8), (x_near, 18.8))
    yield wall("hall_wall", (HALL_EAST, CORRIDOR_NORTH + edge), (HALL_EAST, WIDTH - 2 * edge), ((34.4, 37.6),))
    yield wall("gallery_wall", (LOBBY_WEST + edge, GALLERY_NORTH), (LOBBY_EAST - edge, GALLERY_NORTH))
    yield wall("room_front", (LOBBY_WEST + edge, ROOMS_SOUTH), (LOBBY_EAST - edge, ROOMS_SOUTH), room_doors)
    for i, x in enumerate((20.0, 30.0, 40.0)):
        yield wall(f"room_wall_{i + 1}", (x, ROOMS_SOUTH + edge), (x, CORRIDOR_SOUTH - edge))


def column(model, name, x, y):
    model.box(name, (x - COLUMN / 2, x + COLUMN / 2), (y - COLUMN / 2, y + COLUMN / 2), (0, WALL_HEIGHT))


def columns():
    for row, (y, first_x) in enumerate(LANE_COLUMNS):
        model = Model(f"lane_columns_{row + 1}", "column")
        for i in range(LANE_COLUMNS_A_ROW):
            column(model, f"column_{i + 1}", first_x + LANE_COLUMN_PITCH * i, y)
        yield model
    for side in ("west", "east"):
        model = Model(f"{side}_lobby_columns", "column")
        for i, (x, y) in enumerate(LOBBY_COLUMNS):
            column(model, f"column_{i + 1}", x if side == "west" else LENGTH - x, y)
        yield model


def pilasters():
    model = Model("gallery_pilasters", "column")
    south, north = WALL_THICKNESS, GALLERY_NORTH - WALL_THICKNESS / 2
    count = int((LOBBY_EAST - LOBBY_WEST) / PILASTER_PITCH)
    for i in range(count):
        x = LOBBY_WEST + PILASTER_PITCH * (i + 0.5)
        x_range = (x - PILASTER_WIDTH / 2, x + PILASTER_WIDTH / 2)
        model.box(f"south_{i + 1}", x_range, (south, south + PILASTER_DEPTH), (0, WALL_HEIGHT))
        model.box(f"north_{i + 1}", x_range, (north - PILASTER_DEPTH, north), (0, WALL_HEIGHT))
    return model


def rack(name, front, side, on_floor, on_shelf):
    """A rack row of 30 m: posts, beams and pallets; `side` is +1 when its front looks to +y."""
    model = Model(name, "rack")

    def deep(low, high):
        """From depths behind the front to y."""
        return tuple(sorted((front - side * low, front - side * high)))

    for i in range(BAYS + 1):
        x = (RACK_WEST + BAY * i - POST / 2, RACK_WEST + BAY * i + POST / 2)
        model.box(f"post_front_{i + 1}", x, deep(0, POST), (0, RACK_HEIGHT))
        model.box(f"post_back_{i + 1}", x, deep(RACK_DEPTH - POST, RACK_DEPTH), (0, RACK_HEIGHT))
    for level, top in (("shelf", SHELF), ("top", RACK_HEIGHT)):
        for part, depth in (("front", 0.02), ("back", RACK_DEPTH - BEAM_DEPTH - 0.02)):
            ends = (RACK_WEST, RACK_WEST + BAY * BAYS)
            model.box(f"beam_{level}_{part}", ends, deep(depth, depth + BEAM_DEPTH), (top - BEAM_HEIGHT, top))
    yield model
    yield rack_loads(f"{name}_loads", deep, on_floor, on_shelf)


def rack_loads(name, deep, on_floor, on_shelf):
    model = Model(name, "load")
    slot = (BAY - POST) / SLOTS
    for level, base, rows in (("floor", 0.0, on_floor), ("shelf", SHELF, on_shelf)):
        for bay, loads in enumerate(rows.split("|")):
            for i, kind in enumerate(loads):
                if kind == ".":
                    continue
                width, height = LOADS[kind]
                turn = SLOTS * bay + i + (2 if base else 0)
                neat = kind == "F"
                setback = 0.0 if neat else SETBACKS[turn % len(SETBACKS)]
                sidestep = 0.0 if neat else SIDESTEPS[turn % len(SIDESTEPS)]
                x = RACK_WEST + BAY * bay + POST / 2 + slot * (i + 0.5) + sidestep
                model.box(f"{level}_{bay + 1}_{i + 1}", (x - width / 2, x + width / 2), deep(setback, RACK_DEPTH), (base, base + height))
    return model


def goods(name, islands):
    """Block storage: islands of pallets on the floor, low enough for the lidar to look over."""
    model = Model(name, "load")
    for n, (west, south, along_x, along_y, first) in enumerate(islands):
        for i in range(along_x * along_y):
            x = west + (i % along_x) * (PALLET_X + PALLET_GAP)
            y = south + (i // along_x) * (PALLET_Y + PALLET_GAP)
            height = GOODS_HEIGHTS[(first + i) % len(GOODS_HEIGHTS)]
            model.box(f"island_{n + 1}_{i + 1}", (x, x + PALLET_X), (y, y + PALLET_Y), (0, height))
    return model


def drums():
    model = Model("room_1_drums", "drum")
    for i in range(4):
        model.cylinder(f"drum_{i + 1}", 11.0 + 0.7 * i, 20.2, 0.3, 0.9)
    return model


def warehouse():
    """Every model of the world, in the order of the file."""
    yield floor()
    yield from walls()
    yield from columns()
    yield pilasters()
    for i, row in enumerate(RACKS):
        yield from rack(f"rack_{i + 1}", *row)
    for name, islands in GOODS.items():
        yield goods(name, islands)
    yield drums()


def sdf(models):
    lines = [
        '<?xml version="1.0"?>',
        "<!-- Written by generate_world.py: change that, not this. -->",
        '<sdf version="1.7">',
        '  <world name="warehouse">',
        '    <light name="sun" type="directional">',
        "      <pose>0 0 20 0 0 0</pose><diffuse>0.9 0.9 0.9 1</diffuse><direction>-0.4 0.3 -0.9</direction>",
        "    </light>",
    ]
    for model in models:
        lines += model.sdf()
    return "\n".join(lines + ["  </world>", "</sdf>", ""])


def main():
    beside = pathlib.Path(__file__).resolve().with_name("warehouse.sdf")
    output = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else beside
    output.write_text(sdf(warehouse()), encoding="utf-8")


if __name__ == "__main__":
    main()
