"""A recorded session as one page for a person: data out of the folder, figures, page."""
