from typing import Callable, Sequence

import numpy as np
import numpy.typing as npt

__version__: str

class StellateError(Exception): ...
class InputError(StellateError): ...

class LimitReached(StellateError):
    finished: bytes | None

class InternalError(StellateError): ...

_Source = tuple[str, str | None, str]
_Progress = Callable[[str, int, int], object] | None
_Doubles = npt.NDArray[np.float64]
_Codes = npt.NDArray[np.int8]

def call(
    verb: str,
    forms: Sequence[_Source],
    options: str,
    data: bytes,
    progress: _Progress,
) -> tuple[bytes, list[str], str | None, str | None]: ...
def main(arguments: Sequence[str]) -> int: ...

class Inspector:
    def __new__(
        cls, form: _Source, options: str, dimension: int, progress: _Progress
    ) -> Inspector: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def is_over(self) -> bool: ...
    def inspect(
        self, columns: Sequence[_Doubles], progress: _Progress
    ) -> tuple[_Codes, _Codes, _Doubles, _Doubles, _Codes]: ...
    def inspect_with_feet(
        self, columns: Sequence[_Doubles], progress: _Progress
    ) -> tuple[
        tuple[_Codes, _Codes, _Doubles, _Doubles, _Codes],
        tuple[_Doubles, _Doubles, _Doubles, _Doubles],
    ]: ...
    def sign(self, columns: Sequence[_Doubles], progress: _Progress) -> _Codes: ...

class Radius:
    def __new__(cls, form: _Source) -> Radius: ...
    @property
    def is_in_space(self) -> bool: ...
    def at(self, theta: _Doubles, phi: _Doubles | None) -> _Doubles: ...
