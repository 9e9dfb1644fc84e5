"""The equations of the pages: how they are written, whether GitHub and KaTeX understand them, and their places in a
page of the site. In a line an equation is LaTeX between $` and `$, on lines of its own it is a fence of ```math.
Both are code for every tool that does not know them, so no underscore or star in them is read as Markdown.

Prints file:line of each equation that KaTeX cannot typeset or that GitHub would show as it is written; leaves with 1
if there is one. Without names: all Markdown files that git tracks.
usage: python3 tools/site/equations.py [FILE.md ...]
"""
import base64
import json
import os
import re
import subprocess
import sys
from html import escape, unescape

FENCE = re.compile(r" *(`{3,}|~{3,})(.*)")
ITEM = re.compile(r"([-*]|[0-9]+\.) ")
CODE = re.compile(r"(`+)(?!`)(.*?)(?<!`)\1(?!`)")
# What GitHub's MathJax refuses, or understands in another way than KaTeX.
REFUSED = re.compile(r"\\(operatorname|mbox|[hv]?phantom|href|def|(re)?newcommand|require|unicode|style|class|cssId|tag|"
                     r"label|htmlClass)\b")
SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "equations.js")

known = {}  # what equations.js has made of (LaTeX, is it displayed)


def lines_of(text):
    """Lines of a page as (line, kind): code is what is in fences or behind four blanks, math what is in ```math."""
    fence, kind, listed = "", "code", False
    for line in text.split("\n"):
        m = FENCE.match(line)
        if fence:
            ends = m and m.group(1).startswith(fence) and not m.group(2).strip()
            yield line, "code" if ends else kind
            fence = "" if ends else fence
        elif m:
            fence, kind = m.group(1), "math" if m.group(2).strip() == "math" else "code"
            yield line, "code"
        elif line.startswith("    ") and not listed:
            yield line, "code"
        else:
            listed = bool(ITEM.match(line.lstrip())) or (listed and (line[:1] in (" ", "")))
            yield line, "text"


def outside_code(text):
    """Lines of a page as (line, is it text)."""
    for line, kind in lines_of(text):
        yield line, kind == "text"


def inline_of(line):
    """The equations in a line of text, as (LaTeX, what is before, what is after)."""
    for m in CODE.finditer(line):
        before, after = line[:m.start()], line[m.end():]
        if m.group(1) == "`" and before.endswith("$") and after.startswith("$"):
            yield m.group(2), before[:-1], after[1:]


def of(text):
    """The equations of a page: those of its lines and those of its fences, each as (line, LaTeX)."""
    inline, fences, before = [], [], ""
    for number, (line, kind) in enumerate(lines_of(text), 1):
        if kind == "text":
            inline += [(number, tex) for tex, _, _ in inline_of(line)]
        elif kind == "math" and before == "math":
            fences[-1] = (fences[-1][0], fences[-1][1] + "\n" + line.strip())
        elif kind == "math":
            fences.append((number, line.strip()))
        before = kind
    return inline, fences


def unlike_github(text):
    """What GitHub would not show as an equation, as (line, sentence)."""
    wrong = []
    for number, (line, is_text) in enumerate(outside_code(text), 1):
        if not is_text:
            continue
        for tex, before, after in inline_of(line):
            if re.search(r"[\w-]$", before) or re.match(r"\w", after):
                wrong.append((number, "%s: a letter, digit or hyphen touches the equation" % tex))
            if before.endswith("*") or after.startswith("*"):
                wrong.append((number, "%s: bold or slanted text begins or ends with the equation" % tex))
            if re.search(r"\[[^]]*$", before) and re.match(r"[^[]*\]\(", after):
                wrong.append((number, "%s: an equation in the text of a link" % tex))
            if line.startswith("#"):
                wrong.append((number, "%s: an equation in a heading" % tex))
            if "|" in tex:
                wrong.append((number, r"%s: write \lvert and \rvert in place of |, which ends a cell" % tex))
        rest = CODE.sub("`", line).replace("$`$", "")
        if re.search(r"\$\$|\$`|`\$|(?<![\\\w])\$[^ $][^$]*\$|\\[(\[]", rest):
            wrong.append((number, "an equation that is not written as $`...`$ or in a fence of ```math"))
    for number, tex in [e for part in of(text) for e in part]:
        if REFUSED.search(tex):
            wrong.append((number, "%s: GitHub has no %s" % (tex, REFUSED.search(tex).group(0))))
        if re.search(r"[<>%]", tex):
            wrong.append((number, r"%s: write \lt and \gt in place of < and >, and no percent sign" % tex))
    return wrong


def katex(*options, asked=""):
    done = subprocess.run(["node", SCRIPT, *options], input=asked, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError("equations are typeset by node and katex (Debian: package katex)\n" + done.stderr)
    return done.stdout


def typeset(equations):
    """What equations.js makes of equations (LaTeX, is it displayed)."""
    new = [e for e in dict.fromkeys(equations) if e not in known]
    if new:
        asked = json.dumps([{"tex": tex, "display": display} for tex, display in new])
        known.update(zip(new, json.loads(katex(asked=asked))))
    return [known[e] for e in equations]


def asked_of(text):
    """The equations of a page as typeset takes them."""
    inline, fences = of(text)
    return [(tex, False) for _, tex in inline] + [(tex, True) for _, tex in fences]


def typeset_all(texts):
    """Typesets the equations of all pages at once: a start of node takes longer than hundreds of equations."""
    typeset([e for text in texts for e in asked_of(text)])


def faults(text):
    """What is wrong with the equations of a page, as (line, sentence)."""
    inline, fences = of(text)
    made = typeset(asked_of(text))
    bad = [(number, "%s: %s" % (tex.replace("\n", " "), m["error"]))
           for (number, tex), m in zip(inline + fences, made) if "error" in m]
    return sorted(unlike_github(text) + bad)


def in_page(html, text):
    """The page with the words of its equations, which the search shows, in the place of each, and a list of these
    places with what is shown there. Raises ValueError if not every equation of the Markdown text is in the page."""
    found = []

    def kept(display):
        def place(m):
            tex = "\n".join(line.strip() for line in unescape(m.group(1)).strip().split("\n"))
            found.append((tex, display))
            return "\0%d\0" % (len(found) - 1)
        return place

    html = re.sub(r'<pre class="math"><code>(.*?)</code></pre>', kept(True), html, flags=re.S)
    html = re.sub(r"\$<code>(.*?)</code>\$", kept(False), html, flags=re.S)
    inline, fences = of(text)
    written = [(tex.strip(), False) for _, tex in inline] + [(tex.strip(), True) for _, tex in fences]
    for tex, _ in [e for e in written if written.count(e) != found.count(e)]:
        raise ValueError("%s: the page does not show it as an equation" % tex)
    shown = []
    for n, ((_, display), made) in enumerate(zip(found, typeset(found))):
        words = '<span class="equation-%d">%s</span>' % (n, "" if display else escape(made["text"]))
        html = html.replace("\0%d\0" % n, words)
        shown.append((words, made["html"]))
    return html, shown


def style():
    """KaTeX's style sheet with its fonts in it: a browser that opened a page from a folder may refuse to load them."""
    sheet = katex("--style")

    def font(m):
        with open(os.path.join(os.path.dirname(sheet), m.group(1)), "rb") as f:
            return "src:url(data:font/woff2;base64,%s) format('woff2')" % base64.b64encode(f.read()).decode()

    with open(sheet, encoding="utf-8") as f:
        return re.sub(r"src:url\(([^)]*\.woff2)\) format\('woff2'\)[^;}]*", font, f.read())


def main(names):
    if not names:
        names = subprocess.run(["git", "ls-files", "-z", "*.md"], capture_output=True, text=True,
                               check=True).stdout.rstrip("\0").split("\0")
    count, wrong, texts = 0, 0, {}
    for name in names:
        with open(name, encoding="utf-8") as f:
            texts[name] = f.read()
    typeset_all(texts.values())
    for name, text in texts.items():
        count += sum(len(part) for part in of(text))
        for number, sentence in faults(text):
            print("%s:%d: %s" % (name, number, sentence))
            wrong += 1
    if wrong:
        sys.exit("%d faults in %d equations" % (wrong, count))
    print("%d equations are typeset" % count)


if __name__ == "__main__":
    main(sys.argv[1:])
