//! Two phones at one robot.

use super::*;

fn phone(name: &str) -> Phone {
    Phone {
        id: name.to_lowercase(),
        name: name.to_owned(),
    }
}

/// Two phones that watch, and the time.
struct Table {
    control: Control,
    anna: Phone,
    ben: Phone,
    begin: Instant,
    watching: Vec<Watching>,
}

impl Table {
    fn new() -> Self {
        let control = Control::default();
        let (anna, ben) = (phone("Anna"), phone("Ben"));
        let watching = vec![control.watch(&anna), control.watch(&ben)];
        Self {
            control,
            anna,
            ben,
            begin: Instant::now(),
            watching,
        }
    }

    fn resting(&self, after_s: u64) -> Moment {
        Moment {
            now: self.begin + Duration::from_secs(after_s),
            in_use: false,
        }
    }

    fn in_use(&self, after_s: u64) -> Moment {
        Moment {
            in_use: true,
            ..self.resting(after_s)
        }
    }

    fn holder(&self, moment: Moment) -> Option<String> {
        self.control.view(moment).map(|view| view.phone.name)
    }
}

#[test]
fn who_uses_a_free_robot_has_it_and_nobody_else_can_move_it() {
    let table = Table::new();
    let at = table.resting(0);
    assert_eq!(table.holder(at), None);
    table.control.claim(Some(&table.anna), at).unwrap();
    table.control.claim(Some(&table.anna), at).unwrap();
    let refusal = ControlError::Controlled {
        name: "Anna".to_owned(),
    };
    assert_eq!(
        table.control.claim(Some(&table.ben), at),
        Err(refusal.clone())
    );
    assert_eq!(table.control.claim(None, at), Err(refusal));
}

#[test]
fn a_line_system_uses_a_free_robot_without_keeping_it() {
    let table = Table::new();
    let at = table.resting(0);
    table.control.claim(None, at).unwrap();
    assert_eq!(table.holder(at), None);
    table.control.claim(Some(&table.ben), at).unwrap();
}

#[test]
fn the_holder_gives_it_to_who_asks_or_keeps_it() {
    let table = Table::new();
    let at = table.resting(0);
    table.control.claim(Some(&table.anna), at).unwrap();
    table.control.ask(&table.ben, at);
    let asked = table.control.view(at).unwrap().asked_by;
    assert_eq!(asked, Some(table.ben.clone()));
    assert_eq!(
        table.control.answer(&table.ben, true, at),
        Err(ControlError::NotYours)
    );
    table.control.answer(&table.anna, false, at).unwrap();
    assert_eq!(table.control.view(at).unwrap().asked_by, None);
    table.control.ask(&table.ben, at);
    table.control.answer(&table.anna, true, at).unwrap();
    assert_eq!(table.holder(at).unwrap(), "Ben");
}

#[test]
fn a_question_without_an_answer_is_granted_only_when_the_arm_rests() {
    let table = Table::new();
    table
        .control
        .claim(Some(&table.anna), table.resting(0))
        .unwrap();
    table.control.ask(&table.ben, table.in_use(1));
    assert_eq!(table.holder(table.in_use(100)).unwrap(), "Anna");
    assert_eq!(table.holder(table.resting(101)).unwrap(), "Ben");

    let table = Table::new();
    table
        .control
        .claim(Some(&table.anna), table.resting(0))
        .unwrap();
    table.control.ask(&table.ben, table.resting(1));
    assert_eq!(table.holder(table.resting(15)).unwrap(), "Anna");
    assert_eq!(table.holder(table.resting(22)).unwrap(), "Ben");
}

#[test]
fn a_phone_that_leaves_keeps_an_arm_that_moves_and_frees_one_that_rests() {
    let mut table = Table::new();
    table
        .control
        .claim(Some(&table.anna), table.resting(0))
        .unwrap();
    table.watching.remove(0);
    assert_eq!(table.holder(table.in_use(1)).unwrap(), "Anna");
    assert_eq!(table.holder(table.resting(2)), None);
}

#[test]
fn a_robot_that_is_not_used_becomes_free() {
    let table = Table::new();
    table
        .control
        .claim(Some(&table.anna), table.resting(0))
        .unwrap();
    assert_eq!(table.holder(table.resting(119)).unwrap(), "Anna");
    assert_eq!(table.holder(table.in_use(300)).unwrap(), "Anna");
    assert_eq!(table.holder(table.resting(419)).unwrap(), "Anna");
    assert_eq!(table.holder(table.resting(421)), None);
}

#[test]
fn released_it_goes_to_who_waits() {
    let table = Table::new();
    let at = table.resting(0);
    table.control.claim(Some(&table.anna), at).unwrap();
    table.control.ask(&table.ben, at);
    table.control.release(&table.anna, at).unwrap();
    assert_eq!(table.holder(at).unwrap(), "Ben");
    table.control.release(&table.ben, at).unwrap();
    assert_eq!(table.holder(at), None);
}
