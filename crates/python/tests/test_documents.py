"""Every example of the documents works, those of a page in one session."""

from __future__ import annotations

import re

import matplotlib
import pytest


@pytest.mark.parametrize(("page", "least"), [("README.md", 1), ("docs/python.md", 9)])
def test_examples(page, least, root, tmp_path, monkeypatch):
    matplotlib.use("agg")
    (tmp_path / "sweeps").symlink_to(root / "sweeps")
    monkeypatch.chdir(tmp_path)
    text = (root / page).read_text(encoding="utf-8")
    blocks = list(re.finditer(r"```python\n(.*?)```", text, re.DOTALL))
    assert len(blocks) >= least
    session: dict[str, object] = {}
    for block in blocks:
        # Blank lines before it keep the numbers of lines in complaints.
        lines = text[: block.start(1)].count("\n")
        exec(compile("\n" * lines + block[1], page, "exec"), session)
