"""guide.py GUIDE.md PICTURES OUT: the guide as a page of its own, OUT/index.html, and its pictures beside it.

Of Markdown it knows what the guide uses: headings, paragraphs, lists, pictures on a line of their own, bold, code
and links, of which the words stay (they lead to documents that are not there)."""
import html
import pathlib
import re
import shutil
import sys

HEAD = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src 'self' file: data:">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="dark light">
<link rel="icon" href="data:,">
<title>ArtiSketch: {title}</title>
<style>
body {{ max-width: 46rem; margin: 2rem auto; padding: 0 1rem; font: 17px/1.6 Inter, system-ui, sans-serif; }}
img {{ max-width: 100%; border-radius: 8px; }}
h1, h2 {{ line-height: 1.2; margin-top: 2.5rem; }}
code {{ font-size: .9em; }}
nav li {{ list-style: none; }}
</style>
</head>
<body>
<main>
"""
FOOT = "</main>\n</body>\n</html>\n"


def inline(text):
    text = html.escape(text, quote=False)
    text = re.sub(r"`([^`]+)`", r"<code>\1</code>", text)
    text = re.sub(r"\*\*([^*]+)\*\*", r"<strong>\1</strong>", text)
    return re.sub(r"\[([^\]]+)\]\([^)]+\)", r"\1", text)


def anchor(heading):
    return re.sub(r"[^a-z]+", "-", heading.lower()).strip("-")


def block(lines):
    first = lines[0]
    if picture := re.fullmatch(r"!\[([^\]]*)\]\(guide/([^)]+)\)", first):
        return f'<p><img src="{picture[2]}" alt="{html.escape(picture[1])}"></p>'
    if first.startswith("# "):
        return f"<h1>{inline(first[2:])}</h1>"
    if first.startswith("## "):
        return f'<h2 id="{anchor(first[3:])}">{inline(first[3:])}</h2>'
    if first.startswith("- "):
        items = re.split(r"\n- ", "\n".join(lines)[2:])
        return "<ul>\n" + "\n".join(f"<li>{inline(item)}</li>" for item in items) + "\n</ul>"
    return f"<p>{inline(chr(10).join(lines))}</p>"


def page(text):
    blocks = [piece.split("\n") for piece in re.split(r"\n{2,}", text.strip())]
    title, *rest = (block(lines) for lines in blocks)
    chapters = [lines[0][3:] for lines in blocks if lines[0].startswith("## ")]
    contents = "\n".join(f'<li><a href="#{anchor(one)}">{inline(one)}</a></li>' for one in chapters)
    return HEAD.format(title=html.escape(blocks[0][0][2:])) + "\n".join(
        [title, f'<nav aria-label="Contents">\n<ul>\n{contents}\n</ul>\n</nav>', *rest]) + "\n" + FOOT


def main(guide, pictures, out):
    out.mkdir(parents=True, exist_ok=True)
    (out / "index.html").write_text(page(guide.read_text("utf-8")), "utf-8")
    for picture in sorted(pictures.glob("*.png")):
        shutil.copyfile(picture, out / picture.name)


main(*map(pathlib.Path, sys.argv[1:]))
