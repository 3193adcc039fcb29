"""Plan the roller's course of the regenerative knee and write it to knee_roller.csv: ``python knee_plan.py``."""

import csv
import sys
from pathlib import Path

import varistiff
from varistiff.dynamics.drives import motor
from varistiff.dynamics.gait import knee_gait
from varistiff.dynamics.gait.knee_trajectory import knee_trajectory
from varistiff.dynamics.gait.roller_plan import RollerPlan, Shuttle, roller_plan

HERE = Path(__file__).parent
BODY_MASS = 80.0  # kg
ENERGY_WEIGHT = 3.0  # (N m)^2/J: a moment error of 1.7 N m is worth a joule


def tell(text: str) -> None:
    """Write a line."""
    sys.stdout.write(text + "\n")


def plan(weight: float = ENERGY_WEIGHT) -> RollerPlan:
    """Course for the design beside this file, with the motor, gear and mass of knee_walking.yaml."""
    design = varistiff.load(HERE / "knee_beam.yaml")
    drive = motor("maxon_ec_4pole_30_200w_36v", gear_ratio=6.3 / 0.007, current_limit=20.0, voltage_limit=36.0)
    low, high = design.setting_range
    travel = {"setting_min": low, "setting_max": high}
    static = knee_trajectory(design.actuator, knee_gait(), body_mass=BODY_MASS, **travel)
    tell(f"without inertia: followed for {static.share:.0%}, error {static.error_rms:.2f} N m rms")
    shuttle = Shuttle(drive, mass=0.25)
    return roller_plan(design.actuator, knee_gait(), shuttle, body_mass=BODY_MASS, energy_weight=weight, **travel)


if __name__ == "__main__":
    course = plan()
    start = course.signal().at(0.0)
    tell(f"planned: error {course.error_rms:.2f} N m rms, {course.electrical_energy:.2f} J drawn per step")
    tell(f"start: {1e3 * float(start.value):.4f} mm, {float(start.rate):.5f} m/s")
    with (HERE / "knee_roller.csv").open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["time [s]", "setting [mm]"])
        for instant, place in zip(course.time, course.setting, strict=True):
            table.writerow([f"{instant:.6f}", f"{1e3 * place:.5f}"])
