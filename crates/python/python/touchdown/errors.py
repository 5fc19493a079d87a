"""What goes wrong, as exceptions and warnings."""

from __future__ import annotations

# Of a value that is told, characters; of a longer one the type is told.
_LONGEST = 80


class InputError(ValueError):
    """Input that cannot be used, in the words of the command line.

    Attributes
    ----------
    key : str or None
        Dotted name of what is wrong, where the error is about a single one.
    value : str or None
        Its value as it was given; None where it is missing.
    allowed : str or None
        What is allowed.
    """

    def __init__(
        self,
        message: str,
        key: str | None = None,
        value: str | None = None,
        allowed: str | None = None,
    ) -> None:
        super().__init__(message, key, value, allowed)
        self.key = key
        self.value = value
        self.allowed = allowed

    @classmethod
    def of_value(cls, key: str, value: object, allowed: str) -> InputError:
        """The complaint that a value is not what is allowed."""
        said = repr(value)
        if "\n" in said or len(said) > _LONGEST:
            said = f"a {type(value).__name__}"
        return cls(f"{key} = {said}: expected {allowed}", key, said, allowed)

    def __str__(self) -> str:
        return str(self.args[0])


class EngineError(RuntimeError):
    """A fault of the engine itself."""


class LandingWarning(UserWarning):
    """Landings that are less than they seem, in the words of the command line.

    Footpads or blocks gave energy to the motion, footpads were crushed beyond their hinges, landings are undecided or could not be
    computed, transitions are disputed or lie at or below the lowest speed searched. A call warns once of all its landings.
    """
