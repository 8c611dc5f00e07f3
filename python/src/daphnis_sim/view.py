"""The page of `Run.view`."""

from __future__ import annotations

from typing import Any, NoReturn

from ._errors import translated


class View:
    """A page that shows the states of a run in 3-D. A notebook shows it in a frame. Made by `Run.view`.

    This process serves it, to programs of its machine only, until `close` or its end.

    Attributes:
        address: of the page, for a browser.
        height: of the frame in pixels.
    """

    def __init__(self, page: Any, height: int) -> None:
        self._page = page
        self.address = str(page.getAddress())
        self.height = height

    def close(self) -> None:
        """Ends the page."""
        with translated():
            self._page.close()

    def _repr_html_(self) -> str:
        return f'<iframe src="{self.address}" width="100%" height="{self.height}" style="border: 0"></iframe>'

    def __reduce__(self) -> NoReturn:
        raise TypeError("a View is served by its process, it cannot be copied or sent; its address can")

    def __repr__(self) -> str:
        return f"<View {self.address}>"
