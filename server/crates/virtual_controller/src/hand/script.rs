//! The tasks the virtual hand can show, as way-points in joint angles.
//!
//! All keep the wrist on the side with a negative joint 5, as people do who guide a GoFa: its
//! singular pose (joint 5 at 0) stays far away.

use std::str::FromStr;

/// A task.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Script {
    /// A piece is taken from a tray and put into a drilling machine; the gripper closes and opens.
    F1,
    /// The same, over an obstacle that stands between tray and machine.
    F2,
    /// The same with the piece turned by a quarter on its way.
    F3,
}

/// A place on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WayPoint {
    /// Joint angles, deg.
    pub joints_deg: [f64; 6],
    /// The hand stops here for a while, to grasp or to place.
    pub pause: bool,
    /// What is done to the gripper there: closed (`true`) or opened.
    pub closes: Option<bool>,
}

const fn through(joints_deg: [f64; 6]) -> WayPoint {
    WayPoint {
        joints_deg,
        pause: false,
        closes: None,
    }
}

const fn pause(joints_deg: [f64; 6]) -> WayPoint {
    WayPoint {
        joints_deg,
        pause: true,
        closes: None,
    }
}

const fn grip(joints_deg: [f64; 6], close: bool) -> WayPoint {
    WayPoint {
        joints_deg,
        pause: true,
        closes: Some(close),
    }
}

const F1: [WayPoint; 9] = [
    through([-8.0, 4.0, 28.0, 0.0, -48.0, 0.0]),
    through([-19.0, 17.0, 26.0, -7.0, -44.0, 4.0]),
    grip([-22.0, 27.0, 29.0, -9.0, -48.0, 4.0], true),
    through([-19.0, 16.0, 28.0, -7.0, -46.0, 0.0]),
    through([-3.0, 8.0, 25.0, 0.0, -40.0, -6.0]),
    through([14.0, 17.0, 26.0, 7.0, -44.0, -12.0]),
    grip([18.0, 26.0, 25.0, 10.0, -46.0, -14.0], false),
    through([14.0, 16.0, 27.0, 7.0, -46.0, -8.0]),
    through([4.0, 8.0, 28.0, 0.0, -49.0, 0.0]),
];

const F2: [WayPoint; 10] = [
    through([-8.0, 6.0, 28.0, 0.0, -48.0, 0.0]),
    through([-18.0, 18.0, 25.0, -7.0, -43.0, 4.0]),
    pause([-21.0, 27.0, 28.0, -9.0, -47.0, 4.0]),
    through([-18.0, 10.0, 23.0, -7.0, -40.0, 0.0]),
    through([-7.0, 2.0, 22.0, 0.0, -36.0, -4.0]),
    through([7.0, 2.0, 22.0, 4.0, -36.0, -6.0]),
    through([16.0, 10.0, 23.0, 9.0, -42.0, -10.0]),
    pause([19.0, 25.0, 25.0, 11.0, -47.0, -12.0]),
    through([15.0, 13.0, 26.0, 7.0, -46.0, -6.0]),
    through([5.0, 7.0, 29.0, 0.0, -49.0, 0.0]),
];

const F3: [WayPoint; 10] = [
    through([-6.0, 6.0, 26.0, 0.0, -46.0, 0.0]),
    through([-17.0, 20.0, 23.0, -7.0, -42.0, 0.0]),
    pause([-20.0, 28.0, 26.0, -9.0, -48.0, 0.0]),
    through([-17.0, 16.0, 24.0, -7.0, -45.0, 6.0]),
    through([-6.0, 11.0, 20.0, 0.0, -38.0, 50.0]),
    through([9.0, 18.0, 18.0, 5.0, -38.0, 90.0]),
    pause([13.0, 27.0, 17.0, 7.0, -43.0, 92.0]),
    through([10.0, 17.0, 20.0, 5.0, -44.0, 88.0]),
    through([4.0, 11.0, 23.0, 2.0, -46.0, 40.0]),
    through([0.0, 7.0, 26.0, 0.0, -47.0, 4.0]),
];

impl Script {
    /// The way from start to end; neither is a pause.
    #[must_use]
    pub fn way_points(self) -> &'static [WayPoint] {
        match self {
            Self::F1 => &F1,
            Self::F2 => &F2,
            Self::F3 => &F3,
        }
    }
}

impl FromStr for Script {
    type Err = ();

    fn from_str(name: &str) -> Result<Self, ()> {
        match name {
            "f1" => Ok(Self::F1),
            "f2" => Ok(Self::F2),
            "f3" => Ok(Self::F3),
            _ => Err(()),
        }
    }
}
