"""The table of peers: as text, CSV and Markdown."""

import csv
import dataclasses
import datetime
import platform
from pathlib import Path


@dataclasses.dataclass
class Row:
    """An integrator at a tolerance; field names are the columns of the CSV."""

    integrator: str
    tolerance: float | None
    median_us_per_landing: float
    mean_us_per_landing: float
    mean_evaluations: float
    median_position_error_at_1s_ft: float
    p90_position_error_at_1s_ft: float
    median_pitch_error_at_1s_deg: float
    p90_pitch_error_at_1s_deg: float
    other_outcomes: int
    landings: int


HEADING = [
    "integrator",
    "tolerance",
    "µs per landing, median / mean",
    "evaluations, mean",
    "position error at 1 s, ft, median / 90 %",
    "pitch error at 1 s, deg, median / 90 %",
    "other outcomes",
]


def power(number, digits):
    """A number as 1.2e-3, without zeros that say nothing."""
    return f"{number:.{digits}e}".replace("e-0", "e-").replace("e+00", "")


def cells(row):
    """What a row says, for people."""
    pair = "{} / {}".format
    return [
        row.integrator,
        "its own" if row.tolerance is None else power(row.tolerance, 0),
        f"{row.median_us_per_landing:,.0f} / {row.mean_us_per_landing:,.0f}",
        f"{row.mean_evaluations:,.0f}",
        pair(
            power(row.median_position_error_at_1s_ft, 1), power(row.p90_position_error_at_1s_ft, 1)
        ),
        pair(power(row.median_pitch_error_at_1s_deg, 1), power(row.p90_pitch_error_at_1s_deg, 1)),
        f"{row.other_outcomes} of {row.landings}",
    ]


def text(rows):
    lines = [HEADING] + [cells(row) for row in rows]
    widths = [max(map(len, column)) for column in zip(*lines)]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip() for line in lines
    )


def markdown(rows):
    lines = [HEADING, ["---"] * len(HEADING)] + [cells(row) for row in rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def processor():
    """The processor's name."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    wide = " with AVX-512" if any("avx512f" in line for line in lines) else ""
    return (names[0] if names else platform.machine()) + wide


def write(rows, versions, folder):
    """Writes peers.csv and peers.md to a folder; returns the table."""
    folder.mkdir(parents=True, exist_ok=True)
    today = datetime.date.today().isoformat()
    measured = f"{today}, one core of an {processor()}"
    with open(folder / "peers.csv", "w", newline="") as file:
        fields = [field.name for field in dataclasses.fields(Row)]
        table = csv.writer(file, lineterminator="\n")
        table.writerow(fields + ["date", "processor"])
        for row in rows:
            numbers = (getattr(row, field) for field in fields)
            plain = (f"{n:.6g}" if isinstance(n, float) else n for n in numbers)
            table.writerow([*plain, today, processor()])
    (folder / "peers.md").write_text(
        f"# The same landings by other integrators\n\n"
        f"Written by `crates/lab/peers/run.sh` on {measured}.\n{versions}.\n\n"
        f"{NOTES}\n\n{markdown(rows)}\n"
    )
    return f"{measured}\n{versions}\n\n{text(rows)}"


NOTES = """\
Forty level landings of Table 4-1's vehicle around its toppling boundary (slope 15 deg, V_V 14 ft/s), each
run to its outcome; errors a second after first contact against `touchdown` at a tolerance of 1e-11.

The peers integrate 25 variables with a compiled right-hand side of the same equations. They are plain
adaptive methods: every evaluation chooses the active piece of each law from the state, which takes
longer than where they are known; what the crushable elements keep changes after accepted steps, and the
verdict falls there. `touchdown` locates both in time. Evaluations include the look after each
accepted step, and for `touchdown` those of signals alone. For SciPy the time includes the call from
Python at every evaluation, as its users have it. Times of compiled integrators are the least of five; the
last column counts outcomes (stable, unstable, bottomed) unlike the converged ones."""
