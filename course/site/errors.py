"""What may go wrong when the course site is built."""

from armproof.models.errors import ArmproofError


class SiteError(ArmproofError):
    """The site cannot be built: an unknown lesson, one that does not pass or does not run, a folder that cannot be written."""
