"""Columns on their way to the engine and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pandas as pd

from touchdown.errors import InputError

_TABLES = "a DataFrame, or a mapping of names to columns of equal length"


def columns_of(table: Any) -> dict[str, Any]:
    """The columns of a table: arrays of numbers, lists of texts."""
    if isinstance(table, pd.DataFrame) or isinstance(table, Mapping):
        named = {name: table[name] for name in table}
    elif hasattr(table, "get_columns"):
        named = {column.name: column.to_list() if column.null_count() else column.to_numpy() for column in table.get_columns()}
    else:
        raise InputError(f"the table is a {type(table).__name__}: expected {_TABLES}", allowed=_TABLES)
    columns = {}
    for name, values in named.items():
        if not isinstance(name, str):
            raise InputError(f"column {name!r}: expected a text as name", repr(name))
        columns[name] = _column(name, values)
    lengths = {name: len(column) for name, column in columns.items()}
    for name, length in lengths.items():
        first = next(iter(lengths))
        if length != lengths[first]:
            allowed = f"as many as in {first}, {lengths[first]}"
            raise InputError(f"column {name} has {length} rows: expected {allowed}", name, str(length), allowed)
    return columns


def _column(name: str, values: Any) -> Any:
    """A column as an array of numbers, or as a list of texts where it has words or gaps."""
    array = _array(values)
    if array.ndim != 1:
        allowed = "one dimension"
        raise InputError(f"column {name} has {array.ndim} dimensions: expected {allowed}", name, str(array.shape), allowed)
    if array.dtype.kind in "iuf":
        return np.ascontiguousarray(array, dtype=np.float64)
    if array.dtype.kind in "OUT":
        return [_cell(name, row, value) for row, value in enumerate(array.tolist())]
    allowed = "numbers or words"
    raise InputError(f"column {name} is of type {array.dtype}: expected {allowed}", name, str(array.dtype), allowed)


def _array(values: Any) -> Any:
    """A column as an array, of objects where it has gaps that are no numbers."""
    dtype: Any = getattr(values, "dtype", object)
    if pd.api.types.is_extension_array_dtype(dtype):
        values = pd.Series(values)
        return values.to_numpy(dtype=object, na_value=None) if values.hasnans else values.to_numpy()
    try:
        return np.asarray(values)
    except ValueError:
        return np.fromiter(values, dtype=object)


def _cell(name: str, row: int, value: Any) -> str | None:
    if value is None or value is pd.NA:
        return None
    if isinstance(value, str):
        return value
    if isinstance(value, (int, float, np.number)) and not isinstance(value, bool):
        return repr(float(value))
    allowed = "a number or a word"
    raise InputError(f"row {row}: {name} = {value!r}: expected {allowed}", name, repr(value), allowed)


def index_of(table: Any) -> pd.Index[Any] | None:
    """The index that a table has, if it has one."""
    return table.index if isinstance(table, pd.DataFrame) else None


def series(values: bytearray, kind: str, words: list[str] | None) -> Any:
    """A column of the engine as pandas takes it, without a copy."""
    if words is None:
        return np.frombuffer(values, dtype=kind)
    codes: np.ndarray[tuple[int], np.dtype[np.int32]] = np.frombuffer(values, dtype=np.int32)
    # In an order that does not depend on threads.
    return pd.Categorical.from_codes(codes, pd.Index(words, dtype=object)).reorder_categories(sorted(words))
