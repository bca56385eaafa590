//! Regression against closed forms.

use super::*;

#[test]
fn one_component_is_linear_regression_with_its_residual_covariance() {
    let mixture = Mixture {
        weights: vec![1.0],
        means: vec![vec![2.0, 10.0, -5.0]],
        covariances: vec![vec![
            vec![4.0, 2.0, -1.0],
            vec![2.0, 3.0, 0.5],
            vec![-1.0, 0.5, 2.0],
        ]],
    };
    let regression = regress(&mixture, &[0.0, 2.0, 7.0]);
    for (t, row) in [0.0, 2.0, 7.0].into_iter().zip(regression.mean_deg.rows()) {
        assert!((row[0] - (10.0 + 0.5 * (t - 2.0))).abs() < 1e-12);
        assert!((row[1] - (-5.0 - 0.25 * (t - 2.0))).abs() < 1e-12);
    }
    for covariance in regression.covariance_deg2.rows() {
        for (found, expected) in covariance.iter().zip([2.0, 1.0, 1.0, 1.75]) {
            assert!((found - expected).abs() < 1e-12);
        }
    }
}

/// Two one-joint components with equal weight and time spread, seen half way
/// between them: each has a share of one half.
#[test]
fn half_way_between_two_components_is_the_mean_of_both() {
    let mixture = Mixture {
        weights: vec![0.5, 0.5],
        means: vec![vec![0.0, 10.0], vec![4.0, 30.0]],
        covariances: vec![
            vec![vec![1.0, 0.0], vec![0.0, 2.0]],
            vec![vec![1.0, 0.0], vec![0.0, 6.0]],
        ],
    };
    let regression = regress(&mixture, &[2.0]);
    assert!((regression.mean_deg.row(0)[0] - 20.0).abs() < 1e-12);
    // Law of total variance: mean of 2 and 6, plus the variance of 10 and 30.
    assert!((regression.covariance_deg2.row(0)[0] - (4.0 + 100.0)).abs() < 1e-9);
    assert!((regression.std_deg().row(0)[0] - 104f64.sqrt()).abs() < 1e-9);
}

#[test]
fn far_from_every_component_the_nearest_one_decides() {
    let mixture = Mixture {
        weights: vec![0.5, 0.5],
        means: vec![vec![0.0, 1.0], vec![1.0, 2.0]],
        covariances: vec![vec![vec![1e-4, 0.0], vec![0.0, 1.0]]; 2],
    };
    let regression = regress(&mixture, &[-50.0, 50.0]);
    assert!((regression.mean_deg.row(0)[0] - 1.0).abs() < 1e-12);
    assert!((regression.mean_deg.row(1)[0] - 2.0).abs() < 1e-12);
}
