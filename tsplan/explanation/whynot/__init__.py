"""Why a mission cannot be met, and the smallest changes after which it can."""
