#!/usr/bin/env bash
# Builds the site of docs/ with mkdocs and its material theme (mkdocs.yml) into build/site, and checks all links of its
# pages and its search. Installs both, if they are missing (Debian: mkdocs, mkdocs-material). No network otherwise.
#   tools/site.sh [--serve]     --serve: shows the site at http://127.0.0.1:8000 and builds a page again when it changes
set -euo pipefail
# shellcheck source=tools/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

themes=$(mkdocs build --help 2>/dev/null || true) # it lists them
# shellcheck disable=SC2086,SC2154 # a list, from setup.sh
case $themes in
    *material*) ;;
    *) setup_install $packages_of_site ;;
esac
[ "${1:-}" != --serve ] || exec mkdocs serve
setup_quietly "building build/site" build/log/site.log mkdocs build --clean
python3 tools/site/links.py build/site
if command -v node >/dev/null; then node tools/site/ask.js build/site; else echo "the search is not asked: no node"; fi
