"""The catalogues of translations: `python -m tests.translations` brings them up to date and lists what is to translate."""
