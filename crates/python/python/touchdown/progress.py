"""How far a long call is."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Protocol

from tqdm import TqdmWarning

from touchdown.errors import InputError

with warnings.catch_warnings():
    # Without ipywidgets there is no bar in a notebook, which is no fault of whoever imports this.
    warnings.simplefilter("ignore", TqdmWarning)
    from tqdm.auto import tqdm

_SHOWN_AFTER = 0.5


class Watch(Protocol):
    """Called with the points done, the points wanted and the landings so far."""

    def __call__(self, done: int, wanted: int, landings: int) -> object: ...


@contextmanager
def watching(progress: bool | Watch | None, unit: str) -> Iterator[Watch | None]:
    """Whoever watches a call: nobody, a bar in terminal or notebook, or the caller.

    A bar comes up after half a second. Without a choice there is one where the standard error is a terminal, and in notebooks.
    """
    if progress is False:
        yield None
    elif progress is None or progress is True:
        with tqdm(unit=unit, delay=_SHOWN_AFTER, disable=None if progress is None else False, leave=False) as bar:

            def watch(done: int, wanted: int, landings: int) -> None:
                bar.total = wanted
                bar.set_postfix(landings=landings, refresh=False)
                bar.update(done - bar.n)

            yield watch
    elif callable(progress):
        yield progress
    else:
        raise InputError.of_value("progress", progress, "True, False, None or a callable")
