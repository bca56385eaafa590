//! The answer of the spring to a step of the goal, stated once more and apart from
//! the product.
//!
//! A critically damped spring of rate p = alpha_z / (2 tau) is two first-order lags
//! of rate p in a row, and the goal's filter is a third of rate q = alpha_z / 6:
//!
//! ```text
//! g' = q (1 - g)      m' = p (g - m)      b' = p (m - b)      g(0) = m(0) = b(0) = 0
//! ```
//!
//! (m = y + y' / p turns the one form into the other.) The slope of b is the
//! probability density of a sum of three exponential waiting times, and b their
//! distribution: it rises from 0 to 1 and never turns back. The slope of two lags of
//! rate p is p² t exp(-p t), at most p / e, with a slope between -p² / e² and p²;
//! averaging by a third lag makes nothing larger. From b'' = q (s - b'), where s is
//! the slope after the two lags, follow the bounds on b'' and b'''.

use std::f64::consts::E;

use learning::{Path, dmp::MovementPrimitive};

use crate::motions::plus;

pub struct Response {
    p: f64,
    q: f64,
    dt_s: f64,
}

impl Response {
    pub fn of(primitive: &MovementPrimitive) -> Response {
        Response {
            p: primitive.alpha_z / (2.0 * primitive.tau_s),
            q: primitive.alpha_z / 6.0,
            dt_s: primitive.dt_s,
        }
    }

    /// b at the rows of a rollout; row i is the state after i + 1 steps.
    pub fn rows(&self, n: usize) -> Vec<f64> {
        let (mut g, mut m, mut b) = (0.0, 0.0, 0.0);
        (0..n)
            .map(|_| {
                b += self.p * (m - b) * self.dt_s;
                m += self.p * (g - m) * self.dt_s;
                g += self.q * (1.0 - g) * self.dt_s;
                b
            })
            .collect()
    }

    /// Bound on the magnitude of the `order`-th derivative of b, 1 to 3. Steps
    /// instead of a flow add at most the factor 1 / (1 - p dt)².
    pub fn bound(&self, order: u32) -> f64 {
        let (p, q) = (self.p, self.q);
        let flow = match order {
            1 => q.min(p / E),
            2 => (p * p).min(q * p / E),
            3 => q * p * p * (1.0 + (-2.0f64).exp()),
            _ => panic!("no bound of order {order}"),
        };
        flow / (1.0 - p * self.dt_s).powi(2)
    }
}

/// `taught` moved to a start and a goal elsewhere: each row plus
/// (1 - b) times the start's offset plus b times the goal's.
pub fn moved(
    taught: &Path,
    primitive: &MovementPrimitive,
    start_off_deg: &[f64],
    goal_off_deg: &[f64],
) -> Path {
    let b = Response::of(primitive).rows(taught.len());
    let rows = taught.rows().zip(&b).map(|(row, b)| {
        let offsets = start_off_deg.iter().zip(goal_off_deg);
        let transient: Vec<f64> = offsets.map(|(s, g)| (1.0 - b) * s + b * g).collect();
        plus(row, &transient)
    });
    Path::from_rows(taught.width(), rows)
}
