"""Columns on their way to the engine and back."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pandas as pd

from touchdown.errors import InputError

# Columns that are no numbers even where all that stands in them is.
OF_WORDS = ("case", "vehicle", "note")
_TABLES = "a DataFrame, or a mapping of names to columns of equal length or single values"


def columns_of(table: Any) -> dict[str, Any]:
    """The columns of a table: arrays of numbers, lists of texts."""
    if isinstance(table, pd.DataFrame) or isinstance(table, Mapping):
        if isinstance(table, pd.DataFrame) and not table.columns.is_unique:
            twice = str(table.columns[table.columns.duplicated()][0])
            raise InputError(f"column {twice} is there twice: expected once", twice, allowed="once")
        named = {name: table[name] for name in table}
    elif hasattr(table, "get_columns"):
        named = {column.name: column for column in table.get_columns()}
    else:
        raise InputError(f"the table is a {type(table).__name__}: expected {_TABLES}", allowed=_TABLES)
    if not named:
        raise InputError(f"the table has no columns: expected {_TABLES}", allowed=_TABLES)
    columns, single = {}, set()
    for name, values in named.items():
        if not isinstance(name, str):
            raise InputError(f"column {name!r}: expected a text as name", repr(name))
        array = _array(values)
        if array.ndim == 0:
            single.add(name)
            array = array.reshape(1)
        columns[name] = _column(name, array)
    rows = next((len(column) for name, column in columns.items() if name not in single), 1)
    for name in single:
        column = columns[name]
        columns[name] = column * rows if isinstance(column, list) else np.repeat(column, rows)
    lengths = {name: len(column) for name, column in columns.items()}
    for name, length in lengths.items():
        first = next(iter(lengths))
        if length != lengths[first]:
            allowed = f"as many as in {first}, {lengths[first]}"
            raise InputError(f"column {name} has {length} rows: expected {allowed}", name, str(length), allowed)
    return columns


def _column(name: str, array: Any) -> Any:
    """A column as an array of numbers, or as a list of texts where it has words or gaps."""
    if array.ndim != 1:
        allowed = "one dimension"
        raise InputError(f"column {name} has {array.ndim} dimensions: expected {allowed}", name, str(array.shape), allowed)
    is_of_words = name in OF_WORDS
    if array.dtype.kind in "iuf":
        numbers = np.ascontiguousarray(array, dtype=np.float64)
        gaps = np.isnan(numbers)
        if not gaps.any():
            return numbers
        if not is_of_words:
            raise _no_number(name, int(gaps.argmax()))
    if array.dtype.kind in "OUTf":
        cells = array.tolist()
        has_words = is_of_words or any(isinstance(cell, str) for cell in cells)
        return [_cell(name, row, cell, has_words) for row, cell in enumerate(cells)]
    allowed = "numbers or words"
    raise InputError(f"column {name} is of type {array.dtype}: expected {allowed}", name, str(array.dtype), allowed)


def _array(values: Any) -> Any:
    """A column as an array, of objects where it has gaps or words."""
    if isinstance(values, np.ma.MaskedArray):
        return np.array(values.tolist(), dtype=object) if values.mask.any() else values.data
    dtype: Any = getattr(values, "dtype", object)
    if pd.api.types.is_extension_array_dtype(dtype):
        values = pd.Series(values)
        return values.to_numpy(dtype=object, na_value=None) if values.hasnans else values.to_numpy()
    if callable(getattr(values, "null_count", None)):
        # A Series of polars.
        return np.array(values.to_list(), dtype=object) if values.null_count() else values.to_numpy()
    if isinstance(values, str) or not isinstance(values, Sequence):
        return np.asarray(values)
    values = [None if value is np.ma.masked else value for value in values]
    try:
        array = np.asarray(values)
    except ValueError:
        return np.fromiter(values, dtype=object)
    # NumPy writes NaN among words as one.
    return np.asarray(values, dtype=object) if array.dtype.kind == "U" else array


def _cell(name: str, row: int, value: Any, has_words: bool) -> str | None:
    """What a cell says as text. NaN is how pandas marks a gap among words."""
    if value is None or value is pd.NA or (has_words and value != value):
        return None
    if isinstance(value, str):
        return value
    if isinstance(value, (int, float, np.number)) and not isinstance(value, bool):
        if value != value:
            raise _no_number(name, row)
        return repr(float(value))
    allowed = "a number or a word"
    raise InputError(f"row {row}: {name} = {value!r}: expected {allowed}", name, repr(value), allowed)


def _no_number(name: str, row: int) -> InputError:
    allowed = "a finite number; a gap is None or pandas.NA, which astype(\"Float64\") makes of NaN"
    return InputError(f"row {row}: {name} = NaN: expected {allowed}", name, "NaN", allowed)


def index_of(table: Any) -> pd.Index[Any] | None:
    """The index that a table has, or all Series in it."""
    if isinstance(table, pd.DataFrame):
        return table.index
    if not isinstance(table, Mapping):
        return None
    indexes = {name: column.index for name, column in table.items() if isinstance(column, pd.Series)}
    first = next(iter(indexes), "")
    for name, index in indexes.items():
        if not index.equals(indexes[first]):
            allowed = f"that of column {first}; columns are taken by position"
            raise InputError(f"column {name} has another index: expected {allowed}", name, allowed=allowed)
    return indexes.get(first)


def series(values: bytearray, kind: str, words: list[str] | None) -> Any:
    """A column of the engine as pandas takes it, without a copy."""
    if words is None:
        return np.frombuffer(values, dtype=kind)
    codes: np.ndarray[tuple[int], np.dtype[np.int32]] = np.frombuffer(values, dtype=np.int32)
    # In an order that does not depend on threads.
    return pd.Categorical.from_codes(codes, pd.Index(words, dtype=object)).reorder_categories(sorted(words))
