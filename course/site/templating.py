"""The shell of the site's pages: they show pictures and the 3D views beside them."""

from __future__ import annotations

from armproof.verification.report.html.templating import Shell

SITE = Shell("armproof.course.site", ("shell.css", "site.css"), "site.js", allowed="img-src data:; frame-src 'self'; ")
