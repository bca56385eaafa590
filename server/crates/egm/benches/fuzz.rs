//! Ten million damaged datagrams for every reader: `cargo bench -p egm --bench fuzz`.
//!
//! Prints what was read, what it cost, and how fast it was. `EGM_FUZZ_DATAGRAMS` and
//! `EGM_FUZZ_SEED` change how many there are and which.

use std::time::Instant;

#[path = "../tests/fuzz/datagrams.rs"]
mod datagrams;
#[path = "../tests/fuzz/run.rs"]
mod run;

fn setting(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).map_or(otherwise, |text| {
        text.parse()
            .unwrap_or_else(|_| panic!("{name} is no number: {text}"))
    })
}

fn main() {
    let count = setting("EGM_FUZZ_DATAGRAMS", 10_000_000);
    let seed = setting("EGM_FUZZ_SEED", 1);
    let began = Instant::now();
    let figures = run::run(count, seed);
    let seconds = began.elapsed().as_secs_f64();
    println!(
        "{} datagrams of seed {seed} in {seconds:.1} s",
        figures.datagrams
    );
    println!("read by the control loop's reader: {}", figures.feedback);
    println!("read as a controller's message:    {}", figures.robot);
    println!("read as a server's message:        {}", figures.sensor);
    println!(
        "allocations of the control loop's reader: {}",
        figures.reader_allocations
    );
    println!("most bytes held for one datagram: {}", figures.most_bytes);
    println!("bytes not given back: {}", figures.kept_bytes);
    assert_eq!(
        figures.reader_allocations, 0,
        "the control loop must not allocate"
    );
    assert_eq!(figures.kept_bytes, 0, "nothing may grow");
}
