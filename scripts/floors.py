#!/usr/bin/env python3
"""Checks that modules import only downward and in no circle.

    scripts/floors.py

Each crate under crates/ is read for its `crate::` and `super::` paths, tests excepted. A file may not
import, by whatever way round, a file that imports it. In the crates whose floors are named below, a file may
import only from its own floor and those below.
"""

import re
import sys
from pathlib import Path

# From the top down. A file belongs to the floor that its path begins with.
FLOORS = {
    "dynamics": [
        ["lib"],
        ["batch"],
        ["impact_surface", "land"],
        ["methods"],
        ["landing"],
        ["equations"],
        ["lander"],
        ["laws"],
        ["design"],
        ["integrator"],
        ["numbers", "model_version"],
    ],
    "sweep": [
        ["lib"],
        ["threads"],
        ["output"],
        ["maps"],
        ["journal"],
        ["summary"],
        ["sensitivity"],
        ["examples"],
    ],
    "input": [
        ["lib"],
        ["sweeps"],
        ["points"],
        ["readers"],
        ["documents"],
    ],
    "figures": [
        ["lib"],
        ["picture"],
        ["charts", "maps"],
        ["page"],
        ["tables"],
        ["words", "png"],
    ],
    "explorer": [
        ["lib"],
        ["export", "server"],
        ["page"],
        ["interface"],
        ["named"],
    ],
    "touchdown": [
        ["main"],
        ["lib"],
        ["explore"],
        ["land", "ask", "surface", "sweep", "merge"],
        ["plot"],
        ["import_deck", "new"],
        ["options"],
        ["terminal"],
    ],
}

USE = re.compile(r"^\s*(?:pub(?:\([^)]*\))? )?use ([^;]*);", re.M)
# Paths written out in code; documentation may name what is above.
PATH = re.compile(r"^(?!\s*//).*?\b((?:crate|super)::\w+(?:::\w+)*)", re.M)


def expand(path):
    """The single paths of a use tree."""
    path = " ".join(path.split())
    start = path.find("{")
    if start < 0:
        return [path.split(" as ")[0].strip()]
    depth, items, item = 0, [], ""
    for char in path[start + 1 : path.rindex("}")]:
        depth += (char == "{") - (char == "}")
        if char == "," and depth == 0:
            items.append(item)
            item = ""
        else:
            item += char
    items.append(item)
    return [p for i in items if i.strip() for p in expand(path[:start].strip() + i.strip())]


def read(crate):
    """The modules of a crate with their sources, tests cut off."""
    root = crate / "src"
    modules = {}
    for file in sorted(root.rglob("*.rs")):
        name = "::".join(file.relative_to(root).with_suffix("").parts)
        if not name.endswith("tests"):
            modules[name] = file.read_text().split("#[cfg(test)]")[0]
    return modules


def reexports(modules):
    """What the root of the crate shows under a shorter name."""
    short = {}
    for root in ("lib", "main"):
        for tree in USE.findall(modules.get(root, "")):
            for path in expand(tree):
                path = path.removeprefix("crate::")
                if path.replace("::", "") and path in modules:
                    short[path.rsplit("::")[-1]] = path
    return short


def imports(modules):
    """Which modules each imports."""
    short = reexports(modules)
    edges = {}
    for name, source in modules.items():
        found = set()
        trees = USE.findall(source) + PATH.findall(source)
        for tree in trees:
            for path in expand(tree):
                parts = path.split("::")
                if parts[0] == "crate":
                    parts = parts[1:]
                    if parts and parts[0] in short:
                        parts = short[parts[0]].split("::") + parts[1:]
                elif parts[0] in ("super", "self"):
                    here = name.split("::")
                    while parts and parts[0] in ("super", "self"):
                        here = here[:-1] if parts[0] == "super" else here
                        parts = parts[1:]
                    parts = here + parts
                else:
                    continue
                while parts and "::".join(parts) not in modules:
                    parts = parts[:-1]
                # What a module shows of its own children it does not import.
                target = "::".join(parts)
                if target and target != name and not target.startswith(name + "::"):
                    found.add(target)
        edges[name] = found
    return edges


def circles(edges):
    """Groups of modules that import each other, by Tarjan's algorithm."""
    index, low, stack, groups = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for target in sorted(edges[node]):
            if target not in index:
                visit(target)
                low[node] = min(low[node], low[target])
            elif target in stack:
                low[node] = min(low[node], index[target])
        if low[node] == index[node]:
            group = stack[stack.index(node) :]
            del stack[stack.index(node) :]
            if len(group) > 1:
                groups.append(group)

    for node in sorted(edges):
        if node not in index:
            visit(node)
    return groups


def floor_of(name, floors):
    for level, names in enumerate(floors):
        if any(name == floor or name.startswith(floor + "::") for floor in names):
            return level
    return None


def main():
    sys.setrecursionlimit(10_000)
    crates = Path(__file__).resolve().parent.parent / "crates"
    faults = []
    for crate in sorted(path for path in crates.iterdir() if (path / "src").is_dir()):
        edges = imports(read(crate))
        for group in circles(edges):
            faults.append(f"{crate.name}: circle of imports: {', '.join(sorted(group))}")
            for name in sorted(group):
                targets = ", ".join(sorted(edges[name] & set(group)))
                faults.append(f"    {name} imports {targets}")
        floors = FLOORS.get(crate.name)
        for name, targets in sorted(edges.items() if floors else []):
            level = floor_of(name, floors)
            if level is None:
                faults.append(f"{crate.name}: {name} belongs to no floor")
                continue
            for target in sorted(targets):
                if (floor_of(target, floors) or 0) < level:
                    faults.append(f"{crate.name}: {name} imports {target}, which is above it")
    print("\n".join(faults) or "modules import only downward")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
