"""Checks the links of a built site without a network: each file that a page links to or loads exists, each #anchor is
an id of its page, and nothing is loaded from another host, by style sheets neither. So do the entries of the search's index, in which each page
of text and each key of the scene stands. No item of a list and no row of a table stands as text in a paragraph, which
is what mkdocs makes of Markdown that only GitHub understands. Prints each broken one; leaves with 1 if there is one.
usage: python3 tools/site/links.py FOLDER
"""
import json
import os
import re
import sys
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit


# The colours of source code: most of what there is to read, and neither links nor places.
COLOURS = re.compile(r'<span class="[^"]*">|</span>')


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.ids, self.links, self.loads = set(), [], []
        self.paragraph, self.raw = None, []
        with open(path, encoding="utf-8") as f:
            self.feed(COLOURS.sub("", f.read()))

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.ids.update(attrs[a] for a in ("id", "name") if attrs.get(a))
        if tag == "p":
            self.paragraph = ""
        if tag == "a" and attrs.get("href"):
            self.links.append(attrs["href"])
        if tag == "link" and attrs.get("href") and attrs.get("rel") not in ("canonical", "prev", "next"):
            self.loads.append(attrs["href"])
        if tag in ("img", "script", "iframe", "source", "video") and attrs.get("src"):
            self.loads.append(attrs["src"])

    def handle_data(self, data):
        if self.paragraph is not None:
            self.paragraph += data

    def handle_endtag(self, tag):
        if tag == "p" and self.paragraph is not None:
            self.raw += re.findall(r"\n *((?:\* |\d\. [A-Z]|\|).{0,30})", self.paragraph)
            self.paragraph = None


folder = os.path.abspath(sys.argv[1])
pages = {}
for where, _, names in os.walk(folder):
    for name in names:
        if name.endswith(".html") and name != "404.html":  # its links are meant for a server's root
            pages[os.path.join(where, name)] = Page(os.path.join(where, name))
broken, count = [], 0
for path, page in pages.items():
    broken += [(path, line, "a list or a table that mkdocs takes for text") for line in page.raw]
    for target in page.links + page.loads:
        part = urlsplit(target)
        if part.scheme or part.netloc:
            if target in page.loads and part.scheme != "data":
                broken.append((path, target, "loaded from another host"))
            continue
        count += 1
        there = os.path.normpath(os.path.join(os.path.dirname(path), unquote(part.path))) if part.path else path
        if os.path.isdir(there):
            there = os.path.join(there, "index.html")
        if not os.path.isfile(there):
            broken.append((path, target, "no such file"))
        elif part.fragment and there in pages and unquote(part.fragment) not in pages[there].ids | {"__skip"}:
            broken.append((path, target, "no such heading"))
with open(os.path.join(folder, "search/search_index.json"), encoding="utf-8") as f:
    index = [e["location"].partition("#") for e in json.load(f)["docs"]]
for where, _, anchor in index:
    there = os.path.join(folder, where or "index.html")
    if there not in pages or anchor and anchor not in pages[there].ids:
        broken.append((there, "#" + anchor, "in the search's index, but not in the site"))
listed = {e[0] or "index.html" for e in index}
with open("mkdocs.yml", encoding="utf-8") as f:
    named = [os.path.splitext(n)[0] + ".html" for n in re.findall(r"([\w/.-]+\.md)$", f.read(), re.M)]
for page in [re.sub(r"README.html$", "index.html", n) for n in named]:
    if page not in listed:
        broken.append((folder, page, "in mkdocs.yml, but not in the search's index"))
with open("docs/scene.md", encoding="utf-8") as f:
    for key in re.findall(r"^\| `([a-z][^`]*)`", f.read(), re.M):
        if ("scene.html", "#", key) not in index:
            broken.append(("docs/scene.md", key, "not in the search's index"))
for where, _, names in os.walk(folder):
    for name in names:
        if name.endswith(".css"):
            with open(os.path.join(where, name), encoding="utf-8") as f:
                for target in re.findall(r"url\([\"']?((?:https?:)?//[^)]*)|@import([^;]*)", f.read()):
                    broken.append((os.path.join(where, name), "".join(target), "loaded from another host"))
for name in ("search/search.js", "search/local.js"):
    if not os.path.isfile(os.path.join(folder, name)):
        broken.append((folder, name, "no such file"))
for path, target, why in broken:
    print("%s: %s: %s" % (os.path.relpath(path, folder), target, why))
if not pages or broken:
    sys.exit("%d of %d links of %d pages are broken" % (len(broken), count, len(pages)))
print("%d links of %d pages hold; the search has %d entries" % (count, len(pages), len(index)))
