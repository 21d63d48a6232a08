"""The derivation as a page, Markdown, LaTeX or text for a terminal, in German and English."""
