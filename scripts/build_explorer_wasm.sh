#!/usr/bin/env bash
# Builds the WebAssembly module of exported pages from the same source as the program, the same bytes on every machine with the
# same compiler.
#
#     scripts/build_explorer_wasm.sh           puts it into the page
#     scripts/build_explorer_wasm.sh --check   fails unless it is there already
#
# The module depends on the compiler, which the file beside it names. --check with another compiler cannot compare bytes and
# says so; that answers are the same is then what scripts/tests/explorer_wasm.sh proves.
set -euo pipefail
cd "$(dirname "$0")/.."

target=wasm32-unknown-unknown
module=crates/explorer/page/wasm/explorer.wasm.gz
compiler=crates/explorer/page/wasm/compiler.txt

if ! rustc --print target-libdir --target "$target" 2>/dev/null | xargs test -d; then
    rustup target add "$target"
fi
# No paths of this machine, and no random numbers, which nothing in the module asks for.
home=${CARGO_HOME:-$HOME/.cargo}
flags=(--remap-path-prefix="$PWD=." --remap-path-prefix="$home=cargo" --cfg 'getrandom_backend="unsupported"')
CARGO_ENCODED_RUSTFLAGS=$(printf '%s\x1f' "${flags[@]}" | sed 's/\x1f$//') \
    cargo build --locked --quiet --profile wasm -p touchdown-explorer-wasm --target "$target"
built=${CARGO_TARGET_DIR:-target}/$target/wasm/touchdown_explorer_wasm.wasm

version=$(rustc --version)
if [ "${1:-}" = --check ]; then
    if [ "$version" != "$(cat "$compiler")" ]; then
        echo "the module in the page is of another compiler: $(cat "$compiler"), and this is $version"
    elif ! gzip -dc "$module" | cmp - "$built"; then
        echo "the module in the page is not of this source: run scripts/build_explorer_wasm.sh" >&2
        exit 1
    fi
else
    mkdir -p "$(dirname "$module")"
    gzip -9 -n -c "$built" >"$module"
    echo "$version" >"$compiler"
    echo "$module: $(stat -c %s "$module") bytes, $(stat -c %s "$built") unpacked"
fi
