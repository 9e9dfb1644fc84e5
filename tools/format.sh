#!/usr/bin/env bash
# Formats the C files in place (.clang-format, clang-format 14); with --check reports the files that are not formatted.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
how=(-i)
[ "${1:-}" != --check ] || how=(--dry-run -Werror)
git ls-files -z '*.c' '*.h' | xargs -0 "$(command -v clang-format-14 || echo clang-format)" "${how[@]}"
