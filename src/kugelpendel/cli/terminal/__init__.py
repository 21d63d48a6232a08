"""What a terminal shows: descriptions, progress, estimates."""
