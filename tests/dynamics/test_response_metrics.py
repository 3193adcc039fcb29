"""Step metrics and bandwidth against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.dynamics.response_metrics import bandwidth, step_metrics
from varistiff.dynamics.signals import Chirp

TIME = np.linspace(0.0, 4.0, 8001)
START = 0.5


def _step(answer):
    since = TIME - START
    wanted = np.where(TIME >= START, 3.0, 1.0)
    real = 1.0 + 2.0 * np.where(since > 0.0, answer(np.maximum(since, 0.0)), 0.0)
    return step_metrics(TIME, wanted, real, "rad", "position")


def test_first_order():
    found = _step(lambda t: 1.0 - np.exp(-t / 0.2))
    # lines between samples of 0.5 ms err by t^2/(8 tau^2), about 1e-6 of tau
    assert found["position_rise_time"].value == pytest.approx(0.2 * math.log(9.0), rel=1e-4)
    assert found["position_settling_time"].value == pytest.approx(0.2 * math.log(50.0), rel=1e-4)
    assert found["position_overshoot"].value == 0.0


def test_second_order():
    damping, pulsation = 0.3, 10.0
    root = math.sqrt(1.0 - damping**2)

    def answer(t):
        angle = pulsation * root * t
        return 1.0 - np.exp(-damping * pulsation * t) * (np.cos(angle) + damping / root * np.sin(angle))

    found = _step(answer)
    peak = 100.0 * math.exp(-math.pi * damping / root)
    assert found["position_overshoot"].value == pytest.approx(peak, rel=1e-5)  # the peak lies between two samples
    settled = found["position_settling_time"].value
    assert abs(answer(np.array(settled)) - 1.0) == pytest.approx(0.02, rel=1e-3)  # enters the band there
    later = np.linspace(settled + 1e-3, settled + 3.0, 5000)
    assert np.abs(answer(later) - 1.0).max() < 0.02


def test_a_course_that_does_not_settle_says_so():
    found = _step(lambda t: 1.0 + 0.1 * np.sin(20.0 * t))
    assert found["position_settling_time"].value is None
    assert "not reached" in found["position_settling_time"].note


def test_without_a_step_there_is_nothing_to_tell():
    wanted = np.sin(TIME)
    found = step_metrics(TIME, wanted, wanted, "rad", "position")
    assert all(metric.value is None for metric in found.values())


def test_bandwidth_of_a_first_order_lag():
    corner = 5.0
    time = np.linspace(0.0, 60.0, 60001)
    sweep = Chirp(0.0, 60.0, 0.0, 1.0, 0.1, 20.0)
    wanted = np.asarray(sweep.at(time).value)
    pole = 2.0 * math.pi * corner
    step = time[1]
    decay, real = math.exp(-pole * step), np.zeros_like(wanted)
    for k in range(1, time.size):  # exact for lines between the samples
        a, b = wanted[k - 1], wanted[k]
        slope = (b - a) / step
        real[k] = decay * real[k - 1] + a * (1.0 - decay) + slope * (step - (1.0 - decay) / pole)
    # a sweep of a minute resolves a fifth of a hertz or so
    assert bandwidth(time, wanted, real).value == pytest.approx(corner, rel=0.05)


def test_a_sine_has_no_bandwidth():
    assert bandwidth(TIME, np.sin(TIME), np.sin(TIME)).value is None
