//! Made-up demonstrations: one motion, shown with a person's variation from take to take.
//!
//! They are uploaded where a test needs a trained model and not the hand that shows it.

use std::fmt::Write as _;

/// One take: times in seconds, rows of joint angles in degrees.
pub struct Take {
    pub t_s: Vec<f64>,
    pub joints_deg: Vec<[f64; 6]>,
}

/// Stations of the motion in degrees: lift, swing over, set down. They begin near the virtual arm's
/// home, lie within the GoFa's ranges and stay on one side of the wrist's singular pose.
const STATIONS: [[f64; 6]; 4] = [
    [2.0, 10.0, 22.0, 1.0, -46.0, 2.0],
    [4.0, 4.0, 17.0, 4.0, -50.0, 8.0],
    [14.0, 6.0, 15.0, -3.0, -55.0, 16.0],
    [17.0, 14.0, 20.0, 2.0, -49.0, 22.0],
];

/// Take number `number` of the motion, about `seconds` long, sampled at about 100 Hz.
///
/// The takes differ in pace and in the path between the ends, smoothly and always in the same way.
#[must_use]
pub fn take(number: u32, seconds: f64) -> Take {
    let n = f64::from(number);
    let seconds = seconds * (1.0 + 0.08 * (1.7 * n).sin());
    let samples = (seconds * 100.0).ceil() as u32;
    let (mut t_s, mut joints_deg) = (Vec::new(), Vec::new());
    for sample in 0..=samples {
        let share = f64::from(sample) / f64::from(samples);
        t_s.push(share * seconds);
        let bend = (std::f64::consts::PI * share).sin();
        let place = along(share + 0.03 * bend * (2.3 * n).sin());
        joints_deg.push(std::array::from_fn(|joint| {
            let j = joint as f64;
            place[joint] + 0.5 * bend * (2.0 * n + j).sin() + 0.2 * (0.9 * n + 1.3 * j).cos()
        }));
    }
    Take { t_s, joints_deg }
}

/// The motion at a share of its duration: at rest at every station.
fn along(share: f64) -> [f64; 6] {
    let legs = (STATIONS.len() - 1) as f64;
    let at = (share.clamp(0.0, 1.0) * legs).min(legs - 1e-9);
    let (leg, u) = (at as usize, at.fract());
    let eased = u * u * u * (10.0 + u * (6.0 * u - 15.0));
    std::array::from_fn(|joint| {
        let (from, to) = (STATIONS[leg][joint], STATIONS[leg + 1][joint]);
        from + (to - from) * eased
    })
}

impl Take {
    /// As a CSV file with a header.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut text = String::from("t_s,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n");
        for (t_s, row) in self.t_s.iter().zip(&self.joints_deg) {
            // Writing into a String cannot fail.
            let _ = write!(text, "{t_s:.4}");
            for angle in row {
                let _ = write!(text, ",{angle:.5}");
            }
            text.push('\n');
        }
        text
    }
}
