//! Dynamic time warping with squared Euclidean local cost and the steps (1,1),
//! (1,0), (0,1), all of weight one.
//!
//! The table of costs is filled along its anti-diagonals, whose cells do not depend
//! on each other: with D = i + j, cell (i, j) needs (i, j-1) and (i-1, j) of the
//! diagonal before and (i-1, j-1) of the one before that. Indices i and j count from
//! 1; row and column 0 are the border. Of a warping two bits a cell are kept.

use crate::{
    path::Path,
    vector::{self, Kernel, LANES, multiply_add},
};

/// Cost of the best warping of `a` to `b`: the sum of squared distances along it.
pub fn squared_distance(a: &Path, b: &Path) -> f64 {
    let mut table = Table::new(a, b, 0);
    vector::dispatch(Fill {
        table: &mut table,
        steps: None,
    });
    table.corner()
}

/// The best warping as pairs (index in `a`, index in `b`), both never decreasing.
///
/// Up to `psi` samples at the beginning and the end of either series may stay
/// unmatched at no cost. Equal predecessors are taken in the order diagonal,
/// previous of `a`, previous of `b`.
pub fn warp(a: &Path, b: &Path, psi: usize) -> Vec<(usize, usize)> {
    let mut table = Table::new(a, b, psi);
    let mut steps = Steps::new(a.len(), b.len());
    let (mut i, mut j) = vector::dispatch(Fill {
        table: &mut table,
        steps: Some(&mut steps),
    });
    let mut pairs = Vec::with_capacity(a.len() + b.len());
    while i > 0 && j > 0 {
        pairs.push((i - 1, j - 1));
        match steps.at(i, j) {
            Step::Diagonal => (i, j) = (i - 1, j - 1),
            Step::Up => i -= 1,
            Step::Left => j -= 1,
        }
    }
    pairs.reverse();
    pairs
}

/// Where the best warping to a cell comes from.
enum Step {
    Diagonal,
    Up,
    Left,
}

/// Two series and the costs of three successive diagonals.
struct Table {
    n: usize,
    m: usize,
    psi_a: usize,
    psi_b: usize,
    /// Coordinates of `a`: one sequence each, entry i + LANES for sample i (from 1).
    a: Vec<Vec<f64>>,
    /// Coordinates of `b` backwards: entry m - j + 2 LANES for sample j (from 1).
    b: Vec<Vec<f64>>,
    /// Costs by i + LANES: the present diagonal, the last one and the one before.
    diagonals: [Vec<f64>; 3],
    corner: f64,
}

impl Table {
    fn new(a: &Path, b: &Path, psi: usize) -> Table {
        let (n, m) = (a.len(), b.len());
        let room = n + m + 4 * LANES;
        let mut columns = vec![vec![0.0; room]; a.width()];
        for (i, row) in a.rows().enumerate() {
            for (column, x) in columns.iter_mut().zip(row) {
                column[i + 1 + LANES] = *x;
            }
        }
        let mut backwards = vec![vec![0.0; room + n]; b.width()];
        for (j, row) in b.rows().enumerate() {
            for (column, x) in backwards.iter_mut().zip(row) {
                column[m - 1 - j + n + 2 * LANES] = *x;
            }
        }
        Table {
            n,
            m,
            psi_a: psi.min(n - 1),
            psi_b: psi.min(m - 1),
            a: columns,
            b: backwards,
            diagonals: std::array::from_fn(|_| vec![f64::INFINITY; n + 3 * LANES]),
            corner: f64::INFINITY,
        }
    }

    /// Cost of matching both series to their ends.
    fn corner(&self) -> f64 {
        self.corner
    }
}

/// Steps to all cells, two bits each: for each diagonal the words that cover it, each
/// for [`LANES`] cells: bit l says "up", bit l + 8 "left", neither "diagonal".
struct Steps {
    words: Vec<u16>,
    /// First word of each diagonal, less the number of the word that would cover i = 0.
    begins: Vec<isize>,
    n: usize,
    m: usize,
}

impl Steps {
    fn new(n: usize, m: usize) -> Steps {
        Steps {
            words: Vec::with_capacity((n + LANES) * (m + LANES) / LANES),
            begins: vec![0; n + m + 1],
            n,
            m,
        }
    }

    fn at(&self, i: usize, j: usize) -> Step {
        debug_assert!((1..=self.n).contains(&i) && (1..=self.m).contains(&j));
        let word = self.words[(self.begins[i + j] + (i / LANES) as isize) as usize];
        let lane = i % LANES;
        if word >> lane & 1 == 1 {
            Step::Up
        } else if word >> (lane + LANES) & 1 == 1 {
            Step::Left
        } else {
            Step::Diagonal
        }
    }
}

/// Fills the table; gives the cell in which the best warping ends.
struct Fill<'a> {
    table: &'a mut Table,
    steps: Option<&'a mut Steps>,
}

impl Kernel for Fill<'_> {
    type Output = (usize, usize);

    #[inline(always)]
    fn run<const FUSED: bool>(mut self) -> (usize, usize) {
        let (n, m) = (self.table.n, self.table.m);
        // The first diagonal is the corner of the border alone.
        self.table.diagonals[1][LANES] = 0.0;
        let mut end = Ends::new(n, m);
        for diagonal in 1..=n + m {
            self.fill_diagonal::<FUSED>(diagonal);
            let table = &mut *self.table;
            let present = &mut table.diagonals[0];
            if diagonal <= m {
                present[LANES] = border(diagonal, table.psi_b);
            }
            if diagonal <= n {
                present[LANES + diagonal] = border(diagonal, table.psi_a);
            }
            // The last column of the last rows, then the last row's last columns.
            if diagonal > m && diagonal + table.psi_a >= n + m {
                end.of_a(diagonal - m, present[LANES + diagonal - m]);
            }
            if diagonal > n && diagonal + table.psi_b >= n + m {
                end.of_b(diagonal - n, present[LANES + n]);
            }
            if diagonal == n + m {
                table.corner = present[LANES + n];
            }
            table.diagonals.rotate_right(1);
        }
        end.best()
    }
}

impl Fill<'_> {
    /// Computes all cells of a diagonal, in whole vectors. Lanes beside the table get
    /// some value or other, which no cell of the table ever looks at; the border is
    /// set by the caller.
    #[inline(always)]
    fn fill_diagonal<const FUSED: bool>(&mut self, diagonal: usize) {
        let table = &mut *self.table;
        let [present, last, before] = &mut table.diagonals;
        let low = diagonal.saturating_sub(table.m).max(1) / LANES;
        let high = (diagonal - 1).min(table.n) / LANES;
        if let Some(steps) = self.steps.as_deref_mut() {
            steps.begins[diagonal] = steps.words.len() as isize - low as isize;
        }
        if diagonal < 2 {
            return;
        }
        // Entry of `b` that belongs to i = 0 on this diagonal.
        let shift = table.m + table.n + 2 * LANES - diagonal;
        for word in low..=high {
            let i = word * LANES;
            let mut square = [0.0; LANES];
            for (a, b) in table.a.iter().zip(&table.b) {
                let (a, b) = (eight(a, i + LANES), eight(b, i + shift));
                for lane in 0..LANES {
                    let d = a[lane] - b[lane];
                    square[lane] = multiply_add::<FUSED>(d, d, square[lane]);
                }
            }
            let (left, up) = (eight(last, i + LANES), eight(last, i + LANES - 1));
            let across = eight(before, i + LANES - 1);
            let mut cost = [0.0; LANES];
            let (mut ups, mut lefts) = ([false; LANES], [false; LANES]);
            for lane in 0..LANES {
                ups[lane] = up[lane] < across[lane];
                let best = if ups[lane] { up[lane] } else { across[lane] };
                lefts[lane] = left[lane] < best;
                cost[lane] = square[lane] + if lefts[lane] { left[lane] } else { best };
            }
            present[i + LANES..i + 2 * LANES].copy_from_slice(&cost);
            if let Some(steps) = self.steps.as_deref_mut() {
                let mut bits = 0;
                for lane in 0..LANES {
                    bits |= u16::from(ups[lane] & !lefts[lane]) << lane;
                    bits |= u16::from(lefts[lane]) << (lane + LANES);
                }
                steps.words.push(bits);
            }
        }
    }
}

#[inline(always)]
fn eight(values: &[f64], from: usize) -> [f64; LANES] {
    let mut lanes = [0.0; LANES];
    lanes.copy_from_slice(&values[from..from + LANES]);
    lanes
}

/// The border's cost `steps` from the corner: nothing for the samples that may stay
/// unmatched.
fn border(steps: usize, psi: usize) -> f64 {
    if steps <= psi { 0.0 } else { f64::INFINITY }
}

/// The cheapest cell to end in, of those that leave out the end of `a` or of `b`;
/// the first one of equals, leaving out `a` first.
struct Ends {
    n: usize,
    m: usize,
    a: (f64, usize),
    b: (f64, usize),
}

impl Ends {
    fn new(n: usize, m: usize) -> Ends {
        Ends {
            n,
            m,
            a: (f64::INFINITY, n),
            b: (f64::INFINITY, m),
        }
    }

    fn of_a(&mut self, i: usize, cost: f64) {
        if cost < self.a.0 {
            self.a = (cost, i);
        }
    }

    fn of_b(&mut self, j: usize, cost: f64) {
        if cost < self.b.0 {
            self.b = (cost, j);
        }
    }

    fn best(&self) -> (usize, usize) {
        if self.b.0 < self.a.0 {
            (self.n, self.b.1)
        } else {
            (self.a.1, self.m)
        }
    }
}
