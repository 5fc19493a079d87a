#!/usr/bin/env bash
# The explorer's page in a real browser: types, vendored libraries, and what a user does with it.
#
#     scripts/tests/explorer_page.sh
#
# The command line must have been built for release. Installs Debian's node and chromium where they are missing.
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
npm ci --silent --no-audit --no-fund
npm run --silent types
node vendor.mjs --check
npm test --silent
