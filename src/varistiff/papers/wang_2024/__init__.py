"""Wang et al. (2024): a variable stiffness joint of leaf springs with a groove disc."""
