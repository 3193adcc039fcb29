"""The scoreboard of the papers as table, files and page."""
