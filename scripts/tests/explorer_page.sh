#!/usr/bin/env bash
# The explorer's page in a real browser: types, vendored libraries, and what a user does with it.
#
#     scripts/tests/explorer_page.sh             installs what is missing, and tests
#     scripts/tests/explorer_page.sh --install   only installs: Debian's node and chromium, and packages of npm
#
# For tests the command line must have been built for release.
set -euo pipefail
cd "$(dirname "$0")/../../crates/explorer/tests/browser"

missing=()
command -v npm >/dev/null || missing+=(nodejs npm)
command -v chromium >/dev/null || missing+=(chromium)
if [ ${#missing[@]} -gt 0 ]; then
    export DEBIAN_FRONTEND=noninteractive
    apt-get update -qq
    apt-get install -qq -y --no-install-recommends "${missing[@]}" fonts-dejavu-core >/dev/null
fi
[ node_modules/.package-lock.json -nt package-lock.json ] || npm ci --silent --no-audit --no-fund
[ "${1:-}" != --install ] || exit 0
npm run --silent types
node vendor.mjs --check
npm test --silent
