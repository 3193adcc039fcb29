"""Pictures and documents: what a person reads of a characteristic map."""
