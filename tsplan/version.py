"""The version of the package, which is said here alone: the build and every room read it here."""

VERSION = "0.1.0"
