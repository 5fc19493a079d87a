#!/usr/bin/env python3
"""Errors of maps and of uniform grids over the surface of Figure 4-20, for docs/notes/maps.md.

    crates/lab/scripts/map_errors.py truth DIR            # writes DIR/inside.toml and DIR/rim.toml
    touchdown sweep DIR/inside.toml DIR/rim.toml --out DIR
    for b in 3000 6000 11800 24000 48000; do
      sed "s/^budget_landings.*/error_fps = 0.02\\nbudget_landings = $b/; s#= \\"vehicles#= \\"$PWD/sweeps/vehicles#" \\
        sweeps/map-4-20.toml > DIR/map-$b.toml
    done
    touchdown sweep DIR/map-*.toml --out DIR
    crates/lab/scripts/map_errors.py table DIR DIR/map-3000 DIR/map-6000 ...
    crates/lab/scripts/map_errors.py picture DIR crates/lab/results/map-errors DIR/map-3000 ...    # crates/lab/results/map-errors.csv and .svg

The truth is 1600 points at random, and points 0.5 deg apart in those cells of results/surface-4-20.csv in which
transitions end. Uniform grids are parts of that table, interpolated bilinearly; beside gaps they have the value of
the nearest corner.
"""

import csv
import math
import random
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
AXES = ("cross_slope_deg", "roll_deg")
SPEED = "first_transition_fps"
# What an edge may be off, deg.
EDGE = 0.25


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def place(row):
    return tuple(float(row[axis]) for axis in AXES)


def speed(row):
    return float(row[SPEED]) if row[SPEED] else None


def surface():
    table = {place(row): row for row in rows(ROOT / "results/surface-4-20.csv")}
    return {at: row for at, row in table.items() if at[0] > 0}


def write_truth(folder):
    random.seed(1)
    spots = [(round(random.uniform(80, 180), 3), round(random.uniform(-60, 60), 3)) for _ in range(1600)]
    known = surface()
    rim = set()
    for i in range(40):
        for j in range(48):
            x, y = 80 + 2.5 * i, -60 + 2.5 * j
            corners = {bool(known[x + a, y + b][SPEED]) for a in (0, 2.5) for b in (0, 2.5)}
            if len(corners) == 2:
                rim |= {(x + 0.5 * a, y + 0.5 * b) for a in range(6) for b in range(6)}
    text = (ROOT / "sweeps/surface-4-20.toml").read_text()
    head, rest = text.split("[axes]")
    search = rest.split("[search]")[1]
    head = head.replace('"vehicles/', f'"{ROOT}/sweeps/vehicles/')
    for name, points in (("inside", spots), ("rim", sorted(rim))):
        axes = [
            f'{axis} = {{ values = {[point[index] for point in points]}, zip = "points" }}'
            for index, axis in enumerate(AXES)
        ]
        lines = "\n".join(axes)
        Path(folder, f"{name}.toml").write_text(f"{head}[axes]\n{lines}\n\n[search]{search}")


class Map:
    """Triangles and ends of a map."""

    def __init__(self, stem):
        self.triangles = defaultdict(list)
        corners = [(*place(row), speed(row)) for row in rows(f"{stem}-surface.csv")]
        for index in range(0, len(corners), 3):
            triangle = corners[index : index + 3]
            spans = [[math.floor(c[axis]) for c in triangle] for axis in (0, 1)]
            for i in range(min(spans[0]), max(spans[0]) + 1):
                for j in range(min(spans[1]), max(spans[1]) + 1):
                    self.triangles[i, j].append(triangle)
        self.lines = defaultdict(list)
        last = None
        for row in rows(f"{stem}-edges.csv"):
            here = (row["edge"], place(row))
            if last and last[0] == here[0]:
                self.lines[row["edge_kind"]].append((last[1], here[1]))
            last = here
        points = rows(f"{stem}.csv")
        self.points = len(points)
        self.landings = sum(int(row["landings"]) for row in points)

    def at(self, x, y):
        for a, b, c in self.triangles.get((math.floor(x), math.floor(y)), []):
            area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            if area == 0:
                continue
            u = ((b[0] - x) * (c[1] - y) - (b[1] - y) * (c[0] - x)) / area
            v = ((c[0] - x) * (a[1] - y) - (c[1] - y) * (a[0] - x)) / area
            if min(u, v, 1 - u - v) >= -1e-9:
                return u * a[2] + v * b[2] + (1 - u - v) * c[2]
        return None

    def off(self, x, y, kinds):
        """Distance from the nearest edge of some kinds."""
        least = math.inf
        for a, b in (line for kind in kinds for line in self.lines[kind]):
            dx, dy = b[0] - a[0], b[1] - a[1]
            square = dx * dx + dy * dy
            part = ((x - a[0]) * dx + (y - a[1]) * dy) / square if square else 0
            part = min(max(part, 0), 1)
            least = min(least, math.hypot(x - a[0] - part * dx, y - a[1] - part * dy))
        return least


class Uniform:
    """A uniform grid."""

    def __init__(self, step):
        self.step = step
        whole = surface()
        self.known = {at: row for at, row in whole.items() if (at[0] - 80) % step == 0 and (at[1] + 60) % step == 0}
        self.points = len(self.known)
        self.landings = sum(int(row["landings"]) for row in self.known.values())

    def at(self, x, y):
        step = self.step
        i = min((x - 80) // step, 100 / step - 1)
        j = min((y + 60) // step, 120 / step - 1)
        corners = [speed(self.known[80 + (i + a) * step, -60 + (j + b) * step]) for a in (0, 1) for b in (0, 1)]
        u, w = (x - 80) / step - i, (y + 60) / step - j
        if None in corners:
            return corners[2 * (u > 0.5) + (w > 0.5)]
        a, b, c, d = corners
        return (a * (1 - w) + b * w) * (1 - u) + (c * (1 - w) + d * w) * u

    def off(self, _x, _y, _kinds):
        return math.inf


def measured(known, truth):
    """Errors away from edges, and how many points lie on the wrong side of an end, and by how far too far."""
    errors, wrong, far = [], 0, 0
    for x, y, expected in truth:
        found = known.at(x, y)
        if (found is None) != (expected is None):
            wrong += 1
            far += known.off(x, y, ["end"]) > EDGE
        elif found is not None and known.off(x, y, ["end", "jump"]) > EDGE:
            errors.append(abs(found - expected))
    errors.sort()
    return errors, wrong, far


COLUMNS = (
    "kind", "points", "landings", "median_error_fps", "error_90_fps", "error_95_fps", "below_0.02_fps",
    "rim_median_error_fps", "rim_wrong_side", "rim_wrong_by_more_than_0.25_deg", "rim_points",
)  # fmt: skip


def accounts(folder, stems):
    """A row of COLUMNS for every grid and map."""
    truth = {
        name: [(*place(row), speed(row)) for row in rows(Path(folder, f"{name}.csv"))] for name in ("inside", "rim")
    }
    grids = [(f"grid of {step} deg", Uniform(step)) for step in (10, 5, 2.5)]
    for name, known in grids + [("map", Map(stem)) for stem in stems]:
        errors, _, _ = measured(known, truth["inside"])
        rim, wrong, far = measured(known, truth["rim"])
        part = lambda list_, share: list_[int(share * (len(list_) - 1))]
        below = sum(error < 0.02 for error in errors) / len(errors)
        shares = [part(errors, share) for share in (0.5, 0.9, 0.95)]
        yield (name, known.points, known.landings, *shares, below, part(rim, 0.5), wrong, far, len(truth["rim"]))


def print_table(folder, stems):
    print("| | points | landings | median error, ft/s | 90 % | 95 % | below 0.02 | at the rim: median | wrong side | by more than 0.25 deg |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for name, points, landings, median, most, all_, below, rim, wrong, far, count in accounts(folder, stems):
        print(
            f"| {name} | {points} | {landings} | {median:.3f} | {most:.3f} | {all_:.3f} | {100 * below:.0f} % | "
            f"{rim:.3f} | {wrong} of {count} | {far} |"
        )


# What a picture shows: title of the ordinate, its ends, and the lines in it: words, dashes and the number of a row.
PANELS = (
    ("error of V_H between edges, ft/s", (0.005, 1.0), (
        ("median", "", lambda row: row["median_error_fps"]),
        ("90 %", "6 4", lambda row: row["error_90_fps"]),
    )),
    ("points of the rim on the wrong side by more than 0.25 deg, %", (0.2, 50.0), (
        ("", "", lambda row: 100 * row["rim_wrong_by_more_than_0.25_deg"] / row["rim_points"]),
    )),
)  # fmt: skip
LANDINGS = (2500.0, 60000.0)
COLOURS = {"uniform grid": "#b2182b", "map": "#2166ac"}


def write_picture(folder, stem, stems):
    found = [dict(zip(COLUMNS, row)) for row in accounts(folder, stems)]
    with open(f"{stem}.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        rounded = lambda value: round(value, 4) if isinstance(value, float) else value
        writer.writerows({name: rounded(value) for name, value in row.items()} for row in found)
    lines = [
        '<svg xmlns="http://www.w3.org/2000/svg" width="900" height="420" font-family="sans-serif" font-size="12">',
        '<rect width="900" height="420" fill="white"/>',
        '<text x="450" y="22" text-anchor="middle" font-size="15">The surface of Figure 4-20 by uniform grids and by maps'
        " that refine themselves</text>",
    ]
    for index, (title, ends, curves) in enumerate(PANELS):
        left, right, top, bottom = 70 + 450 * index, 430 + 450 * index, 60, 360

        def part(value, low_high):
            low, high = low_high
            return math.log(value / low) / math.log(high / low)

        def at(landings, value):
            return left + part(landings, LANDINGS) * (right - left), bottom - part(value, ends) * (bottom - top)

        lines.append(f'<rect x="{left}" y="{top}" width="{right - left}" height="{bottom - top}" fill="none" stroke="#333"/>')
        for landings in (3000, 6000, 12000, 24000, 48000):
            x, _ = at(landings, ends[0])
            lines.append(f'<path d="M{x:.1f} {top}V{bottom}" stroke="#ddd"/>')
            lines.append(f'<text x="{x:.1f}" y="{bottom + 18}" text-anchor="middle">{landings}</text>')
        for value in (0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50):
            if ends[0] <= value <= ends[1]:
                _, y = at(LANDINGS[0], value)
                lines.append(f'<path d="M{left} {y:.1f}H{right}" stroke="#ddd"/>')
                lines.append(f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{value:g}</text>')
        middle = 0.5 * (left + right)
        lines.append(f'<text x="{middle}" y="{bottom + 40}" text-anchor="middle">landings</text>')
        lines.append(f'<text x="{middle}" y="{top - 10}" text-anchor="middle">{title}</text>')
        for kind, colour in COLOURS.items():
            of_kind = [row for row in found if (row["kind"] == "map") == (kind == "map")]
            for words, dashes, number in curves:
                places = [at(row["landings"], number(row)) for row in of_kind]
                path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
                lines.append(f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="2" stroke-dasharray="{dashes}"/>')
                lines += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{colour}"/>' for x, y in places]
                x, y = places[0]
                name = f"{kind}, {words}" if words else kind
                lines.append(f'<text x="{x + 8:.1f}" y="{y - 8:.1f}" fill="{colour}">{name}</text>')
    Path(f"{stem}.svg").write_text("\n".join([*lines, "</svg>", ""]))


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["truth", folder]:
            write_truth(folder)
        case ["table", folder, *stems]:
            print_table(folder, stems)
        case ["picture", folder, stem, *stems]:
            write_picture(folder, stem, stems)
        case _:
            sys.exit(__doc__)
