"""Documents in another language: their prose from catalogues of gettext, everything else from the one source, by place."""
