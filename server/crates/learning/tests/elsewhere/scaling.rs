//! A movement primitive that scales its forcing term by (G - y0), as the paper's
//! equation is printed. It exists to be compared with.
//!
//! It is fitted to the target divided by the taught (G - y0). The fit of a weight is
//! linear in its target and the forcing term is linear in the weights, so with the
//! same spring and basis functions its weights are ours over the taught (G - y0).

use learning::{
    Path,
    dmp::{Extent, MovementPrimitive},
};

pub struct Scaling {
    /// Its weights are for a (G - y0) of one degree.
    per_degree: MovementPrimitive,
}

impl Scaling {
    pub fn like(ours: &MovementPrimitive) -> Scaling {
        let gaps = ours.goal_deg.iter().zip(&ours.start_deg);
        let gains: Vec<f64> = gaps.map(|(goal, start)| 1.0 / (goal - start)).collect();
        Scaling {
            per_degree: scaled(ours, &gains),
        }
    }

    pub fn is_finite(&self) -> bool {
        let mut weights = self.per_degree.weights.iter().flatten();
        weights.all(|w| w.is_finite())
    }

    pub fn rollout(&self, start_deg: &[f64], goal_deg: &[f64]) -> Path {
        let gaps = goal_deg.iter().zip(start_deg);
        let gains: Vec<f64> = gaps.map(|(goal, start)| goal - start).collect();
        scaled(&self.per_degree, &gains)
            .rollout(start_deg, goal_deg, Extent::AsTaught)
            .unwrap()
    }
}

fn scaled(primitive: &MovementPrimitive, gains: &[f64]) -> MovementPrimitive {
    let mut scaled = primitive.clone();
    for (weights, gain) in scaled.weights.iter_mut().zip(gains) {
        for w in weights {
            *w *= gain;
        }
    }
    scaled
}
