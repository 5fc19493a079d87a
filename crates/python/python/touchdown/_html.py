"""Small tables and pictures for notebooks."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

Row = tuple[str, object]


def table(title: str, rows: Iterable[Row]) -> str:
    """Names and values under a title."""
    cells = (f"<tr><th style='text-align:left'>{escape(name)}</th><td>{escape(shown(value))}</td></tr>" for name, value in rows)
    return f"<table><caption>{escape(title)}</caption>{''.join(cells)}</table>"


def shown(value: object) -> str:
    """A value with as many digits as a reader wants."""
    match value:
        case None:
            return ""
        case float():
            return f"{value:.6g}"
        case tuple():
            return ", ".join(shown(item) or "never" for item in value)
        case _:
            return str(value)


#: Of bands, by how their landings end.
OUTCOME_COLOURS = {"stable": "#4c9f70", "unstable": "#d1495b", "bottomed": "#edae49", "undecided": "#9aa5b1", "failure": "#444444"}


def bands_picture(bands: Iterable[tuple[float, float, str, str]], unit: str) -> str:
    """Bands of horizontal velocities side by side: their ends in a unit, how landings end in them, and the kind of it."""
    bands = list(bands)
    if not bands:
        return ""
    low, high = bands[0][0], bands[-1][1]
    parts = (
        f"<div title='{start:.4g} to {end:.4g} {unit}: {escape(kind)}' "
        f"style='width:{100 * (end - start) / (high - low):.3f}%;background:{OUTCOME_COLOURS[outcome]};color:white;"
        f"overflow:hidden;white-space:nowrap;padding:2px 0;text-align:center'>{escape(outcome)}</div>"
        for start, end, outcome, kind in bands
    )
    below = [] if bands[0][2] == "stable" else [f"at or below {low:g}"]
    ends = ", ".join([*below, *(f"{end:.4f}" for _, end, _, _ in bands[:-1])]) or "none"
    return (
        f"<div style='max-width:40em'><div style='display:flex'>{''.join(parts)}</div>"
        f"<div style='display:flex;justify-content:space-between'><span>{low:g}</span>"
        f"<span>V_H, {unit}; transitions: {ends}</span><span>{high:g}</span></div></div>"
    )
