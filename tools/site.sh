#!/usr/bin/env bash
# Builds the site of docs/ with mkdocs, its material theme (mkdocs.yml) and KaTeX into build/site, and checks all
# equations, all links of its pages and its search. Installs what is missing (Debian: mkdocs, mkdocs-material, katex,
# nodejs). No network otherwise.
#   tools/site.sh [--serve]     --serve: shows the site at http://127.0.0.1:8000 and builds a page again when it changes
set -euo pipefail
# shellcheck source=tools/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

themes=$(mkdocs build --help 2>/dev/null || true) # it lists them
# shellcheck disable=SC2086,SC2154 # a list, from setup.sh
case $themes in
    *material*) node tools/site/equations.js --style >/dev/null 2>&1 || setup_install $packages_of_site ;;
    *) setup_install $packages_of_site ;;
esac
[ "${1:-}" != --serve ] || exec mkdocs serve
python3 tools/site/equations.py
setup_quietly "building build/site" build/log/site.log mkdocs build --clean
python3 tools/site/links.py build/site
node tools/site/ask.js build/site
