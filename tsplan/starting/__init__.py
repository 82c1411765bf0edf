"""What a newcomer begins with: working missions, shipped examples, and schemas for editors."""
