#!/usr/bin/env python3
"""The Parquet tables of a sweep, opened with polars, hold what its CSV tables hold.

    scripts/tests/parquet.py FOLDER STEM
"""

import json
import sys
from pathlib import Path

import polars

folder, stem = Path(sys.argv[1]), sys.argv[2]
for name in [path.stem for path in folder.glob(f"{stem}*.parquet")]:
    table = polars.read_parquet(folder / f"{name}.parquet")
    text = polars.read_csv(folder / f"{name}.csv", schema=table.schema)
    assert table.equals(text), name
    metadata = polars.read_parquet_metadata(folder / f"{name}.parquet")
    units = json.loads(metadata["units"])
    assert list(units) == table.columns, units
    assert json.loads(metadata["input"])["vehicle"]["mass_slug"] > 0
    print(f"{name}.parquet: {table.height} rows, {len(units)} columns with units")
