//! No datagram, however damaged, makes a reader panic, allocate without bound, or let through what
//! is no number. `cargo bench -p egm --bench fuzz` does the same with ten million.

mod datagrams;
mod run;

use egm::MAX_DATAGRAM_BYTES;

#[test]
fn damaged_datagrams_cost_the_control_loop_nothing_and_the_general_readers_little() {
    let count = 200_000;
    let figures = run::run(count, 1);
    assert_eq!(figures.datagrams, count);
    assert_eq!(figures.reader_allocations, 0);
    assert_eq!(figures.kept_bytes, 0);
    // A list grows to at most twice of what came, and one message is in the making at a time.
    assert!(
        figures.most_bytes <= 4 * MAX_DATAGRAM_BYTES as u64,
        "{figures:?}"
    );
    // The damage is neither so great that nothing is read nor so small that all is.
    for read in [figures.feedback, figures.robot, figures.sensor] {
        assert!((count / 50..count * 9 / 10).contains(&read), "{figures:?}");
    }
}
