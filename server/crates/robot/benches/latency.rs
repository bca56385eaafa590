//! How long a robot waits for its answer: the control thread beside a bare echo of the same sizes.
//!
//! `cargo bench -p robot --bench latency -- [SECONDS]`: for 1, 8 and 32 robots, with and without
//! real-time priority, while every core computes at the priority of a training. The two are asked
//! in turn within each cycle, so that whatever else the machine does meets both alike, and the
//! arrival is stamped by the kernel, so that the asking side's own waking up does not count.

mod load;

use egm::codec;
use egm::messages::{
    EgmFeedBack, EgmHeader, EgmJoints, EgmMciState, EgmMotorState, EgmRapidCtrlExecState, EgmRobot,
    EgmTestSignals, MciState, MessageType, MotorState, RapidExecState,
};
use nix::sys::socket::{ControlMessageOwned, MsgFlags, SockaddrIn, recvmsg, setsockopt, sockopt};
use nix::time::{ClockId, clock_gettime};
use robot::{Robot, RobotConfig, RobotKind};
use std::io::IoSliceMut;
use std::net::{Ipv4Addr, SocketAddr, UdpSocket};
use std::os::fd::AsRawFd;
use std::time::{Duration, Instant};

const CYCLE: Duration = Duration::from_micros(4_000);
/// As many test signals as bring the message to the size of a real controller's.
const FILLING: usize = 50;
/// Size of an answer.
const ANSWER_BYTES: usize = 160;
/// Joint 6 moves by this much from question to question.
const ANGLE_STEP_DEG: f64 = 1e-4;
const WAIT_FOR_THE_LAST: Duration = Duration::from_millis(500);
const LOCAL: SocketAddr = SocketAddr::new(std::net::IpAddr::V4(Ipv4Addr::LOCALHOST), 0);

fn main() {
    let seconds = load::argument(10.0);
    let runtime = load::runtime();
    let _load = load::Load::on_every_core();
    println!(
        "robots  priority  asked     unanswered  median us: robot  echo  ratio   99.9 %: robot  echo  ratio"
    );
    for robots in [1, 8, 32] {
        for real_time in [true, false] {
            measure(&runtime, robots, real_time, seconds);
        }
    }
}

fn measure(runtime: &tokio::runtime::Runtime, robots: usize, real_time: bool, seconds: f64) {
    let served: Vec<Robot> = (0..robots)
        .map(|_| {
            let mut config = RobotConfig::new(RobotKind::Virtual, LOCAL);
            config.real_time = real_time;
            runtime.block_on(Robot::start(config)).expect("a robot")
        })
        .collect();
    let is_real_time = real_time && {
        let view = served[0].view();
        runtime.block_on(async { tokio::time::sleep(Duration::from_millis(100)).await });
        view.borrow().egm.real_time
    };
    let echoes: Vec<SocketAddr> = (0..robots).map(|_| echo()).collect();
    let mut pairs: Vec<[Asker; 2]> = served
        .iter()
        .zip(&echoes)
        .map(|(robot, echo)| [Asker::new(robot.egm_addr()), Asker::new(*echo)])
        .collect();
    let cycles = (seconds / CYCLE.as_secs_f64()) as u32;
    let begin = Instant::now();
    for cycle in 0..cycles {
        for side in 0..2 {
            wait_until(begin + CYCLE * cycle + CYCLE / 2 * side as u32);
            for pair in &mut pairs {
                pair[side].ask(cycle);
            }
            for pair in &mut pairs {
                pair[1 - side].take_answers();
            }
        }
    }
    std::thread::sleep(WAIT_FOR_THE_LAST);
    let mut sides = [Vec::new(), Vec::new()];
    let (mut asked, mut answered) = (0, 0);
    for pair in &mut pairs {
        for (asker, all) in pair.iter_mut().zip(&mut sides) {
            asker.take_answers();
            all.append(&mut asker.waits_us);
        }
        asked += pair[0].asked_ns.len();
    }
    answered += sides[0].len();
    let [robot, echo] = sides.map(|mut waits| {
        waits.sort_by(f64::total_cmp);
        [0.5, 0.999].map(|share| waits[((waits.len() - 1) as f64 * share) as usize])
    });
    println!(
        "{robots:6}  {:8}  {asked:8}  {:10}  {:16.0}  {:4.0}  {:5.2}  {:14.0}  {:4.0}  {:5.2}",
        if is_real_time { "FIFO" } else { "raised" },
        asked - answered,
        robot[0],
        echo[0],
        robot[0] / echo[0],
        robot[1],
        echo[1],
        robot[1] / echo[1],
    );
    for robot in served {
        runtime.block_on(robot.shutdown());
    }
}

fn wait_until(at: Instant) {
    std::thread::sleep(at.saturating_duration_since(Instant::now()));
}

/// Answers every datagram at once with as many bytes as the control loop does.
fn echo() -> SocketAddr {
    let socket = UdpSocket::bind(LOCAL).expect("a port");
    socket
        .set_read_timeout(Some(Duration::from_secs(2)))
        .expect("a time-out");
    let address = socket.local_addr().expect("an address");
    std::thread::spawn(move || {
        let mut datagram = [0; 2048];
        // It ends when nobody has asked for a while.
        while let Ok((_, source)) = socket.recv_from(&mut datagram) {
            let _ = socket.send_to(&datagram[..ANSWER_BYTES], source);
        }
    });
    address
}

/// One robot's side of the line.
struct Asker {
    socket: UdpSocket,
    asked_ns: Vec<i128>,
    waits_us: Vec<f64>,
    message: Vec<u8>,
}

impl Asker {
    fn new(server: SocketAddr) -> Self {
        let socket = UdpSocket::bind(LOCAL).expect("a port");
        socket.connect(server).expect("a server");
        setsockopt(&socket, sockopt::ReceiveTimestampns, &true).expect("arrival times");
        Self {
            socket,
            asked_ns: Vec::new(),
            waits_us: Vec::new(),
            message: Vec::new(),
        }
    }

    fn ask(&mut self, cycle: u32) {
        self.message.clear();
        codec::encode_robot(&message(cycle), &mut self.message).expect("a message");
        self.asked_ns.push(now_ns());
        self.socket.send(&self.message).expect("the line");
    }

    /// Takes what has come. Which question an answer is to stands in it: while nothing is applied
    /// the control loop answers with the measured pose. The echo answers all, in order.
    fn take_answers(&mut self) {
        let mut bytes = [0; 2048];
        let mut space = nix::cmsg_space!(nix::sys::time::TimeSpec);
        loop {
            let mut parts = [IoSliceMut::new(&mut bytes)];
            let fd = self.socket.as_raw_fd();
            let flags = MsgFlags::MSG_DONTWAIT;
            let Ok(got) = recvmsg::<SockaddrIn>(fd, &mut parts, Some(&mut space), flags) else {
                return;
            };
            let arrived = got.cmsgs().expect("no cut").find_map(|part| match part {
                ControlMessageOwned::ScmTimestampns(time) => {
                    Some(i128::from(time.tv_sec()) * 1_000_000_000 + i128::from(time.tv_nsec()))
                }
                _ => None,
            });
            let length = got.bytes;
            let question = codec::decode_sensor(&bytes[..length])
                .ok()
                .and_then(|answer| answer.planned?.joints?.joints.last().copied())
                .map_or(self.waits_us.len(), |angle| {
                    (angle / ANGLE_STEP_DEG).round() as usize
                });
            let asked_ns = self.asked_ns[question];
            let wait_ns = arrived.expect("a stamp of the kernel") - asked_ns;
            self.waits_us.push(wait_ns as f64 / 1e3);
        }
    }
}

fn now_ns() -> i128 {
    let now = clock_gettime(ClockId::CLOCK_REALTIME).expect("a clock");
    i128::from(now.tv_sec()) * 1_000_000_000 + i128::from(now.tv_nsec())
}

/// A robot that is moved by hand and tells its pose: joint 6 counts the questions.
fn message(cycle: u32) -> EgmRobot {
    EgmRobot {
        header: Some(EgmHeader {
            seqno: Some(cycle),
            tm: Some(cycle * 4),
            mtype: Some(MessageType::Data as i32),
        }),
        feed_back: Some(EgmFeedBack {
            joints: Some(EgmJoints {
                joints: vec![
                    0.0,
                    10.0,
                    20.0,
                    0.0,
                    -45.0,
                    f64::from(cycle) * ANGLE_STEP_DEG,
                ],
            }),
            ..EgmFeedBack::default()
        }),
        motor_state: Some(EgmMotorState {
            state: MotorState::MotorsOn as i32,
        }),
        mci_state: Some(EgmMciState {
            state: MciState::Stopped as i32,
        }),
        rapid_exec_state: Some(EgmRapidCtrlExecState {
            state: RapidExecState::Running as i32,
        }),
        test_signals: Some(EgmTestSignals {
            signals: vec![0.0; FILLING],
        }),
        ..EgmRobot::default()
    }
}
