"""What an actuator answers over deflection and setting: points, maps and the datasheet."""
