"""Planning again while a plan is carried out, and trying that out."""
