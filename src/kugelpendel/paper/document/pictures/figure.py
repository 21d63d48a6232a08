"""A picture with its caption, in a language."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.paper.document.example import TO_BUILD, WIDE
from kugelpendel.paper.document.pictures.geometry import geometry
from kugelpendel.paper.document.pictures.plan import ellipse, path
from kugelpendel.paper.document.pictures.sizes import sizes_drawn, sizes_told

if TYPE_CHECKING:
    from collections.abc import Callable

    from kugelpendel.paper.document.wording import Words


def figure(key: str, words: Words, say: Callable[[str], str]) -> str:
    """Write a ``figure`` element.

    Parameters
    ----------
    key
        "geometry", "ellipse", "path" or "sizes".
    words
        The wording, in whose language the picture is labelled and described.
    say
        A function that writes a sentence of the wording as HTML, for the caption.
    """
    text = words.picture(key)
    title, told = text["title"], text["told"]
    match key:
        case "geometry":
            drawn = geometry(title, told)
        case "ellipse":
            drawn = ellipse(title, told)
        case "path":
            drawn = path(WIDE, title, told, (text["start"], text["end"]))
        case _:
            listed = sizes_told(TO_BUILD, text, words.language)
            drawn = sizes_drawn(TO_BUILD, title, f"{told} {listed}", text, words.language)
    return (
        f'<figure id="figure-{key}"><div class="picture" tabindex="0">{drawn}</div>'
        f"<figcaption>{say(text['caption'])}</figcaption></figure>\n"
    )
