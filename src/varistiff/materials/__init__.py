"""Materials: stiffness, density, strength and fatigue limit, each value with its source."""

from varistiff.materials.table import Material, Property, builtin_materials, find_material, read_materials

__all__ = ["Material", "Property", "builtin_materials", "find_material", "read_materials"]
