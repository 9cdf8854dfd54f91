"""Links of a site: every link and anchor leads somewhere, and no page takes anything from the network."""
import html.parser
import pathlib
import re
import urllib.parse

_resources = {("link", "href"), ("script", "src"), ("img", "src"), ("iframe", "src"), ("source", "src")}


class _Page(html.parser.HTMLParser):
    def __init__(self, text: str) -> None:
        super().__init__()
        self.ids: set[str] = set()
        self.links: list[tuple[str, bool]] = []  # address, and whether the browser loads it by itself
        self.styles: list[str] = []
        self._style = False
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self._style = tag == "style"
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.ids.add(value)
            elif name in ("href", "src") and value is not None:
                self.links.append((value, (tag, name) in _resources))
            elif name == "style" and value:
                self.styles.append(value)

    def handle_data(self, data: str) -> None:
        if self._style:
            self.styles.append(data)


def faults(site: pathlib.Path) -> list[str]:
    """What is wrong with the links of all pages and style sheets below a folder."""
    found = []
    site = site.resolve()
    pages = {path: _Page(path.read_text(encoding="utf-8")) for path in site.rglob("*.html")}
    reports = {path for path in pages if "reports" in path.relative_to(site).parts}  # made by the program; tested there
    for path, page in pages.items():
        if path in reports or path.name == "404.html":
            continue
        name = path.relative_to(site)
        for address, loaded in page.links:
            parts = urllib.parse.urlsplit(address)
            if parts.scheme in ("http", "https") or address.startswith("//"):
                if loaded:
                    found.append(f"{name}: takes {address} from the network")
                continue
            if parts.scheme in ("data", "mailto", "javascript"):
                continue
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if parts.scheme or parts.path.startswith("/"):
                found.append(f"{name}: not relative: {address}")
            elif not target.is_file():
                found.append(f"{name}: no such file: {address}")
            elif parts.fragment.startswith("scenario="):
                pass  # read by the live page
            elif parts.fragment and target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].ids:
                found.append(f"{name}: no such place: {address}")
        found += [f"{name}: a style takes {address} from the network" for style in page.styles for address in _remote(style)]
    for path in site.rglob("*.css"):
        text = path.read_text(encoding="utf-8")
        found += [f"{path.relative_to(site)}: takes {address} from the network" for address in _remote(text)]
        for address in re.findall(r"url\(([^)]*)\)", text):
            file = address.strip("'\" ").split("#")[0].split("?")[0]
            if file and not re.match(r"(data|https?):", file) and not (path.parent / file).is_file():
                found.append(f"{path.relative_to(site)}: no such file: {file}")
    return found


def _remote(style: str) -> list[str]:
    return re.findall(r"""(?:url\(|@import)\s*['"]?((?:https?:)?//[^'")\s;]+)""", style)
