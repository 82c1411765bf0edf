"""The distributed protocol of swarms: agents that go by chance, and the margin that this takes."""
