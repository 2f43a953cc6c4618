"""Look at built documents in a browser: no page asks for anything elsewhere, and search finds."""

import os
import shutil
import sys
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from playwright.sync_api import Page, Response, Route, sync_playwright

WORDS = {
    "capability": "environment.html",
    "with_pose": "api/object.html",
    "rosbags": "how-to/ros2.html",
}
"""What is searched for, and a page that has to be among what is found."""


class Quiet(SimpleHTTPRequestHandler):
    """A server of files that does not tell what it is asked."""

    def log_message(self, *_: object) -> None:
        """Say nothing."""


def faults_of(root: Path, page: Page, address: str) -> list[str]:
    """Return what is wrong with the pages of a folder that is served at an address."""
    faults: list[str] = []
    page.on("pageerror", lambda error: faults.append(f"{page.url}: {error}"))

    def asked(route: Route) -> None:
        """Let through what is asked of the server, and note all else."""
        if route.request.url.startswith((address, "data:")):
            route.continue_()
        else:
            faults.append(f"{page.url}: asks for {route.request.url}")
            route.abort()

    def answered(response: Response) -> None:
        """Note what the server does not have."""
        if response.status >= 400:
            faults.append(f"{page.url}: {response.url} has status {response.status}")

    page.route("**/*", asked)
    page.on("response", answered)
    for path in sorted(root.rglob("*.html")):
        page.goto(
            f"{address}/{path.relative_to(root).as_posix()}", wait_until="load", timeout=120_000
        )
    for word, wanted in WORDS.items():
        page.goto(f"{address}/search.html?q={word}")
        page.wait_for_selector("#search-results .search-summary", timeout=30_000)
        page.wait_for_selector("#search-results li", timeout=30_000)
        found = page.eval_on_selector_all("#search-results li a", "all => all.map(a => a.href)")
        if not any(wanted in link for link in found):
            faults.append(f"searching for {word!r} does not find {wanted}, but {found}")
    return faults


def main(root: Path) -> int:
    """Serve the documents on this machine, and look at each page."""
    named = os.environ.get("SWARMGRASP_BROWSER")
    if not named:
        print("The pages are not looked at in a browser: SWARMGRASP_BROWSER names none.")
        return 0
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(root)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with sync_playwright() as play:
        browser = play.chromium.launch(
            executable_path=shutil.which(named), args=["--no-sandbox"], headless=True
        )
        found = faults_of(root, browser.new_page(), f"http://127.0.0.1:{server.server_port}")
        browser.close()
    server.shutdown()
    print(*dict.fromkeys(found[:50]), sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
