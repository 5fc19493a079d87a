#!/usr/bin/env python3
"""Checks that what the documents name is there.

    scripts/links.py

In every page (*.md) that git knows: relative links lead to a file, anchors to a heading of its page, and paths in
backticks that begin with a folder of the repository exist.
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("crates/", "docs/", "results/", "scripts/", "sweeps/")
LINK = re.compile(r"\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```.*?^```", re.M | re.S)
HEADING = re.compile(r"^#+ +(.*?) *$", re.M)
# Of a path, what the name of a file cannot have.
PATTERN = re.compile(r"[*<>{}…]|NAME")


def anchors(text):
    """The anchors of a page, as GitHub names them."""
    found = set()
    for heading in HEADING.findall(FENCE.sub("", text)):
        words = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()
        slug = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        count = 0
        while (anchor := f"{slug}-{count}" if count else slug) in found:
            count += 1
        found.add(anchor)
    return found


def main():
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "*.md"], cwd=ROOT, capture_output=True, text=True, check=True)
    pages = {ROOT / name: (ROOT / name).read_text(encoding="utf-8") for name in listed.stdout.splitlines()}
    of_page = {page: anchors(text) for page, text in pages.items()}
    faults = []
    links = 0
    for page, text in pages.items():
        prose = FENCE.sub("", text)
        for target in LINK.findall(re.sub(r"`[^`\n]*`", "", prose)):
            if re.match(r"[a-z]+:", target):
                continue
            links += 1
            name, _, anchor = target.partition("#")
            there = (page.parent / name).resolve() if name else page
            if not there.exists():
                faults.append(f"{page.relative_to(ROOT)}: {target}: no such file")
            elif anchor and there in of_page and anchor not in of_page[there]:
                faults.append(f"{page.relative_to(ROOT)}: {target}: no such heading")
        for quoted in re.findall(r"`([^`\n]+)`", prose):
            name = quoted.split()[0] if quoted.strip() else ""
            if name.startswith(FOLDERS) and not PATTERN.search(name) and not (ROOT / name).exists():
                faults.append(f"{page.relative_to(ROOT)}: `{name}`: no such file")
    print("\n".join(faults) or f"{links} links of {len(pages)} pages lead somewhere")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
