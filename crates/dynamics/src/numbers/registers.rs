//! Registers of the processor, and code compiled for them.
//!
//! Nothing is contracted or reordered for any of them, so every number comes out the same, bit for bit.

use pulp::NullaryFnOnce;

use crate::lanes::Lanes;

/// Registers that code can be compiled for.
pub trait Registers: Copy {
    /// Calls the operation compiled for these registers.
    fn dispatch<Op: NullaryFnOnce>(self, op: Op) -> Op::Output;
}

/// Registers of `N` lanes.
pub trait Transpose<const N: usize>: Registers {
    /// Transposes rows to columns: the numbers of each lane, one after the other.
    fn transposed(self, rows: &[Lanes<N>; N]) -> [[f64; N]; N];

    /// Writes numbers in lanes to one place for each lane.
    #[inline(always)]
    fn deal(self, wide: &[Lanes<N>], places: [&mut [f64]; N]) {
        let places = places.map(|place| place.as_chunks_mut().0);
        for (block, rows) in wide.as_chunks().0.iter().enumerate() {
            let columns = self.transposed(rows);
            for lane in 0..N {
                places[lane][block] = columns[lane];
            }
        }
    }
}

/// Registers of one or two numbers, available on any processor.
#[derive(Debug, Clone, Copy)]
pub struct Baseline;

impl Registers for Baseline {
    #[inline(never)]
    fn dispatch<Op: NullaryFnOnce>(self, op: Op) -> Op::Output {
        op.call()
    }
}

impl Transpose<2> for Baseline {
    #[inline(always)]
    fn transposed(self, rows: &[Lanes<2>; 2]) -> [[f64; 2]; 2] {
        let [a, b] = rows;
        [[a.0[0], b.0[0]], [a.0[1], b.0[1]]]
    }
}

/// Registers for a single landing: of four numbers if available.
#[derive(Debug, Clone, Copy)]
pub enum Single {
    /// Four numbers.
    #[cfg(target_arch = "x86_64")]
    Four(Four),
    /// One or two.
    Baseline,
}

impl Single {
    /// The fastest available.
    pub fn fastest() -> Self {
        #[cfg(target_arch = "x86_64")]
        if let Some(four) = Four::try_new() {
            return Self::Four(four);
        }
        Self::Baseline
    }
}

impl Registers for Single {
    #[inline(always)]
    fn dispatch<Op: NullaryFnOnce>(self, op: Op) -> Op::Output {
        match self {
            #[cfg(target_arch = "x86_64")]
            Self::Four(four) => four.dispatch(op),
            Self::Baseline => Baseline.dispatch(op),
        }
    }
}

/// Registers of four numbers.
#[cfg(target_arch = "x86_64")]
#[derive(Debug, Clone, Copy)]
pub struct Four(pulp::x86::V3);

#[cfg(target_arch = "x86_64")]
impl Four {
    /// Returns them, if available.
    pub fn try_new() -> Option<Self> {
        pulp::x86::V3::try_new().map(Self)
    }
}

#[cfg(target_arch = "x86_64")]
impl Registers for Four {
    #[inline(always)]
    fn dispatch<Op: NullaryFnOnce>(self, op: Op) -> Op::Output {
        self.0.vectorize(op)
    }
}

/// Registers of eight numbers.
#[cfg(target_arch = "x86_64")]
#[derive(Debug, Clone, Copy)]
pub struct Eight(pulp::x86::V4);

#[cfg(target_arch = "x86_64")]
impl Eight {
    /// Returns them, if available.
    pub fn try_new() -> Option<Self> {
        pulp::x86::V4::try_new().map(Self)
    }
}

#[cfg(target_arch = "x86_64")]
impl Registers for Eight {
    #[inline(always)]
    fn dispatch<Op: NullaryFnOnce>(self, op: Op) -> Op::Output {
        self.0.vectorize(op)
    }
}

#[cfg(target_arch = "x86_64")]
impl Transpose<4> for Four {
    #[inline(always)]
    fn transposed(self, rows: &[Lanes<4>; 4]) -> [[f64; 4]; 4] {
        let avx = self.0.avx;
        let [a, b, c, d] = rows.map(|row| pulp::cast(row.0));
        let (ab, cd) = (avx._mm256_unpacklo_pd(a, b), avx._mm256_unpacklo_pd(c, d));
        let (ef, gh) = (avx._mm256_unpackhi_pd(a, b), avx._mm256_unpackhi_pd(c, d));
        [
            pulp::cast(avx._mm256_permute2f128_pd::<0x20>(ab, cd)),
            pulp::cast(avx._mm256_permute2f128_pd::<0x20>(ef, gh)),
            pulp::cast(avx._mm256_permute2f128_pd::<0x31>(ab, cd)),
            pulp::cast(avx._mm256_permute2f128_pd::<0x31>(ef, gh)),
        ]
    }
}

#[cfg(target_arch = "x86_64")]
impl Transpose<8> for Eight {
    #[inline(always)]
    fn transposed(self, rows: &[Lanes<8>; 8]) -> [[f64; 8]; 8] {
        let [a, b, c, d] = self.pairs(&rows[0], &rows[1], &rows[2], &rows[3]);
        let [e, f, g, h] = self.pairs(&rows[4], &rows[5], &rows[6], &rows[7]);
        let ([a, e], [c, g]) = (self.halves(a, e), self.halves(c, g));
        let ([b, f], [d, h]) = (self.halves(b, f), self.halves(d, h));
        [a, b, c, d, e, f, g, h]
    }
}

#[cfg(target_arch = "x86_64")]
type Register = std::arch::x86_64::__m512d;

#[cfg(target_arch = "x86_64")]
impl Eight {
    /// The numbers of lanes 0 and 4, of 1 and 5, of 2 and 6, of 3 and 7 in four rows.
    #[inline(always)]
    fn pairs(self, a: &Lanes<8>, b: &Lanes<8>, c: &Lanes<8>, d: &Lanes<8>) -> [Register; 4] {
        let avx = self.0.avx512f;
        let (a, b): (Register, Register) = (pulp::cast(a.0), pulp::cast(b.0));
        let (c, d): (Register, Register) = (pulp::cast(c.0), pulp::cast(d.0));
        let (even, odd) = (avx._mm512_unpacklo_pd(a, b), avx._mm512_unpackhi_pd(a, b));
        let (next_even, next_odd) = (avx._mm512_unpacklo_pd(c, d), avx._mm512_unpackhi_pd(c, d));
        [
            avx._mm512_shuffle_f64x2::<0x88>(even, next_even),
            avx._mm512_shuffle_f64x2::<0x88>(odd, next_odd),
            avx._mm512_shuffle_f64x2::<0xdd>(even, next_even),
            avx._mm512_shuffle_f64x2::<0xdd>(odd, next_odd),
        ]
    }

    /// Separates the numbers of two lanes, given in four rows and in four more.
    #[inline(always)]
    fn halves(self, a: Register, b: Register) -> [[f64; 8]; 2] {
        let avx = self.0.avx512f;
        // In each, pairs of rows of one lane alternate with those of the other.
        [
            pulp::cast(avx._mm512_shuffle_f64x2::<0x88>(a, b)),
            pulp::cast(avx._mm512_shuffle_f64x2::<0xdd>(a, b)),
        ]
    }
}
