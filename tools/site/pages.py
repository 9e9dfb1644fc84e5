"""Hook of mkdocs (mkdocs.yml): what the pages in docs/ link to outside of docs/ becomes a part of the site.

A Markdown file or a folder's README.md becomes a page, a source file a page with its text, a folder without README.md
a list of what is in it, and any other file a copy. These pages are searched for links in turn. Only files that git
tracks, or that could be added, are taken. Links are rewritten to where their target stands in the site.

Equations (equations.py) are typeset when the site is built. An equation that cannot be ends the build.

The search finds pages of text only, not those that show a source file or list a folder: their short texts would come
before the page that explains a key. Each key of scene.md is an entry of its own. Pages have weights (mkdocs.yml: extra,
weights): how-to pages come before results. A browser lets no page that it opened from a folder fetch the index or start
a worker; such a page loads both as a script, search/local.js.
"""
import glob
import json
import os
import posixpath
import re
import shutil
import subprocess
import sys
from html import escape, unescape

from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import equations  # noqa: E402
from equations import ITEM, outside_code  # noqa: E402

SHOWN = {".c": "c", ".h": "c", ".sh": "bash", ".awk": "awk", ".yaml": "yaml", ".cmake": "cmake", ".py": "python"}
LINK = re.compile(r"(!?\[(?:[^][]|\[[^][]*\])*\]\()<?([^ ()<>]*(?:\([^ ()]*\)[^ ()<>]*)*)>?((?: +\"[^\"]*\")?\))")
# In the theme's worker: where an entry of the index is added. The theme of Debian 12 knows no weights.
ADDED = re.compile(r"(for\(let (\w+) of \w+\))this\.add\(\2(?:,\{boost:\2\.boost\})?\)")

root = ""  # of the repository
tracked = set()  # paths of files in it
folders = set()
made = {}  # place in the site: text of a page that is no file
shown = {}  # place in the site: its equations, as (words in their place, HTML)
unread = {}  # place in the site: HTML of a page that the search does not find
keys = []  # of scene.md, as entries of the search's index
place = {}  # path in the repository: place in the site


def in_links(text, change):
    """The text with each link's target replaced by change(target); code in backquotes is left alone."""
    out = []
    for line, is_text in outside_code(text):
        if is_text and "](" in line:
            spans = re.split(r"(`+[^`]*`+)", line)
            kept = spans[1::2]
            joined = "".join(s if i % 2 == 0 else "\0%d\0" % (i // 2) for i, s in enumerate(spans))
            joined = LINK.sub(lambda m: m.group(1) + change(m.group(2)) + m.group(3), joined)
            line = re.sub("\0([0-9]+)\0", lambda m: kept[int(m.group(1))], joined)
        out.append(line)
    return "\n".join(out)


def spaced(text):
    """What GitHub's Markdown understands and mkdocs' does not: lists and tables without a blank line before them, and
    further paragraphs of a list's item that are indented by less than four blanks."""
    out, before, before_is_text, in_list, further = [], "", True, False, False
    for line, is_text in outside_code(text):
        item = is_text and bool(ITEM.match(line.lstrip()))
        if in_list and is_text and re.match(r" {2,3}\S", line) and not item:
            further = further or not before.strip()
        elif line.strip():
            if further and item and before.strip():
                out.append("")
            further = False
        if further and line.strip():
            line = "    " + line.lstrip()
        if is_text and before.strip() and before_is_text:
            if item and not in_list or line.startswith("|") and not before.startswith("|"):
                out.append("")
        if not before.strip() and line[:1] not in (" ", "") and not item:
            in_list = False
        in_list = in_list or item
        out.append(line)
        before, before_is_text = line, is_text
    return "\n".join(out)


def found(path):
    """The file or folder that a path of the repository means: its README.md, if it is a folder with one."""
    path = posixpath.normpath(path)
    return posixpath.join(path, "README.md") if posixpath.join(path, "README.md") in tracked else path


def place_of(path):
    """Where a file of the repository stands in the site."""
    if path.startswith("docs/"):
        return path[len("docs/"):]
    if path == "README.md":
        return "repository.md"
    if path in folders:
        return path + "/index.md"
    return path + ".md" if os.path.splitext(path)[1] in SHOWN else path


def path_of(page):
    """The path in the repository of a page of the site."""
    where = page.file.src_uri
    return next((p for p, w in place.items() if w == where), where)


def is_unread(path):
    """Whether the search does not find it: a page that shows a source file or lists a folder."""
    return os.path.splitext(path)[1] in SHOWN or path in folders


def text_of(path):
    """Markdown of a path of the repository that becomes a page, else None."""
    extension = os.path.splitext(path)[1]
    if path in folders:
        inside = sorted({p[len(path) + 1:].split("/")[0] for p in tracked if p.startswith(path + "/")})
        inside = [i for i in inside if path != "cases" or posixpath.join(path, i, "README.md") in tracked]
        return "# %s\n\n%s\n" % (path, "\n".join("* [%s](%s)" % (i, i) for i in inside))
    if extension != ".md" and extension not in SHOWN:
        return None
    with open(os.path.join(root, path), encoding="utf-8") as f:
        text = f.read()
    return text if extension == ".md" else "# %s\n\n~~~~{.%s}\n%s\n~~~~\n" % (path, SHOWN[extension], text)


def is_elsewhere(target):
    return not target or target.startswith("#") or re.match(r"[a-z]+:", target)


def targets(path, text):
    """Paths of the repository that a page links to."""
    links = []
    in_links(text, lambda t: links.append(t) or t)
    for target in links:
        if not is_elsewhere(target):
            yield found(posixpath.join(posixpath.dirname(path), target.split("#")[0]))


def on_files(files, config):
    global root
    root = os.path.dirname(os.path.abspath(config["config_file_path"]))
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=root,
                            check=True, capture_output=True, text=True).stdout
    tracked.update(p for p in listed.split("\0") if os.path.isfile(os.path.join(root, p)))
    for path in tracked:
        while "/" in path:
            path = path.rsplit("/", 1)[0]
            folders.add(path)
    todo = sorted(p for p in tracked if p.startswith("docs/"))
    seen = set(todo)
    while todo:
        path = todo.pop()
        where = place[path] = place_of(path)
        text = text_of(path) if path.endswith(".md") or not path.startswith("docs/") else None
        if not path.startswith("docs/"):
            file = File(where, root, config["site_dir"], config["use_directory_urls"])
            file.abs_src_path = os.path.join(root, path)
            files.append(file)
            if not path.endswith(".md") and text is not None:
                made[where] = text
        if text is None or os.path.splitext(path)[1] in SHOWN:
            continue
        base = path + "/index.md" if path in folders else path
        for target in targets(base, text):
            if target not in seen and (target in tracked or target in folders):
                seen.add(target)
                todo.append(target)
    equations.typeset_all(text_of(p) for p in place if p.endswith(".md"))
    return files


def paper_of(text, title, bib):
    """A paper in the Journal of Open Source Software's form as a page: title, citations, references."""
    entries = {}
    for entry in re.split(r"^@\w+", bib, flags=re.M)[1:]:
        fields = {k: re.sub(r"[{}]", "", v) for k, v in re.findall(r"(\w+)\s*=\s*\{(.*)\}", entry)}
        entries[re.match(r"\{(\w+)", entry).group(1)] = fields

    def short(key):
        names = [n.split(",")[0] for n in entries[key]["author"].split(" and ")]
        return "%s %s" % (" and ".join(names) if len(names) < 3 and "others" not in names else names[0] + " et al.",
                          entries[key]["year"])

    def cited(m):
        return "(%s)" % "; ".join(short(k) for k in re.findall(r"@(\w+)", m.group(0)))

    text = re.sub(r"\[@[^]]*\]", cited, text)
    text = re.sub(r"(?<![\w(])@(\w+)", lambda m: short(m.group(1)), text)
    rows = ["* %s: %s. %s %s. [%s](https://doi.org/%s)" % (short(k), e["title"], e["journal"], e.get("volume", ""),
                                                          e["doi"], e["doi"])
            for k, e in sorted(entries.items())]
    return "# %s\n\n%s\n\n%s\n" % (title, re.sub(r"^#", "##", text, flags=re.M).rstrip(), "\n".join(rows))


def on_page_read_source(page, config):
    return made.get(page.file.src_uri)


def on_page_markdown(markdown, page, config, files):
    where, path = page.file.src_uri, path_of(page)
    if os.path.splitext(path)[1] in SHOWN:
        return markdown
    base = path + "/index.md" if path in folders else path
    if "bibliography" in page.meta:
        bib = os.path.join(root, os.path.dirname(path), page.meta["bibliography"])
        with open(bib, encoding="utf-8") as f:
            markdown = paper_of(markdown, page.meta["title"], f.read())

    def change(target):
        if is_elsewhere(target):
            return target
        bare, _, anchor = target.partition("#")
        there = place.get(found(posixpath.join(posixpath.dirname(base), bare)))
        if there is None:
            return target  # mkdocs warns of it
        return posixpath.relpath(there, posixpath.dirname(where) or ".") + ("#" + anchor if anchor else "")

    return spaced(in_links(markdown, change))


def with_equations(html, page):
    where, path = page.file.src_uri, path_of(page)
    with open(page.file.abs_src_path, encoding="utf-8") as f:
        wrong = ["%s:%d: %s" % (path, number, sentence) for number, sentence in equations.faults(f.read())]
    if wrong:
        raise PluginError("an equation is wrong\n" + "\n".join(wrong))
    try:
        html, shown[where] = equations.in_page(html, page.markdown)
    except ValueError as e:
        raise PluginError("%s: %s" % (path, e)) from e
    return html


def with_labels(html):
    """A table of three columns or more, one of which is of sentences, gets the attribute data-cards. Its cells get their
    column's name, those of the longest column data-long: on a phone docs/pictures/site.css shows a row as a card."""

    def length(cell):
        return len(re.sub(r"<[^>]*>", "", cell))

    def labelled(m):
        names = [unescape(re.sub(r"<[^>]*>", "", n)) for n in re.findall(r"<th[^>]*>(.*?)</th>", m.group(0), flags=re.S)]
        rows = [re.findall(r"<td[^>]*>(.*?)</td>", r, flags=re.S) for r in m.group(0).split("<tr")[2:]]
        if len(names) < 3 or not rows or any(len(r) != len(names) for r in rows):
            return m.group(0)
        mean = [sum(length(r[i]) for r in rows) / len(rows) for i in range(len(names))]
        longest = max(range(1, len(names)), key=lambda i: mean[i])
        if mean[longest] < 28:
            return m.group(0)

        def row(r):
            columns = iter(range(len(names)))

            def cell(_):
                i = next(columns)
                return '<td data-label="%s"%s' % (escape(names[i], quote=True), " data-long" if i == longest else "")

            return re.sub(r"<td", cell, r.group(0))

        table = re.sub(r"<tr[^>]*>\s*<td.*?</tr>", row, m.group(0), flags=re.S)
        return table.replace("<table>", "<table data-cards>", 1)

    return re.sub(r"<table>.*?</table>", labelled, html, flags=re.S)


def on_page_content(html, page, config, files):
    """Equations are words, for the search. Each key in a table of scene.md gets an id, and is found by its name. What
    the search does not find is kept from it, as it takes long to read, until on_page_context."""
    if is_unread(path_of(page)):
        unread[page.file.src_uri] = html
        return ""
    html = with_equations(html, page)
    if page.file.src_uri != "scene.md":
        return with_labels(html)

    def named(m):
        key = unescape(m.group(1))
        if key in (k["title"] for k in keys):
            return m.group(0)
        text = unescape(re.sub(r"<[^>]*>", "", " ".join(re.split(r"</td>", m.group(2))))).split()
        keys.append({"location": "%s#%s" % (page.file.dest_uri, key), "title": key, "text": " ".join(text)})
        return '<tr id="%s">%s' % (key, m.group(0)[len("<tr>"):])

    return with_labels(re.sub(r"<tr>\s*<td><code>([a-z][^<]*)</code></td>(.*?)</tr>", named, html, flags=re.S))


def on_page_context(context, page, config, nav):
    page.content = unread.get(page.file.src_uri, page.content)
    return context


def on_post_page(output, page, config):
    up = "../" * page.file.dest_uri.count("/")
    for words, html in shown.get(page.file.src_uri, []):
        if words not in output:
            raise PluginError("%s: an equation is lost: %s" % (page.file.dest_uri, words))
        output = output.replace(words, html)
    if shown.get(page.file.src_uri):
        output = output.replace("</head>", '<link rel="stylesheet" href="%sassets/equations.css"></head>' % up, 1)
    bundle = '<script src="%sassets/javascripts/bundle.' % up
    if bundle not in output:
        raise PluginError("%s: no script of the theme to put search.js before" % page.file.dest_uri)
    return output.replace(bundle, '<script src="%ssearch/search.js"></script>%s' % (up, bundle))


def on_post_build(config):
    site = config["site_dir"]
    with open(os.path.join(site, "assets/equations.css"), "w", encoding="utf-8") as f:
        f.write(equations.style())
    with open(os.path.join(site, "search/search_index.json"), encoding="utf-8") as f:
        index = json.load(f)
    without = {os.path.splitext(w)[0] + ".html" for p, w in place.items() if is_unread(p)}
    index["docs"] = [d for d in index["docs"] if d["location"].split("#")[0] not in without] + keys
    for d in index["docs"]:
        path = d["location"].split("#")[0] or "index.html"
        d["boost"] = next((w for b, w in config["extra"]["weights"].items() if path.startswith(b)), 1)
    text = json.dumps(index, separators=(",", ":"), sort_keys=True)
    with open(os.path.join(site, "search/search_index.json"), "w", encoding="utf-8") as f:
        f.write(text)
    (worker,) = glob.glob(os.path.join(site, "assets/javascripts/workers/search.*.min.js"))
    with open(worker, encoding="utf-8") as f:
        code, changed = ADDED.subn(r"\1this.add(\2,{boost:\2.boost})", f.read())
    if not changed:
        raise PluginError("%s: no place where a page is added to the index, to give it its weight" % worker)
    with open(worker, "w", encoding="utf-8") as f:
        f.write(code)
    code = json.dumps(code)
    with open(os.path.join(site, "search/local.js"), "w", encoding="utf-8") as f:
        f.write("__search.index = Promise.resolve(%s);\n__search.worker = URL.createObjectURL("
                'new Blob([%s], {type: "text/javascript"}));\n' % (text, code))
    shutil.copy(os.path.join(root, "tools/site/search.js"), os.path.join(site, "search/search.js"))
