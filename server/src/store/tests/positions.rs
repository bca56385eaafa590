//! Saved positions: names that are one robot's, and what is left of a deleted one.

use super::super::Error;
use super::{NOW, store};
use crate::ids::PositionId;

const POSE: [f64; 6] = [1.0, -2.5, 3.0, 4.0, 5.0, 6.0];

#[tokio::test]
async fn a_position_is_saved_once_and_listed_by_name_for_its_robot() {
    let (store, _folder) = store().await;
    let id = PositionId::new();
    let save = |id, robot, name| store.save_position(id, robot, name, POSE, NOW);
    let (saved, made) = save(id, "left", "Fixture").await.unwrap();
    assert!(made);
    assert_eq!((saved.name.as_str(), saved.joints_deg), ("Fixture", POSE));
    let (again, made) = save(id, "left", "Other name").await.unwrap();
    assert_eq!(
        (again, made),
        (saved, false),
        "a repeated request is the same position"
    );
    save(PositionId::new(), "left", "bin").await.unwrap();
    save(PositionId::new(), "right", "Fixture").await.unwrap();
    let names = |list: Vec<super::super::positions::Position>| -> Vec<String> {
        list.into_iter().map(|one| one.name).collect()
    };
    let left = store.positions(Some("left")).await.unwrap();
    assert_eq!(names(left), ["bin", "Fixture"]);
    assert_eq!(store.positions(None).await.unwrap().len(), 3);
}

#[tokio::test]
async fn two_positions_of_one_robot_can_not_be_taken_for_each_other() {
    let (store, _folder) = store().await;
    let (first, second) = (PositionId::new(), PositionId::new());
    let save = |id, name| store.save_position(id, "left", name, POSE, NOW);
    save(first, "Fixture").await.unwrap();
    let taken = save(second, "fixture").await;
    assert!(matches!(taken, Err(Error::NameTaken { .. })));
    save(second, "Bin").await.unwrap();
    let renamed = store.change_position(second, Some("FIXTURE"), None).await;
    assert!(matches!(renamed, Err(Error::NameTaken { .. })));
    assert_eq!(store.position(second).await.unwrap().name, "Bin");
    store.delete_position(first, NOW).await.unwrap();
    let renamed = store.change_position(second, Some("Fixture"), None).await;
    assert_eq!(renamed.unwrap().name, "Fixture", "the name is free again");
}

#[tokio::test]
async fn changes_touch_only_what_they_name_and_a_deleted_position_is_known_but_fixed() {
    let (store, _folder) = store().await;
    let id = PositionId::new();
    store
        .save_position(id, "left", "Bin", POSE, NOW)
        .await
        .unwrap();
    let moved = store
        .change_position(id, None, Some([9.0; 6]))
        .await
        .unwrap();
    assert_eq!((moved.name.as_str(), moved.joints_deg), ("Bin", [9.0; 6]));
    store.delete_position(id, NOW).await.unwrap();
    assert!(store.positions(None).await.unwrap().is_empty());
    let deleted = store.position(id).await.unwrap();
    assert_eq!((deleted.deleted, deleted.name.as_str()), (true, "Bin"));
    let changed = store.change_position(id, Some("X"), None).await;
    assert!(matches!(changed, Err(Error::NotFound { .. })));
    assert!(store.delete_position(id, NOW).await.is_err());
    let reused = store.save_position(id, "left", "Bin", POSE, NOW).await;
    assert!(matches!(reused, Err(Error::IdTaken { .. })));
}
