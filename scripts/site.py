#!/usr/bin/env python3
"""The documents as a site with search.

    scripts/site.py FOLDER

Puts the pages of docs/README.md, in its order, a page for each command of `touchdown` (built for release) and what they
link to into FOLDER. A link that leads nowhere is an error. Needs the packages of scripts/site-requirements.txt.
"""

import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "target/release/touchdown"
LINK = re.compile(r"\]\(([^)\s#]+)(?:#[^)\s]*)?\)|(?:src|href)=\"([^\"#]+)\"")


def reading_order():
    """The pages that docs/README.md lists, then those that they lie among."""
    listed = re.findall(r"^\| \[[^]]*\]\(([^)]*)\)", (ROOT / "docs/README.md").read_text(encoding="utf-8"), re.M)
    return [(ROOT / "docs" / name).resolve().relative_to(ROOT) for name in listed]


def stage(pages):
    """Copies all pages of the repository and the files that they link to; a link to a folder without a page becomes words."""
    for page in subprocess.run(["git", "ls-files", "*.md"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split():
        place = pages / page
        place.parent.mkdir(parents=True, exist_ok=True)
        # Words beside the language of an example are for the tests.
        text = re.sub(r"^```(\w+) .*$", r"```\1", (ROOT / page).read_text(encoding="utf-8"), flags=re.M)
        for target in filter(None, (name for pair in LINK.findall(text) for name in pair)):
            there = (ROOT / page).parent / target
            if there.is_dir() and not (there / "README.md").exists():
                text = re.sub(rf"\[([^]]*)\]\({re.escape(target)}\)", r"\1", text)
            elif there.is_dir():
                text = text.replace(f"]({target})", f"]({target.rstrip('/')}/README.md)")
            elif there.is_file() and there.suffix != ".md":
                copy = pages / there.resolve().relative_to(ROOT)
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(there, copy)
        place.write_text(text, encoding="utf-8")


def commands(pages):
    """A page for each command, with its help; returns their paths."""
    def told(*words):
        return subprocess.run([PROGRAM, *words, "--help"], capture_output=True, text=True, check=True).stdout

    names = re.findall(r"^  ([a-z-]+) {2,}", told().split("Commands:")[1].split("Options:")[0], re.M)
    (pages / "commands").mkdir()
    written = []
    for name in filter(lambda name: name != "help", names):
        path = Path("commands") / f"{name}.md"
        (pages / path).write_text(f"# touchdown {name}\n\n```text\n{told(name).rstrip()}\n```\n", encoding="utf-8")
        written.append(path)
    return written


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__.strip())
        return 2
    folder = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as scratch:
        pages = Path(scratch) / "pages"
        pages.mkdir()
        stage(pages)
        nav = [str(page) for page in reading_order()]
        nav.insert(nav.index("docs/reference.md"), {"Commands": [str(path) for path in commands(pages)]})
        settings = {
            "site_name": "touchdown",
            "docs_dir": str(pages),
            "theme": {"name": "readthedocs", "highlightjs": False},
            "plugins": ["search"],
            "markdown_extensions": ["tables", "fenced_code", "md_in_html", "pymdownx.superfences"],
            "validation": {"nav": {"omitted_files": "info"}, "links": {"not_found": "warn", "anchors": "warn"}},
            "nav": nav,
        }
        # GitHub's anchors, so that a link leads to its heading there and here.
        file = Path(scratch) / "mkdocs.yml"
        slugs = "{toc: {permalink: true, slugify: !!python/object/apply:pymdownx.slugs.slugify {kwds: {case: lower}}}}"
        text = json.dumps(settings).replace('"tables", ', f'{slugs}, "tables", ')
        file.write_text(text, encoding="utf-8")
        command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--config-file", file, "--site-dir", folder]
        return subprocess.run(command, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
