"""Storages: what the drives draw from and return to, with every loss by its own law."""

from varistiff.core import precision
from varistiff.dynamics.storage.battery import Battery
from varistiff.dynamics.storage.ideal_supply import IdealSupply
from varistiff.dynamics.storage.storage import Storage, StorageFlows
from varistiff.dynamics.storage.supercapacitor import Supercapacitor
from varistiff.dynamics.storage.supply import Supply

precision.enable()

__all__ = ["Battery", "IdealSupply", "Storage", "StorageFlows", "Supercapacitor", "Supply"]
