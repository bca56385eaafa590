"""Another vendor-neutral EGM server, the package ABBRobotEGM, drives the virtual robot.

    python drive_virtual_robot.py PATH/TO/team

It moves joint 1 through a sine, once with positions alone and once with the speed as well, and
measures from the feedback how much later the arm goes through the sine. It also checks that every
message is read whole by that package, of both message generations.
"""

import math
import sys
import time

import numpy as np
from ABBRobotEGM import EGM

from peer import LOOPBACK, Program, Report, free_udp_port

AMPLITUDE_DEG = 4.0
FREQUENCY_HZ = 0.25
PERIODS = 3
# The controller's position gain k, 1/s.
GAIN = 5.0


class Guided:
    """One run of the virtual robot under an EGM server."""

    def __init__(self, program, *options):
        self.port = free_udp_port()
        egm = f"{LOOPBACK}:{self.port}"
        arguments = ["virtual-robot", "--egm", egm, "--rws", f"{LOOPBACK}:0", "--run", *options]
        self.program = Program(program, arguments, "The virtual robot is ready")

    def __enter__(self):
        # The port has to be open first: the robot stops its program when nobody listens.
        self.egm = EGM(self.port)
        self.program.__enter__()
        return self

    def __exit__(self, *_):
        self.program.__exit__()
        self.egm.close()

    def messages(self, duration_s):
        """The robot's messages for some time after the first: seconds since then, and the message.

        Of several that wait only the newest is given. The robot takes one answer per cycle, so
        that whoever answers all of them after a pause stays behind by as many cycles for good.
        """
        first = None
        while first is None or time.monotonic() - first < duration_s:
            arrived, state, _ = self.egm.receive_latest(timeout=10.0)
            if not arrived:
                raise RuntimeError("no message for 10 s\n" + self.program.output())
            now = time.monotonic()
            first = now if first is None else first
            yield now - first, state


def sine(t_s):
    phase = 2 * math.pi * FREQUENCY_HZ * t_s
    return (
        AMPLITUDE_DEG * math.sin(phase),
        AMPLITUDE_DEG * 2 * math.pi * FREQUENCY_HZ * math.cos(phase),
    )


def lag_s(times_s, angles_deg):
    """How much later a sine of known frequency goes through the samples, by least squares."""
    phase = 2 * math.pi * FREQUENCY_HZ * np.array(times_s)
    basis = np.column_stack([np.sin(phase), np.cos(phase), np.ones_like(phase)])
    (in_phase, quadrature, _), *_ = np.linalg.lstsq(basis, np.array(angles_deg), rcond=None)
    return math.atan2(-quadrature, in_phase) / (2 * math.pi * FREQUENCY_HZ)


def follow_sine(program, with_speed):
    """Drives joint 1; returns its lag, the numbers of the messages, and the range of angles."""
    times_s, angles_deg, numbers = [], [], []
    with Guided(program) as robot:
        home = None
        for t_s, state in robot.messages((PERIODS + 1) / FREQUENCY_HZ):
            angles = np.array(state.joint_angles)
            home = angles if home is None else home
            offset_deg, speed_deg_s = sine(t_s)
            target, speed = home.copy(), np.zeros(6)
            target[0] += offset_deg
            speed[0] = speed_deg_s
            robot.egm.send_to_robot(target, speed_ref=speed if with_speed else None)
            numbers.append(state.robot_message.header.seqno)
            # The first period is left out: the arm has to get into the swing.
            if t_s >= 1 / FREQUENCY_HZ:
                times_s.append(t_s)
                angles_deg.append(angles[0] - home[0])
    return lag_s(times_s, angles_deg), numbers, max(angles_deg) - min(angles_deg)


def read_whole(report, program, generation, newer_fields):
    """Every field of a message is where the other program expects it."""
    with Guided(program, "--messages", generation) as robot:
        count = 0
        for _, state in robot.messages(1.0):
            robot.egm.send_to_robot(np.array(state.joint_angles))
            count += 1
    message = state.robot_message
    report.check(f"{generation}: messages in a second", count > 100, count)
    report.check(f"{generation}: size in bytes", message.ByteSize() > 300, message.ByteSize())
    report.check(f"{generation}: no required field is missing", message.IsInitialized())
    for name, joints in [("measured", state.joint_angles), ("planned", state.joint_angles_planned)]:
        report.check(f"{generation}: six {name} angles", len(joints) == 6)
    for name, pose in [("measured", state.cartesian), ("planned", state.cartesian_planned)]:
        report.check(f"{generation}: a {name} pose", pose is not None and len(pose.pos) == 3)
    report.check(f"{generation}: motors on", state.motors_on is True)
    report.check(f"{generation}: program running", state.rapid_running is True)
    followed = message.mciState.state == message.mciState.MCI_RUNNING
    report.check(f"{generation}: references are followed", followed)
    report.check(f"{generation}: time of measurement", state.clock is not None)
    report.check(f"{generation}: time of the plan", state.planned_clock is not None)
    report.check(f"{generation}: utilisation", state.utilization_rate is not None)
    for field in ["moveIndex", "CollisionInfo", "RAPIDfromRobot", "torqueRef"]:
        there = message.HasField(field)
        report.check(f"{generation}: {field} {'there' if newer_fields else 'absent'}", there == newer_fields)
    # The old force has its values where the new one has a flag, which this package skips.
    forces = len(message.measuredForce.force)
    report.check(f"{generation}: force values in the new place", forces == (6 if newer_fields else 0), forces)


def main():
    program = sys.argv[1]
    report = Report()
    read_whole(report, program, "rw7", True)
    read_whole(report, program, "rw6", False)
    omega = 2 * math.pi * FREQUENCY_HZ
    # A first-order lag with time constant 1/k, at this frequency.
    predicted_s = math.atan(omega / GAIN) / omega
    figures = {"predicted_lag_s": round(predicted_s, 4)}
    for with_speed, name in [(False, "positions"), (True, "positions_and_speeds")]:
        lag, numbers, swing = follow_sine(program, with_speed)
        figures[f"lag_s_{name}"] = round(lag, 4)
        figures[f"messages_{name}"] = len(numbers)
        rising = all(earlier < later for earlier, later in zip(numbers, numbers[1:]))
        report.check(f"{name}: the messages come in their order", rising, len(numbers))
        report.check(f"{name}: the arm swings", swing > AMPLITUDE_DEG, f"{swing:.2f} deg")
        if with_speed:
            report.check("with the speed the lag is below 20 ms", 0.0 < lag < 0.020, f"{lag * 1e3:.1f} ms")
        else:
            near = abs(lag - predicted_s) < 0.030
            report.check("positions alone lag by what the gain predicts", near, f"{lag:.3f} s of {predicted_s:.3f} s")
    report.end(figures)


if __name__ == "__main__":
    main()
