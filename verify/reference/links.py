#!/usr/bin/env python3
"""Checks links without the network. usage: links.py REFERENCE

Of the pages of the reference: files and anchors; of the Markdown files of the repository: files, and anchors of headings.
"""
import os
import re
import subprocess
import sys
import urllib.parse


def read(path):
    with open(path, encoding="utf-8", errors="replace") as file:
        return file.read()


def heading_anchors(text):
    titles = re.findall(r"^#+ +(.*)$", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S), flags=re.M)
    return {re.sub(r"[^\w\- ]", "", t.lower()).strip().replace(" ", "-") for t in titles}


def page_anchors(text):
    return set(re.findall(r'(?:id|name)="([^"]+)"', text))


def links_of(path, text):
    if path.endswith(".html"):
        text = re.sub(r"<script.*?</script>", "", text, flags=re.S)
        return re.findall(r'(?:href|src)="([^"]+)"', text)
    return re.findall(r"\]\(([^)\s]+)\)", re.sub(r"^```.*?^```|`[^`\n]*`", "", text, flags=re.M | re.S))


def wrong_links(files):
    wrong, count = [], 0
    for path in files:
        text = read(path)
        for link in links_of(path, text):
            if re.match(r"[a-z]+:", link):
                continue
            count += 1
            target, _, anchor = urllib.parse.unquote(link.replace("&amp;", "&")).partition("#")
            target = os.path.normpath(os.path.join(os.path.dirname(path), target)) if target else path
            if not os.path.exists(target):
                wrong.append(f"{path}: there is no {link}")
            elif anchor and os.path.isfile(target) and target.endswith((".html", ".md")):
                anchors = page_anchors(read(target)) if target.endswith(".html") else heading_anchors(read(target))
                if anchor not in anchors:
                    wrong.append(f"{path}: {link}: there is no such place")
    return wrong, count


def main():
    pages = [os.path.join(sys.argv[1], name) for name in os.listdir(sys.argv[1]) if name.endswith(".html")]
    guides = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "*.md"], capture_output=True, text=True,
                            check=False).stdout.split()
    wrong, count = wrong_links(sorted(pages) + sorted(guides))
    print("\n".join(wrong) or f"{len(pages)} pages and {len(guides)} guides, {count} links: all lead somewhere")
    if wrong or len(pages) < 50:
        sys.exit(1)


main()
