"""What has happened: paths as they really were, the world as it is, the mission that is left."""
