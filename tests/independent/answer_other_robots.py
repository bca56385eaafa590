"""Another robot-side program, made of the package ABBRobotEGM's messages, asks our server.

    python answer_other_robots.py PATH/TO/team

It plays controllers of both RobotWare generations: sessions, restarts, changes of the port, missing
fields, states in which nothing is guided, and bytes that are no messages. Each message that must be
answered has to be answered once, with the pose that the session holds, and the answers' numbers
have to rise by one.
"""

import random
import socket
import struct
import sys
import tempfile
import time

from ABBRobotEGM._egm_protobuf import egm_pb2

from peer import LOOPBACK, Program, Report, free_udp_port

SEED = 20
# Silence after which the server begins a session anew is 0.1 s; a script that was held up for
# about that long cannot know which of both the server did.
UNSURE_AFTER_S = 0.07
STRAYS_S = 0.05

DATA, CORRECTION = egm_pb2.EgmHeader.MSGTYPE_DATA, egm_pb2.EgmHeader.MSGTYPE_CORRECTION
RUNNING, STOPPED, ERROR = (
    egm_pb2.EgmMCIState.MCI_RUNNING,
    egm_pb2.EgmMCIState.MCI_STOPPED,
    egm_pb2.EgmMCIState.MCI_ERROR,
)


def message(number, joints, mci=RUNNING, mtype=DATA):
    """The least that a controller says: header, measured angles and states."""
    robot = egm_pb2.EgmRobot()
    robot.header.seqno = number % 2**32
    robot.header.tm = number * 4 % 2**32
    robot.header.mtype = mtype
    robot.feedBack.joints.joints.extend(joints)
    robot.motorState.state = egm_pb2.EgmMotorState.MOTORS_ON
    robot.mciState.state = mci
    robot.rapidExecState.state = egm_pb2.EgmRapidCtrlExecState.RAPID_RUNNING
    return robot


def add_common(robot, joints):
    """What both generations send besides."""
    robot.planned.joints.joints.extend(joints)
    for position in [robot.feedBack, robot.planned]:
        pose = position.cartesian
        pose.pos.x, pose.pos.y, pose.pos.z = 571.0, 0.0, 899.0
        pose.orient.u0, pose.orient.u1, pose.orient.u2, pose.orient.u3 = 1.0, 0.0, 0.0, 0.0
        pose.euler.x, pose.euler.y, pose.euler.z = 0.0, 90.0, 0.0
        now = time.time()
        position.time.sec, position.time.usec = int(now), int(now % 1 * 1e6)
    robot.mciConvergenceMet = False
    robot.testSignals.signals.extend([0.0] * 6)
    robot.utilizationRate = 3.5


def robotware_7(number, joints, mci=RUNNING):
    robot = message(number, joints, mci)
    add_common(robot, joints)
    for position in [robot.feedBack, robot.planned]:
        position.externalJoints.joints.extend([0.0] * 6)
        position.timeStamp.sec, position.timeStamp.nsec = 1, 2
    robot.measuredForce.fcActive = False
    robot.measuredForce.force.extend([0.5] * 6)
    robot.moveIndex = 2
    robot.CollisionInfo.collsionTriggered = False
    robot.CollisionInfo.collDetQuota.extend([0.0] * 6)
    robot.RAPIDfromRobot.digVal = True
    robot.RAPIDfromRobot.dnum.extend([1.5, 2.5])
    robot.torqueRef.joints.extend([0.0] * 6)
    return robot.SerializeToString()


def robotware_6(number, joints, mci=RUNNING):
    """The force's values are field 1 of field 9, which this package has no message for."""
    robot = message(number, joints, mci)
    add_common(robot, joints)
    force = b"".join(b"\x09" + struct.pack("<d", value) for value in [0.5] * 6)
    return robot.SerializePartialToString() + b"\x4a" + bytes([len(force)]) + force


def sparse(number, joints, mci=RUNNING):
    return message(number, joints, mci).SerializeToString()


GENERATIONS = {"RobotWare 7": robotware_7, "RobotWare 6": robotware_6, "sparse": sparse}


class Robot:
    """The robot's end of one line, and what the server has to answer."""

    def __init__(self, port, report):
        self.server = (LOOPBACK, port)
        self.report = report
        self.socket = None
        self.asked = self.answered = self.wrong = 0
        self.reopen()

    def reopen(self):
        """Goes on from another port: the server begins a session with the next message."""
        if self.socket:
            self.socket.close()
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind((LOOPBACK, 0))
        self.begin()

    def begin(self):
        """The next whole message begins a session."""
        self.number = 0
        self.expected_number = 0
        self.held = None
        self.last_sent = time.monotonic()

    def ask(self, datagram, held):
        """Sends what has to be answered with `held`."""
        self.asked += 1
        unsure = time.monotonic() - self.last_sent > UNSURE_AFTER_S
        self.last_sent = time.monotonic()
        self.socket.sendto(datagram, self.server)
        self.socket.settimeout(2.0)
        try:
            reply, source = self.socket.recvfrom(2048)
        except TimeoutError:
            self.complain("no answer")
            return
        self.answered += 1
        sensor = egm_pb2.EgmSensor()
        sensor.ParseFromString(reply)
        if source != self.server:
            self.complain(f"answered from {source}")
        if sensor.header.mtype != CORRECTION:
            self.complain(f"kind {sensor.header.mtype}")
        if sensor.header.seqno != self.expected_number and not (unsure and sensor.header.seqno == 0):
            self.complain(f"number {sensor.header.seqno} in place of {self.expected_number}")
        self.expected_number = sensor.header.seqno + 1
        if list(sensor.planned.joints.joints) != list(held) and not unsure:
            self.complain(f"{list(sensor.planned.joints.joints)} in place of {list(held)}")
        if any(sensor.speedRef.joints.joints) or len(sensor.speedRef.joints.joints) != 6:
            self.complain(f"speed {list(sensor.speedRef.joints.joints)}")

    def complain(self, what):
        self.wrong += 1
        if self.wrong < 10:
            print(f"      message {self.asked}: {what}")

    def say(self, make, joints, mci=RUNNING):
        """A whole message. Where nothing is guided, the held pose is the arm's own."""
        if self.held is None or mci != RUNNING:
            self.held = joints
        self.ask(make(self.number, joints, mci), self.held)
        self.number += 1

    def say_bytes(self, datagram):
        """Something that is no whole message, in the middle of a session: the server holds."""
        self.ask(datagram, self.held)

    def strays(self):
        """Answers that nobody asked for."""
        self.socket.settimeout(STRAYS_S)
        count = 0
        try:
            while True:
                self.socket.recvfrom(2048)
                count += 1
        except TimeoutError:
            # The wait itself is silence, in which the server may or may not have given up.
            self.begin()
            return count

    def phase(self, what, play):
        """Plays one phase as a session of its own and reports it."""
        self.reopen()
        before = (self.asked, self.wrong)
        play(self)
        strays = self.strays()
        good = self.wrong == before[1] and strays == 0
        self.report.check(what, good, f"{self.asked - before[0]} messages, {strays} too many answers")


def pose(chance):
    return [round(chance.uniform(-60.0, 60.0), 6) for _ in range(6)]


def whole_session(make, chance):
    def play(robot):
        start = pose(chance)
        for _ in range(250):
            # Nobody has asked for a motion: whatever the arm does, the reference stays.
            robot.say(make, [angle + chance.gauss(0, 0.01) for angle in start])

    return play


def restarts(make, chance):
    def play(robot):
        for _ in range(10):
            for _ in range(chance.randrange(2, 20)):
                robot.say(make, pose(chance))
            robot.begin()

    return play


def not_guided(make, chance):
    def play(robot):
        for mci in [STOPPED, RUNNING, ERROR, RUNNING, STOPPED]:
            for _ in range(20):
                robot.say(make, pose(chance), mci)

    return play


def changes_of_port(make, chance):
    def play(robot):
        for _ in range(10):
            for _ in range(5):
                robot.say(make, pose(chance))
            robot.reopen()

    return play


def wrap_of_the_number(make, chance):
    def play(robot):
        robot.number = 2**32 - 5
        for _ in range(10):
            robot.say(make, pose(chance))

    return play


def lost_messages(make, chance):
    def play(robot):
        for lost in [0, 0, 1, 0, 2, 0, 3, 0, 100] * 10:
            robot.say(make, pose(chance))
            robot.number += lost
            if lost == 100:
                # Nobody loses as many: it is another session, whose answers count anew.
                robot.held, robot.expected_number = None, 0

    return play


def unwhole(chance):
    """Messages and bytes that say too little, or nothing, amid whole ones."""
    five = message(1, [1.0] * 5)
    seven = message(1, [1.0] * 7)
    nan = message(1, [1.0, float("nan"), 1.0, 1.0, 1.0, 1.0])
    from_a_server = message(1, [1.0] * 6, mtype=CORRECTION)
    no_number = message(1, [1.0] * 6)
    no_number.header.ClearField("seqno")
    no_header = message(1, [1.0] * 6)
    no_header.ClearField("header")
    no_pose = message(1, [1.0] * 6)
    no_pose.ClearField("feedBack")
    odd = [five, seven, nan, from_a_server, no_number, no_header, no_pose]
    odd = [robot.SerializeToString() for robot in odd]
    odd += [b"", b"\x0a", b"\xff" * 40, robotware_7(1, [1.0] * 6)[:300], chance.randbytes(1400)]

    def play(robot):
        home = pose(chance)
        for datagram in odd * 3:
            robot.say(sparse, home)
            robot.say_bytes(datagram)
        robot.say(sparse, home)

    return play


def without_a_session(report, port):
    """What is no robot's message begins no session, and gets no answer."""
    no_robot = [b"", b"hello", message(0, [1.0] * 5).SerializeToString()]
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.bind((LOOPBACK, 0))
        stranger.settimeout(STRAYS_S)
        for datagram in no_robot:
            stranger.sendto(datagram, (LOOPBACK, port))
        try:
            stranger.recvfrom(2048)
            silent = False
        except TimeoutError:
            silent = True
    report.check("bytes of a stranger begin no session and get no answer", silent)


def play(report, port):
    chance = random.Random(SEED)
    without_a_session(report, port)
    robot = Robot(port, report)
    for name, make in GENERATIONS.items():
        for what, phase in [
            ("a session that holds its first pose", whole_session),
            ("restarts that count from 0", restarts),
            ("states in which nothing is guided", not_guided),
            ("changes of the port", changes_of_port),
            ("the number's wrap", wrap_of_the_number),
            ("lost messages", lost_messages),
        ]:
            robot.phase(f"{name}: {what}", phase(make, chance))
    robot.phase("messages that say too little, and no messages", unwhole(chance))
    report.check("every message was answered once", robot.asked == robot.answered, robot.answered)
    report.end({"asked": robot.asked, "answered": robot.answered, "wrong": robot.wrong})


def main():
    report, port = Report(), free_udp_port()
    with tempfile.TemporaryDirectory() as data:
        arguments = ["serve", "--listen", f"{LOOPBACK}:0", "--data", data]
        arguments += ["--robot", "none", "--egm-port", str(port)]
        with Program(sys.argv[1], arguments, "TEAM is ready"):
            play(report, port)


if __name__ == "__main__":
    main()
