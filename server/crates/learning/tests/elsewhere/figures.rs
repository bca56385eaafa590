//! The figures of docs/goals.md: how a motion changes when the goal of one joint
//! is moved, here and with a primitive that scales. Printed with `--nocapture`.

use std::ops::ControlFlow;
use std::path::PathBuf;

use learning::{
    Demonstration, Path, TrainingParams,
    dmp::{Extent, MovementPrimitive},
    read, train,
};

use crate::{
    motions::{Motion, Reach, apart, peak, plus},
    moved_by,
    response::moved,
    scaling::Scaling,
    unmoved,
};

const RECORDINGS: [&str; 5] = [
    "T1_opening",
    "T2_brush_picking_up",
    "T4_brush_homing",
    "F1_drill",
    "F2_avoid",
];

/// Pick and place of six joints: joint 1 goes for good, 2 and 3 dip twice, 4 ends
/// where it began, 5 nearly so, and 6 turns.
fn pick_and_place() -> Motion {
    let reaches = |list: &[(f64, f64, f64)]| {
        list.iter()
            .map(|&(begin, lasts, by_deg)| Reach {
                begin,
                lasts,
                by_deg,
            })
            .collect()
    };
    Motion {
        duration_s: 10.0,
        start_deg: vec![-20.0, 10.0, 28.0, 0.0, -48.0, 0.0],
        joints: vec![
            reaches(&[(0.25, 0.4, 38.0)]),
            reaches(&[(0.05, 0.2, 15.0), (0.25, 0.2, -12.0), (0.6, 0.3, 12.0)]),
            reaches(&[(0.05, 0.2, 4.0), (0.25, 0.2, -8.0), (0.6, 0.3, 6.0)]),
            reaches(&[(0.1, 0.3, -9.0), (0.5, 0.35, 9.0)]),
            reaches(&[(0.1, 0.3, 10.0), (0.45, 0.4, -9.5)]),
            reaches(&[(0.3, 0.4, 60.0)]),
        ],
    }
}

fn takes_of(task: &str) -> Option<Vec<Demonstration>> {
    let folder = PathBuf::from(std::env::var_os("TEAM_PAPER_DATA")?).join("paper");
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder.join(task))
        .unwrap()
        .map(|file| file.unwrap().path())
        .collect();
    files.sort();
    let take = |file: &PathBuf| {
        let name = file.file_name().unwrap().to_string_lossy();
        read::from_str(&name, &std::fs::read_to_string(file).unwrap()).unwrap()
    };
    Some(files.iter().map(take).collect())
}

/// The largest over all moves. Rates are shares of the taught motion's largest.
#[derive(Default)]
struct Worst {
    shape_deg: f64,
    speed: f64,
    acceleration: f64,
    scaling_shape_deg: f64,
    scaling_speed: f64,
    mirrored: usize,
}

/// Offsets of start and goal.
type Move = (Vec<f64>, Vec<f64>);

/// The goal of each joint moved alone by `off_deg`, up and down.
fn one_goal(d: usize, off_deg: f64) -> Vec<Move> {
    let alone = |j: usize, by: f64| {
        let mut off = vec![0.0; d];
        off[j] = by;
        (vec![0.0; d], off)
    };
    (0..d)
        .flat_map(|j| [alone(j, off_deg), alone(j, -off_deg)])
        .collect()
}

/// All joints at once: starts moved by 20 deg, goals by 30 deg the other way, in both
/// directions.
fn all_ends(d: usize) -> Vec<Move> {
    [1.0, -1.0]
        .map(|sign| (vec![-20.0 * sign; d], vec![30.0 * sign; d]))
        .into()
}

fn worst(p: &MovementPrimitive, moves: &[Move]) -> Worst {
    let (taught, scaling) = (unmoved(p), Scaling::like(p));
    let d = taught.width();
    let peak_of = |path: &Path, order| (0..d).map(|j| peak(path, j, order)).fold(0.0, f64::max);
    let most = |a: &mut f64, b: f64| *a = f64::max(*a, b);
    let mut worst = Worst::default();
    for (start_off, goal_off) in moves {
        let path = moved_by(p, start_off, goal_off, Extent::AsTaught);
        let expected = moved(&taught, p, start_off, goal_off);
        let (start, goal) = (plus(&p.start_deg, start_off), plus(&p.goal_deg, goal_off));
        let scaled = scaling.rollout(&start, &goal);
        let ratio = |path: &Path, order| peak_of(path, order) / peak_of(&taught, order);
        most(&mut worst.shape_deg, apart(&path, &expected));
        most(&mut worst.speed, ratio(&path, 1));
        most(&mut worst.acceleration, ratio(&path, 2));
        most(&mut worst.scaling_shape_deg, apart(&scaled, &expected));
        most(&mut worst.scaling_speed, ratio(&scaled, 1));
        let sides =
            (0..d).filter(|&j| (goal[j] - start[j]) * (p.goal_deg[j] - p.start_deg[j]) < 0.0);
        worst.mirrored += sides.count();
    }
    worst
}

fn print(task: &str, moved: &str, w: &Worst) {
    println!(
        "| {task} | {moved} | {:.0e} | {:.2} | {:.2} | {:.0} | {:.1} | {} |",
        w.shape_deg, w.speed, w.acceleration, w.scaling_shape_deg, w.scaling_speed, w.mirrored
    );
}

#[test]
fn a_goal_of_one_joint_moved_changes_nothing_but_the_way_there() {
    let synthetic = pick_and_place();
    let takes =
        [(1.0, 0.0), (1.1, 0.8), (0.9, -0.8)].map(|(pace, sway)| synthetic.take(pace, sway));
    let mut tasks = vec![("pick and place", takes.to_vec())];
    for task in RECORDINGS {
        match takes_of(task) {
            Some(takes) => tasks.push((task, takes)),
            None => println!("{task} left out: TEAM_PAPER_DATA is not set"),
        }
    }
    for (task, takes) in tasks {
        let params = TrainingParams::faithful(1);
        let model = train(task, &takes, &params, &|_| ControlFlow::Continue(())).unwrap();
        let p = &model.primitive;
        println!("{task}: {:.1} s, alpha_z {}", model.duration_s(), p.alpha_z);
        for off_deg in [5.0, 15.0, 30.0] {
            let w = worst(p, &one_goal(model.joints(), off_deg));
            print(task, &format!("one goal, {off_deg}°"), &w);
            assert!(w.shape_deg < 1e-9, "{task}: {}", w.shape_deg);
            assert!(w.scaling_shape_deg > off_deg / 10.0);
        }
        let w = worst(p, &all_ends(model.joints()));
        print(task, "all starts and goals", &w);
        assert!(w.shape_deg < 1e-9, "{task}: {}", w.shape_deg);
    }
}
