#!/usr/bin/env bash
# Builds the module into the file that is named; with --check, only says whether it could. Which toolchain is there
# decides: rustup's with its target, or Debian's, which compiles the standard library from its source.
set -euo pipefail

sysroot=$(rustc --print sysroot 2>/dev/null || true)
debian=/usr/lib/rustlib/src/rust/library
if [ -d "$sysroot/lib/rustlib/wasm32-unknown-unknown/lib" ]; then
  command=(cargo)
  flags=()
  rust_flags=()
elif [ -x /usr/bin/rustc ] && [ -x /usr/bin/cargo ] && [ -d "$debian" ] && command -v wasm-ld >/dev/null; then
  # Debian's compiler is a stable one; only so does it compile its own library for another machine.
  export RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld
  command=(/usr/bin/cargo)
  flags=(-Zbuild-std=std)
  # Nobody reads what a panic says in a page, and its words would be a tenth of the module.
  rust_flags=(-Zunstable-options -Cpanic=immediate-abort)
else
  echo "To build the explorer's core, add the target wasm32-unknown-unknown with rustup, or on Debian install" \
    "rustc-web, cargo-web, rust-web-src and lld." >&2
  exit 3
fi
[ "$1" = --check ] && exit 0

export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS="-Ctarget-feature=+simd128 ${rust_flags[*]}"
"${command[@]}" build --locked --quiet --package kugelpendel-wasm --profile wasm \
  --target wasm32-unknown-unknown --target-dir target/wasm "${flags[@]}"
cp target/wasm/wasm32-unknown-unknown/wasm/kugelpendel_wasm.wasm "$1"
