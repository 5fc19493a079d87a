#!/usr/bin/env bash
# The Python package: built as one wheel, installed into a fresh environment, its tests, examples and types.
#
#     scripts/tests/python_package.sh PYTHON [FOLDER]
#
# PYTHON is the interpreter of the environment; the wheel stays in FOLDER, if one is named. The command line must have been
# built for release.
set -euo pipefail
python=$1
folder=${2:+$(realpath "$2")}
cd "$(dirname "$0")/../../crates/python"

wheels=$(mktemp -d)
trap 'rm -rf "$wheels"' EXIT
"$python" -m pip install --quiet --requirement ../../scripts/tests/requirements.txt
"$python" -m maturin build --release --quiet --out "$wheels"
wheel=("$wheels"/touchdown-*.whl)
# One of the same version counts as installed.
"$python" -m pip uninstall --quiet --yes touchdown
"$python" -m pip install --quiet "${wheel[0]}[plot]"
"$python" -m pytest --quiet --numprocesses 2 --nbmake --pyargs touchdown tests examples
"$python" -m mypy
[ -z "$folder" ] || cp "${wheel[0]}" "$folder"
