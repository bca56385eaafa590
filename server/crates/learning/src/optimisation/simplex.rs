//! Minimisation without derivatives (Nelder and Mead) within bounds.

const ITERATIONS: usize = 200;
const TOLERANCE: f64 = 1e-6;
const FIRST_STEP: f64 = 1.0;

/// Point and value of a minimum of `cost` near `start`; every trial is clamped to
/// the bounds.
pub fn minimise<const N: usize>(
    cost: &dyn Fn(&[f64; N]) -> f64,
    start: [f64; N],
    bounds: &[(f64, f64); N],
) -> ([f64; N], f64) {
    let clamp =
        |p: [f64; N]| -> [f64; N] { std::array::from_fn(|i| p[i].clamp(bounds[i].0, bounds[i].1)) };
    let trial = |p: [f64; N]| {
        let p = clamp(p);
        (p, cost(&p))
    };
    let mut corners = vec![trial(start)];
    for i in 0..N {
        let mut corner = corners[0].0;
        // Step away from the bound that is near.
        corner[i] += if corner[i] + FIRST_STEP > bounds[i].1 {
            -FIRST_STEP
        } else {
            FIRST_STEP
        };
        corners.push(trial(corner));
    }
    for _ in 0..ITERATIONS {
        corners.sort_by(|a, b| a.1.total_cmp(&b.1));
        if (corners[N].1 - corners[0].1).abs() <= TOLERANCE {
            break;
        }
        let centre: [f64; N] =
            std::array::from_fn(|i| corners[..N].iter().map(|c| c.0[i]).sum::<f64>() / N as f64);
        let along = |factor: f64| {
            let worst = corners[N].0;
            trial(std::array::from_fn(|i| {
                centre[i] + factor * (centre[i] - worst[i])
            }))
        };
        let reflected = along(1.0);
        let replacement = if reflected.1 < corners[0].1 {
            let expanded = along(2.0);
            Some(if expanded.1 < reflected.1 {
                expanded
            } else {
                reflected
            })
        } else if reflected.1 < corners[N - 1].1 {
            Some(reflected)
        } else {
            let contracted = along(if reflected.1 < corners[N].1 {
                0.5
            } else {
                -0.5
            });
            (contracted.1 < corners[N].1.min(reflected.1)).then_some(contracted)
        };
        match replacement {
            Some(corner) => corners[N] = corner,
            None => {
                let best = corners[0].0;
                for corner in &mut corners[1..] {
                    *corner = trial(std::array::from_fn(|i| 0.5 * (best[i] + corner.0[i])));
                }
            }
        }
    }
    corners.sort_by(|a, b| a.1.total_cmp(&b.1));
    corners[0]
}
