"""Colour LUTs: read, write, bake for engines, verify, edit, apply to arrays."""

from typing import Any, Sequence

import numpy
import numpy.typing

__version__: str

Rgb = tuple[float, float, float]
Figures = dict[str, Any]
Array = numpy.typing.NDArray[Any]

class Error(ValueError):
    message: str
    file: str | None
    line: int | None

class UsageError(Error): ...

class Look:
    @staticmethod
    def from_arrays(
        *,
        cube: numpy.typing.ArrayLike | None = None,
        shaper: numpy.typing.ArrayLike | None = None,
        domain: tuple[float | Sequence[float], float | Sequence[float]] = (0.0, 1.0),
        title: str = "",
        input: str | None = None,
        output: str | None = None,
    ) -> Look: ...
    def __call__(self, colours: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def path(self) -> str: ...
    @property
    def title(self) -> str: ...
    @property
    def format(self) -> str: ...
    @property
    def domain(self) -> tuple[Rgb, Rgb]: ...
    @property
    def input(self) -> str | None: ...
    @property
    def output(self) -> str | None: ...
    @property
    def interpolation(self) -> str: ...
    @property
    def cube(self) -> numpy.typing.NDArray[numpy.float32] | None: ...
    @property
    def shaper(self) -> numpy.typing.NDArray[numpy.float32] | None: ...
    @property
    def losses(self) -> list[Figures]: ...
    @property
    def remarks(self) -> list[str]: ...

class Recipe:
    title: str
    def __init__(
        self,
        title: str = "",
        *,
        input: str = "srgb",
        output: str | None = None,
        base: Look | None = None,
        size: int = 0,
    ) -> None: ...
    @staticmethod
    def from_json(text: str, file: str = "recipe") -> Recipe: ...
    def add(self, op: str, *, enabled: bool = True, opacity: float = 1.0, **values: Any) -> Recipe: ...
    @property
    def operators(self) -> list[dict[str, Any]]: ...
    def to_json(self) -> str: ...
    def save(self, path: str) -> None: ...
    def look(self) -> Look: ...

def read(
    path: str,
    *,
    format: str = "",
    layout: str | None = None,
    engine: str | None = None,
    row: int = 0,
    interpolation: str | None = None,
    input: str | None = None,
    output: str | None = None,
) -> Look: ...
def write(
    look: Look, path: str, *, format: str = "", title: str = "", size: int = 0, bits: int = 16
) -> list[Figures]: ...
def recipe_of(look: Look) -> Recipe: ...
def apply(
    look: Look,
    array: Array,
    *,
    out: Array | None = None,
    interpolation: str | None = None,
    threads: int = 0,
    bits: int = 0,
) -> Array: ...
def bake(
    look: Look,
    engine: str,
    path: str | None = None,
    *,
    size: int = 0,
    bits: int = 0,
    convert: bool = True,
    fit: bool = False,
    measure: bool = False,
) -> Figures: ...
def verify(
    picture: str,
    against: str,
    engine: str | None = None,
    *,
    row: int | None = None,
    interpolation: str | None = None,
    input: str | None = None,
    output: str | None = None,
    convert: bool = True,
) -> Figures: ...
def compare(
    a: Look,
    b: Look,
    *,
    encoding: str | None = None,
    reference_white: float = 203.0,
    samples: int = 100000,
) -> Figures: ...
def check(look: Look) -> list[Figures]: ...
def report(look: Look, *, sizes: list[int] | None = None, promise: float = 1.0) -> Figures: ...
def engines() -> list[Figures]: ...
def encodings() -> Figures: ...
def operators() -> list[Figures]: ...
def formats() -> list[Figures]: ...
