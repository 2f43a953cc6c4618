"""Check built documents: every link leads somewhere, and no page fetches anything elsewhere."""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

FETCHED = {"script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src"}
"""What a browser fetches by itself, and where that is said."""


class Page(HTMLParser):
    """A page: where its parts can be linked to, what it links to, and what it fetches."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.names: set[str] = set()
        self.links: list[str] = []
        self.fetched: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note what a tag says."""
        given = dict(attrs)
        self.names |= {name for key in ("id", "name") if (name := given.get(key))}
        if tag == "a" and (link := given.get("href")):
            self.links.append(link)
        # icons and styles are fetched; what a page is next to, or written in, is not
        if (key := FETCHED.get(tag)) and (link := given.get(key)):
            kinds = {"icon", "stylesheet", "preload", "manifest"}
            if tag != "link" or kinds & set((given.get("rel") or "").split()):
                self.fetched.append(link)


def faults_of(root: Path) -> list[str]:
    """Return what is wrong with the pages of a folder, one line each."""
    pages = {path: Page(path.read_text("utf-8")) for path in sorted(root.rglob("*.html"))}
    faults = [] if pages else [f"{root}: holds no page"]
    for path, page in pages.items():
        for link in page.links + page.fetched:
            parts = urlsplit(link)
            where = f"{path.relative_to(root)}: {link}"
            if parts.scheme == "data":
                continue
            if parts.scheme or parts.netloc:
                if link in page.fetched:
                    faults.append(f"{where}: is fetched from elsewhere")
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path.resolve()
            if not target.exists():
                faults.append(f"{where}: there is no such file")
            elif target in pages and unquote(parts.fragment) not in {"", *pages[target].names}:
                faults.append(f"{where}: there is no such place on that page")
    return faults


if __name__ == "__main__":
    found = faults_of(Path(sys.argv[1]).resolve())
    print(*found[:50], sep="\n", end="\n" if found else "")
    sys.exit(1 if found else 0)
