#!/usr/bin/env bash
# Makes a release of the version in Cargo.toml: checks everything, puts crates, wheel, the explorer as a page and the documents
# as a site into target/release-VERSION, and tags the commit. It publishes nothing.
#
#     scripts/release.sh
set -euo pipefail
cd "$(dirname "$0")/.."
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)
out=$PWD/target/release-$version
refuse() {
    echo "release: $1" >&2
    exit 1
}
[ -z "$(git status --porcelain)" ] || refuse "the tree has changes that are not committed"
grep -q "^## $version\$" CHANGELOG.md || refuse "CHANGELOG.md has no section \"## $version\""
grep -q "^version: $version\$" CITATION.cff || refuse "CITATION.cff names another version"
! git rev-parse --quiet --verify "refs/tags/v$version" >/dev/null || refuse "v$version is tagged already"
.ci/run
# What libraries changed since the last release must fit the new version.
if last=$(git describe --tags --abbrev=0 --match 'v*' 2>/dev/null); then
    command -v cargo-semver-checks > /dev/null || cargo install --locked cargo-semver-checks
    cargo semver-checks --baseline-rev "$last" --package touchdown-dynamics --package touchdown-search \
        --package touchdown-input --package touchdown-sweep --package touchdown-figures --package touchdown-explorer
fi

mkdir -p "$out"
# Each after those that it uses.
crates=(touchdown-dynamics touchdown-search touchdown-input touchdown-sweep touchdown-figures touchdown-explorer touchdown)
cargo package "${crates[@]/#/--package=}"
for crate in "${crates[@]}"; do
    cp "target/package/$crate-$version.crate" "$out"
done
python3 -m venv "$out/python"
scripts/tests/python_package.sh "$out/python/bin/python" "$out"
"$out/python/bin/pip" install --quiet --requirement scripts/site-requirements.txt
"$out/python/bin/python" scripts/site.py "$out/site"
rm -r "$out/python"
target/release/touchdown explore sweeps/vehicles/*.toml results/surface-4-20.csv --export "$out/touchdown-explorer.html"
git tag --annotate "v$version" --message "touchdown $version"
ls -l "$out"
