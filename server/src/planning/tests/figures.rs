//! The figures of docs/goals.md on time: how much longer a motion takes when its goal
//! is moved. Read from the published recordings in the folder that TEAM_PAPER_DATA
//! names, left out without it; printed with `--nocapture`.

use std::path::PathBuf;

use learning::read;
use rayon::prelude::*;

use super::*;

const TASKS: [&str; 5] = [
    "T1_opening",
    "T2_brush_picking_up",
    "T4_brush_homing",
    "F1_drill",
    "F2_avoid",
];

fn recorded(task: &str) -> Option<Model> {
    let folder = PathBuf::from(std::env::var_os("TEAM_PAPER_DATA")?).join("paper");
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder.join(task))
        .unwrap()
        .map(|file| file.unwrap().path())
        .collect();
    files.sort();
    let takes: Vec<Demonstration> = files
        .iter()
        .map(|file| {
            let name = file.file_name().unwrap().to_string_lossy();
            read::from_str(&name, &std::fs::read_to_string(file).unwrap()).unwrap()
        })
        .collect();
    let params = TrainingParams::faithful(1);
    Some(learning::train(task, &takes, &params, &|_| ControlFlow::Continue(())).unwrap())
}

#[test]
fn a_recorded_motion_with_a_goal_elsewhere_runs_within_the_limits_or_names_the_joint() {
    TASKS.par_iter().for_each(|task| {
        let Some(model) = recorded(task) else {
            println!("{task} left out: TEAM_PAPER_DATA is not set");
            return;
        };
        let as_it_is = plan(&model, &as_taught(), None, &limits()).unwrap();
        for off_deg in [5.0, 15.0, 30.0] {
            let (mut longest, mut refused) = (0.0, Vec::new());
            for j in 0..JOINTS {
                for by in [off_deg, -off_deg] {
                    let mut goal = as_it_is.goal;
                    goal.0[j] += by;
                    let request = PlanRequest {
                        goal: Target::Joints(goal),
                        ..as_taught()
                    };
                    match plan(&model, &request, None, &limits()) {
                        Ok(planned) => {
                            let ratio = planned.plan.duration_s() / as_it_is.plan.duration_s();
                            longest = f64::max(longest, ratio);
                            assert!(planned.plan.last().max_abs_difference(&goal) < 1e-9);
                        }
                        Err(error) => {
                            assert_eq!(error.code(), "outside_joint_range");
                            refused.push(format!("{by:+} on joint {}: {error}", j + 1));
                        }
                    }
                }
            }
            println!(
                "{task}: slowed by {:.2} as taught; goal {off_deg}°: {longest:.2} times longer; refused: {refused:?}",
                as_it_is.slowed_by
            );
        }
    });
}
