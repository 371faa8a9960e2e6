//! QR with pivots of a triangle whose rank is in question: rank, shortest solution, and what the columns do not reach. Knows no
//! gears.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::householder::{
    apply_block_householder_sequence_transpose_on_the_left_in_place_scratch as apply_scratch,
    apply_block_householder_sequence_transpose_on_the_left_in_place_with_conj as apply_transposed,
};
use faer::linalg::qr::col_pivoting::factor::{qr_in_place, qr_in_place_scratch};
use faer::linalg::qr::no_pivoting::factor::recommended_block_size;
use faer::{Conj, Mat, MatRef, Par};

/// Pivots stay within a factor of some tens of the singular values they stand for; those nearer to the cut than these shares
/// of it leave the rank open.
const DOUBT: [f64; 2] = [1e-2, 1e3];

/// R P = Q [R_1 R_2; 0 0] with the right sides Q^T c.
pub(super) struct Pivoted {
    qr: Mat<f64>,
    rights: Mat<f64>,
    /// Place of every column among the pivots.
    place: Vec<usize>,
    rank: usize,
    settled: bool,
}

impl Pivoted {
    /// Of finite numbers. Pivots below `cut` times the first count as zero.
    pub fn new(matrix: MatRef<'_, f64>, mut rights: Mat<f64>, cut: f64) -> Self {
        let (rows, columns) = (matrix.nrows(), matrix.ncols());
        let size = rows.min(columns);
        let mut qr = matrix.to_owned();
        let (mut order, mut place) = (vec![0usize; columns], vec![0usize; columns]);
        if size == 0 {
            (0..columns).for_each(|j| place[j] = j);
            return Self { qr, rights, place, rank: 0, settled: true };
        }
        let block = recommended_block_size::<f64>(rows, columns);
        let mut factors = Mat::zeros(block, size);
        let scratch = qr_in_place_scratch::<usize, f64>(rows, columns, block, Par::Seq, Default::default());
        let apply = apply_scratch::<f64>(rows, block, rights.ncols());
        let mut memory = MemBuffer::new(scratch.or(apply));
        qr_in_place(
            qr.as_mut(),
            factors.as_mut(),
            &mut order,
            &mut place,
            Par::Seq,
            MemStack::new(&mut memory),
            Default::default(),
        );
        let basis = qr.as_ref().subcols(0, size);
        apply_transposed(
            basis,
            factors.as_ref(),
            Conj::No,
            rights.as_mut(),
            Par::Seq,
            MemStack::new(&mut memory),
        );
        let first = qr[(0, 0)].abs();
        let share = |k: usize| if first > 0.0 { qr[(k, k)].abs() / first } else { 0.0 };
        let rank = (0..size).take_while(|&k| share(k) > cut).count();
        let open = |share: f64| share > DOUBT[0] * cut && share < DOUBT[1] * cut;
        // Pivots need not fall from each to the next.
        let settled = (0..size).all(|k| !open(share(k)) && (share(k) > cut) == (k < rank));
        Self { qr, rights, place, rank, settled }
    }

    /// Number of pivots kept.
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Whether singular values would give the same rank.
    pub fn is_settled(&self) -> bool {
        self.settled
    }

    /// R_1^-1 y.
    fn back(&self, y: &[f64]) -> Vec<f64> {
        let mut y = y[..self.rank].to_vec();
        for j in (0..self.rank).rev() {
            y[j] /= self.qr[(j, j)];
            let (above, value) = (self.qr.col_as_slice(j), y[j]);
            for (y, r) in y[..j].iter_mut().zip(above) {
                *y -= r * value;
            }
        }
        y
    }

    /// The shortest minimiser for the first right side.
    pub fn shortest(&self) -> Vec<f64> {
        let columns = self.qr.ncols();
        let mut x = self.back(self.rights.col_as_slice(0));
        x.resize(columns, 0.0);
        // Directions that R does not see, made orthonormal; what x has of them only makes it longer.
        let mut unseen: Vec<Vec<f64>> = Vec::with_capacity(columns - self.rank);
        for j in self.rank..columns {
            let mut direction = self.back(self.qr.col_as_slice(j));
            direction.resize(columns, 0.0);
            direction[j] = -1.0;
            // Twice is enough (Kahan, Parlett).
            for _ in 0..2 {
                unseen.iter().for_each(|other| remove(&mut direction, other));
            }
            let length = dot(&direction, &direction).sqrt();
            direction.iter_mut().for_each(|d| *d /= length);
            unseen.push(direction);
        }
        unseen.iter().for_each(|direction| remove(&mut x, direction));
        self.place.iter().map(|&place| x[place]).collect()
    }

    /// The part of all right sides that no combination of the columns reaches.
    pub fn unreached(&self) -> MatRef<'_, f64> {
        self.rights.as_ref().subrows(self.rank, self.rights.nrows() - self.rank)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Takes the part along a unit vector out of x.
fn remove(x: &mut [f64], unit: &[f64]) {
    let share = dot(x, unit);
    x.iter_mut().zip(unit).for_each(|(x, u)| *x -= share * u);
}
