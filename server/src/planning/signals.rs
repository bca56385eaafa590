//! Signals of a planned motion: when each is set, and what people should know about how they
//! stand now. How they are set is the `robot` crate's.

use learning::Model;
use motion::plan::{Plan, PlanSignal};
use robot::SignalView;

use super::Warning;

/// Where a plan's parts lie in time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    /// Where the arm has come to rest at the start of the motion, seconds.
    pub at_start_s: f64,
    /// Where the motion proper begins, seconds.
    pub begins_s: f64,
    /// How many times slower than taught it is.
    pub stretch: f64,
    /// The end of the plan, seconds.
    pub ends_s: f64,
}

/// The signals of `model` on the plan's clock: first each as the demonstrations began with it
/// (the opposite of its first change), while the arm rests at the start; then the changes.
pub(super) fn of(model: &Model, course: Course) -> Vec<PlanSignal> {
    let changes = &model.signals;
    let begin = changes.iter().enumerate().filter_map(|(i, change)| {
        let is_first = changes[..i].iter().all(|before| before.name != change.name);
        is_first.then(|| PlanSignal {
            name: change.name.clone(),
            at_s: course.at_start_s,
            on: !change.on,
        })
    });
    let worked = changes.iter().map(|change| {
        let motion_s = change.phase * model.duration_s() * course.stretch;
        PlanSignal {
            name: change.name.clone(),
            at_s: (course.begins_s + motion_s).min(course.ends_s),
            on: change.on,
        }
    });
    begin.chain(worked).collect()
}

/// What people should know before this plan sets its signals, from how they stand now.
pub fn remarks(plan: &Plan, present: &[SignalView]) -> Vec<Warning> {
    let mut remarks = Vec::new();
    for (i, signal) in plan.signals().iter().enumerate() {
        if plan.signals()[..i]
            .iter()
            .any(|before| before.name == signal.name)
        {
            continue;
        }
        let known = present.iter().find(|view| view.signal.name == signal.name);
        match known {
            None => remarks.push(Warning::SignalUnknown {
                name: signal.name.clone(),
            }),
            Some(view) if view.is_on.is_some_and(|is_on| is_on != signal.on) => {
                let words = if signal.on {
                    &view.signal.on
                } else {
                    &view.signal.off
                };
                remarks.push(Warning::SignalStandsOtherwise {
                    label: view.signal.label.clone(),
                    does: words.clone(),
                });
            }
            Some(_) => {}
        }
    }
    remarks
}
